// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "goal_alignment/cli/alignment_options.h"
#include "goal_alignment/cli/commands.h"
#include "goal_alignment/cli/instance.h"
#include "goal_alignment/cli/interrupt.h"
#include "goal_alignment/cli/json_output.h"
#include "goal_alignment/common/quote.h"
#include "goal_alignment/pddl/parser.h"
#include "goal_alignment/phrasing/phrases.h"
#include "goal_alignment/phrasing/reply.h"

namespace goal_alignment::cli {

using session::AnswerKind;
using session::QuestionView;
using session::Session;

namespace {

struct AlignArguments {
  std::string folder;
  InstanceFiles files;
  std::string true_goal;
  std::string phrases;
  bool interactive = false;
  bool json = false;
  AlignmentWords words;
};

constexpr std::size_t kLongestEcho = 40;  // bytes

/// Asks on stderr, reads from stdin until the answer is one; nothing at the end of input.
std::optional<phrasing::Reply> askOnTerminal(const QuestionView& question,
                                             const phrasing::Phrases& phrases) {
  const std::size_t count = question.fluents.size();
  std::cerr << '\n'
            << phrasing::questionLine(
                   {question.asked + 1, "", question.max_remaining, question.bound_is_provisional,
                    phrases.question(question.fluents, question.at_end)},
                   phrases)
            << '\n';
  for (std::size_t i = 0; count > 1 && i < count; ++i)
    std::cerr << "  " << i + 1 << ": " << phrases.clause(question.fluents[i]) << '\n';
  const std::string why =
      phrases.why(question.reasons, question.if_yes, question.if_no, question.bound_is_provisional);
  if (!why.empty()) std::cerr << "  " << phrases.say("ask_why", {why}) << '\n';
  const std::string keys = phrasing::replyKeys(count, phrases.frames());
  std::cerr << '[' << keys << "] " << std::flush;
  for (std::string line; std::getline(std::cin, line);) {
    if (auto reply = phrasing::parseReply(line, count, phrases.frames())) return reply;
    std::cerr << phrases.say("ask_again", {shortened(trimmed(line), kLongestEcho), keys}) << ' '
              << std::flush;
  }
  return std::nullopt;
}

phrasing::Phrases readPhrases(const std::string& file) {
  if (file.empty()) return {};
  const pddl::Source source = pddl::readFile(file);
  phrasing::Phrases phrases = phrasing::Phrases::fromYaml(source.text, source.name);
  if (!phrases.warning().empty()) std::cerr << "warning: " << phrases.warning() << '\n';
  return phrases;
}

const char* wordFor(AnswerKind answer) {
  constexpr const char* kWords[] = {"no", "yes", "don't know", "declined"};
  return kWords[static_cast<int>(answer)];
}

class Alignment {
 public:
  explicit Alignment(const AlignArguments& arguments)
      : arguments_(arguments), session_(arguments.words.options()) {}

  int run() {
    InstanceFiles files =
        arguments_.folder.empty() ? arguments_.files : InstanceFiles::of(arguments_.folder);
    if (!arguments_.true_goal.empty()) files.true_goal = arguments_.true_goal;
    if (!arguments_.interactive && !files.true_goal.empty()) oracle_.emplace(files.true_goal);
    phrases_ = readPhrases(arguments_.phrases.empty() ? files.phrases : arguments_.phrases);
    session_.begin(readInput(files));
    const InterruptGuard guard(session_);
    while (session_.step() != session::State::Done) {
      if (session_.state() == session::State::AwaitingAnswer) answer();
    }
    report();
    return session::exitStatus(session_.outcome().code);
  }

 private:
  void answer() {
    const QuestionView question = *session_.question();  // a copy, since an answer may end it
    if (oracle_) {
      for (const Literal& fluent : question.fluents)
        session_.answer({fluent}, oracle_->answer(fluent), "true goal");
      return;
    }
    std::optional<phrasing::Reply> reply;
    if (arguments_.interactive) reply = askOnTerminal(question, phrases_);
    if (reply) {
      pass(*reply, question.fluents);
    } else if (session_.step() != session::State::Done) {  // Ctrl-C ends the read, too
      session_.answerTimedOut("there is nobody to answer whether " +
                              session_.spelling(question.fluents.front()) + " matters");
    }
  }

  void pass(const phrasing::Reply& reply, const std::vector<Literal>& fluents) {
    const auto kind = static_cast<AnswerKind>(reply.kind);
    if (reply.chosen.empty()) {
      session_.answer(fluents, kind, "terminal");
      return;
    }
    for (std::size_t i = 0; i < fluents.size(); ++i) {
      const bool chosen = std::count(reply.chosen.begin(), reply.chosen.end(), i) > 0;
      session_.answer({fluents[i]}, chosen ? AnswerKind::Yes : AnswerKind::No, "terminal");
    }
  }

  void report() const {
    if (arguments_.json) {
      std::cout << toJson(session_).dump(2) << '\n';
      return;
    }
    for (const session::QuestionRecord& record : session_.questions()) {
      for (std::size_t i = 0; i < record.fluents.size(); ++i) {
        std::cout << "; asked " << session_.spelling(record.fluents[i]) << ": "
                  << wordFor(record.answers[i]) << '\n';
      }
    }
    const session::Outcome& outcome = session_.outcome();
    std::cout << "; " << session::outcomeWord(outcome.code) << ": " << outcome.message << '\n';
    for (const session::Alternative& alternative : outcome.alternatives) {
      std::cout << "; can do everything except";
      for (const Literal& fluent : alternative.given_up)
        std::cout << ' ' << session_.spelling(fluent);
      std::cout << '\n';
    }
    for (const GroundName& step : outcome.plan.steps)
      std::cout << step.text() << '\n';
  }

  const AlignArguments& arguments_;
  Session session_;
  phrasing::Phrases phrases_;
  std::optional<ScriptedOracle> oracle_;
};

void requireFiles(const AlignArguments& arguments) {
  const InstanceFiles& files = arguments.files;
  const bool any = !files.robot_domain.empty() || !files.robot_problem.empty() ||
                   !files.human_domain.empty() || !files.human_problem.empty() ||
                   !files.human_plan.empty();
  const bool all = !files.robot_domain.empty() && !files.robot_problem.empty() &&
                   !files.human_domain.empty() && !files.human_problem.empty() &&
                   !files.human_plan.empty();
  if (arguments.folder.empty() != all || (any && !all)) {
    throw CLI::ValidationError(
        "align",
        "give either an instance folder or all of --robot-domain, --robot-problem, "
        "--human-domain, --human-problem and --human-plan");
  }
}

}  // namespace

void addAlignCommand(CLI::App& app, Run& run) {
  auto arguments = std::make_shared<AlignArguments>();
  CLI::App* command = app.add_subcommand("align", "find the true goal and plan for it");
  command->add_option("DIR", arguments->folder, "instance folder");
  command->add_option("--robot-domain", arguments->files.robot_domain);
  command->add_option("--robot-problem", arguments->files.robot_problem);
  command->add_option("--human-domain", arguments->files.human_domain);
  command->add_option("--human-problem", arguments->files.human_problem);
  command->add_option("--human-plan", arguments->files.human_plan);
  auto* true_goal =
      command->add_option("--true-goal", arguments->true_goal, "answers the questions");
  command->add_flag("--interactive", arguments->interactive, "you answer")->excludes(true_goal);
  command->add_option("--phrases", arguments->phrases,
                      "YAML templates in which questions are put; DIR's phrases.yaml else");
  command->add_option("--policy", arguments->words.policy,
                      "auto, optimal, ratio, paper or ask-all");
  arguments->words.add(*command);
  command->add_flag("--json", arguments->json);
  command->callback([arguments, &run] {
    requireFiles(*arguments);
    run = [arguments] { return Alignment(*arguments).run(); };
  });
}

}  // namespace goal_alignment::cli
