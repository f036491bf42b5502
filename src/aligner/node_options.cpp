// SPDX-License-Identifier: BSD-3-Clause
#include "node_options.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <vector>

#include "goal_alignment/questions/policy.h"

namespace goal_alignment::aligner {
namespace {

constexpr std::size_t kMebibyte = std::size_t{1} << 20U;
constexpr int kIntMax = std::numeric_limits<int>::max();
constexpr double kDefaultTimeLimit = 300;      // seconds
constexpr int kDefaultMemoryLimit = 2048;      // MiB
constexpr double kLongestAskTimeout = 604800;  // a week
constexpr double kLongestTimeLimit = 86400;
constexpr double kLongestExpiry = 31536000;  // a year
constexpr int kMaxRetries = 1000;
constexpr int kMaxThreads = 256;
constexpr int kLargestGroup = 255;  // as Align's max_group_size can say
constexpr double kNoLimit = -1;
constexpr double kLargestCost = 1e9;

void readBelief(ros_common::ParameterReader& reader, alignment::BeliefOptions& belief) {
  std::string mode = "normalised";
  reader.read("belief", mode);
  const std::string flat = "flat:";
  if (mode == "normalised") {
    belief.mode = alignment::BeliefMode::Normalised;
  } else if (mode == "raw") {
    belief.mode = alignment::BeliefMode::Raw;
  } else if (mode.rfind(flat, 0) == 0) {
    belief.mode = alignment::BeliefMode::Flat;
    std::size_t end = 0;
    const std::string number = mode.substr(flat.size());
    try {
      belief.flat = std::stod(number, &end);
    } catch (const std::logic_error&) {
      end = std::string::npos;
    }
    if (end != number.size() || !(belief.flat >= 0 && belief.flat <= 1)) {
      reader.refuse("belief", "flat:P with a probability P from 0 to 1");
    }
  } else {
    reader.refuse("belief", "one of normalised, raw, flat:P");
  }
  reader.read("beta", belief.beta, 0, 1000);
  reader.read("kappa", belief.kappa, 0.001, 1000);
}

void readHidden(ros_common::ParameterReader& reader, session::Options& options) {
  reader.renamed("hidden_wanted", "assumed_wanted_predicates");
  reader.renamed("hidden_not_wanted", "assumed_unwanted_predicates");
  reader.read("assumed_wanted_predicates", options.assumed_wanted_predicates);
  reader.read("assumed_unwanted_predicates", options.assumed_unwanted_predicates);
  const auto& wanted = options.assumed_wanted_predicates;
  for (const std::string& name : options.assumed_unwanted_predicates) {
    if (std::find(wanted.begin(), wanted.end(), name) == wanted.end()) continue;
    reader.refuse("assumed_unwanted_predicates",
                  "other names than assumed_wanted_predicates has, not '" + name + "'");
  }
}

void readSession(ros_common::ParameterReader& reader, session::Options& options) {
  const std::vector<std::string> policies = questions::policyNames();
  const auto usual = std::find(policies.begin(), policies.end(), options.policy);
  options.policy = policies.at(
      reader.readChoice("policy", policies, static_cast<std::size_t>(usual - policies.begin())));
  int seed = 0;
  reader.read("seed", seed, 0, kIntMax);
  options.seed = static_cast<std::uint64_t>(seed);
  readBelief(reader, options.belief);
  const bool full = reader.readChoice("conflicts", {"lazy", "full"}, 0) == 1;
  options.conflicts = full ? session::ConflictMode::Full : session::ConflictMode::Lazy;
  options.unsure_policy = static_cast<session::UnsurePolicy>(
      reader.readChoice("unsure_policy", {"as-yes", "defer", "abort"}, 0));
  options.plan =
      static_cast<session::PlanMode>(reader.readChoice("plan", {"first", "optimal", "anytime"}, 0));
  reader.read("threads", options.threads, 1, kMaxThreads);
  reader.read("costs", options.costs);
  reader.read("static_candidates", options.static_candidates);
  reader.read("time_limit", options.time_limit, 0.01, kLongestTimeLimit);
  int mebibytes = kDefaultMemoryLimit;
  reader.read("memory_limit", mebibytes, 16, 1 << 20);
  options.memory_limit = static_cast<std::size_t>(mebibytes) * kMebibyte;
  reader.read("max_questions", options.max_questions, -1, kIntMax);
  int group = 1;
  reader.read("max_group_size", group, 1, kLargestGroup);
  options.max_group_size = static_cast<std::size_t>(group);
  reader.read("negative_candidates", options.negative_candidates);
  readHidden(reader, options);
  double extra_cost = kNoLimit;
  reader.read("max_extra_cost", extra_cost, kNoLimit, kLargestCost);
  if (extra_cost < 0 && extra_cost != kNoLimit) reader.refuse("max_extra_cost", "0 or more, or -1");
  if (extra_cost >= 0) options.max_extra_cost = extra_cost;
}

}  // namespace

NodeOptions::NodeOptions() {
  session.conflicts = session::ConflictMode::Lazy;
  session.time_limit = kDefaultTimeLimit;
  session.memory_limit = kDefaultMemoryLimit * kMebibyte;
}

NodeOptions NodeOptions::read(const XmlRpc::XmlRpcValue& values, const std::string& ns) {
  NodeOptions options;
  ros_common::ParameterReader reader(values, ns);
  reader.read("robot_domain", options.robot_domain);
  reader.read("robot_problem", options.robot_problem);
  reader.read("human_domain", options.human_domain);
  reader.read("human_problem", options.human_problem);
  reader.read("phrases", options.phrases);
  readSession(reader, options.session);
  reader.read("ask_timeout", options.ask_timeout, 0, kLongestAskTimeout);
  reader.read("ask_retries", options.ask_retries, 0, kMaxRetries);
  reader.read("journal_expiry", options.journal_expiry, 0, kLongestExpiry);
  options.busy_policy =
      static_cast<BusyPolicy>(reader.readChoice("busy_policy", {"wait", "refuse"}, 0));
  reader.read("human_state_follows", options.human_state_follows);
  reader.read("facts_expiry", options.facts_expiry, 0, kLongestExpiry);
  reader.read("world", options.world);
  reader.read("tf_facts", options.tf_facts);
  reader.renamed("tf_patience", "tf_timeout");
  reader.read("tf_timeout", options.tf_timeout, 0, 3600);
  reader.read("tf_period", options.tf_period, 0.01, 60);
  reader.read("diagnostic_period", options.diagnostic_period, 0.01, 3600);
  reader.read("markers", options.markers);
  reader.read("marker_frames", options.marker_frames);
  options.warnings = reader.warnings();
  return options;
}

NodeOptions NodeOptions::read(const ros::NodeHandle& private_node) {
  XmlRpc::XmlRpcValue values;
  private_node.getParam(private_node.getNamespace(), values);
  return read(values, private_node.getNamespace());
}

}  // namespace goal_alignment::aligner
