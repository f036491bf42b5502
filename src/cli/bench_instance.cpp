// SPDX-License-Identifier: BSD-3-Clause
#include "bench_instance.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>

#include "goal_alignment/cli/instance.h"
#include "goal_alignment/common/exceptions.h"
#include "goal_alignment/pddl/exceptions.h"

namespace goal_alignment::cli {

using session::OutcomeCode;

namespace {

constexpr const char* kReference = "optimal";

bool isFault(OutcomeCode code) {
  if (code == OutcomeCode::None) return false;  // there is something to ask
  const session::OutcomeKind kind = session::outcomeTraits(code).kind;
  return kind == session::OutcomeKind::Invalid || kind == session::OutcomeKind::Internal;
}

class InstanceBench {
 public:
  InstanceBench(const InstanceFolder& instance, const BenchPlan& plan, RunningSessions& sessions,
                const std::function<void(std::size_t)>& count)
      : instance_(instance), plan_(plan), sessions_(sessions), count_(count) {}

  InstanceResult measure() {
    if (sessions_.cancelled()) return {};
    try {
      files_ = InstanceFiles::of(instance_.path);
      input_ = readInput(files_);
      analysis_ = analyse(input_, optionsOf("auto"), sessions_);
    } catch (const Exception& exception) {
      analysis_.outcome.code = OutcomeCode::InvalidModel;
      analysis_.outcome.message = exception.what();
    }
    for (const Truth& truth : plan_.truths) {
      if (sessions_.cancelled()) break;
      if (isFault(analysis_.outcome.code))
        fail(truth, analysis_.outcome.message);
      else if (!truth.wanted && files_.true_goal.empty() && plan_.truths.size() > 1)
        skip();
      else
        measure(truth);
    }
    return std::move(result_);
  }

 private:
  session::Options optionsOf(const std::string& policy) const {
    AlignmentWords words = plan_.words;
    words.policy = policy;
    words.threads = 1;  // instances run side by side instead
    return words.options();
  }

  void skip() {
    result_.note = instance_.name + ": no true_goal.txt, so under the drawn truths only";
    count_(plan_.runsOfTruth());
  }

  void fail(const Truth& truth, const std::string& why) {
    count_(plan_.runsOfTruth());
    for (const std::string& policy : plan_.policies) {
      result_.rows.push_back(rowOf(policy, truth));
      result_.rows.back().error = why;
    }
  }

  Row rowOf(const std::string& policy, const Truth& truth) const {
    Row row;
    row.instance = instance_.name;
    row.policy = policy;
    row.truth = truth.name;
    return row;
  }

  void measure(const Truth& truth) {
    std::optional<ScriptedOracle> own;
    try {
      if (!truth.wanted && files_.true_goal.empty()) return fail(truth, "no true_goal.txt");
      if (!truth.wanted) own.emplace(files_.true_goal);
    } catch (const Exception& exception) {
      return fail(truth, exception.what());
    }
    const auto wants = [&](std::uint64_t seed) {
      if (truth.wanted) return drawnTruth(*truth.wanted, instance_.name, seed);
      return Wants([&own](const Literal& fluent) {
        return own->answer(fluent) == session::AnswerKind::Yes;
      });
    };
    std::map<std::string, Row> rows;
    for (const std::string& policy : plan_.running()) {
      Row row = rowOf(policy, truth);
      session::Options options = optionsOf(policy);
      for (int i = 0; i < plan_.runs; ++i, ++options.seed) {
        const Wants wanted = wants(options.seed);
        const RunFigures run = alignOnce(input_, options, wanted, sessions_);
        if (run.outcome == OutcomeCode::Canceled || sessions_.cancelled()) return keep(rows);
        row.add(run);
        if (analysis_.conflicts_known)
          row.minimum.add(static_cast<double>(analysis_.minimum(wanted)));
        count_(1);
      }
      rows.emplace(policy, std::move(row));
    }
    keep(rows);
  }

  void keep(const std::map<std::string, Row>& rows) {
    const auto optimal = rows.find(kReference);
    for (const std::string& policy : plan_.policies) {
      const auto row = rows.find(policy);
      if (row == rows.end()) continue;
      result_.rows.push_back(row->second);
      if (optimal != rows.end()) result_.rows.back().of_optimal = optimal->second.questions.mean();
    }
  }

  const InstanceFolder& instance_;
  const BenchPlan& plan_;
  RunningSessions& sessions_;
  const std::function<void(std::size_t)>& count_;
  InstanceFiles files_;
  session::Input input_;
  Analysis analysis_;
  InstanceResult result_;
};

}  // namespace

std::vector<std::string> BenchPlan::running() const {
  std::vector<std::string> names = {kReference};
  for (const std::string& policy : policies)
    if (policy != kReference) names.push_back(policy);
  return names;
}

std::size_t BenchPlan::runsOfTruth() const {
  return running().size() * static_cast<std::size_t>(runs);
}

std::vector<InstanceFolder> instancesBelow(const std::string& root) {
  namespace fs = std::filesystem;
  std::error_code error;
  if (!fs::is_directory(root, error))
    throw pddl::InputError(root, {}, "expected a folder of instance folders");
  const fs::path base = fs::canonical(root);
  std::vector<InstanceFolder> instances;
  std::map<std::string, int> names;
  for (const fs::path& folder : instanceFoldersBelow(root)) {
    instances.push_back({folder.string(), fs::canonical(folder).filename().string()});
    ++names[instances.back().name];
  }
  if (instances.empty()) throw pddl::InputError(root, {}, "no instance folder in here");
  for (InstanceFolder& instance : instances)
    if (names[instance.name] > 1)
      instance.name = fs::canonical(instance.path).lexically_relative(base).generic_string();
  return instances;
}

InstanceResult measureInstance(const InstanceFolder& instance, const BenchPlan& plan,
                               RunningSessions& sessions,
                               const std::function<void(std::size_t)>& count) {
  return InstanceBench(instance, plan, sessions, count).measure();
}

}  // namespace goal_alignment::cli
