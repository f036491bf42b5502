// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/cli/alignment_options.h"

#include <iostream>
#include <limits>
#include <map>
#include <set>

#include "goal_alignment/common/listed.h"
#include "goal_alignment/questions/policy.h"

namespace goal_alignment::cli {

namespace {

/// The entry of a small table of words; the error lists them.
template <typename Value>
Value lookUp(const std::map<std::string, Value>& words, const std::string& word,
             const std::string& option) {
  const auto found = words.find(word);
  if (found != words.end()) return found->second;
  const std::string known = listed(words, [](const auto& entry) { return entry.first; });
  throw CLI::ValidationError(option, "expected one of " + known + ", found '" + word + "'");
}

void requirePolicy(const std::string& policy) {
  std::map<std::string, bool> known;
  for (const std::string& name : questions::policyNames())
    known.emplace(name, true);
  lookUp(known, policy, "--policy");
}

alignment::BeliefOptions beliefOptions(const AlignmentWords& words) {
  alignment::BeliefOptions belief;
  belief.beta = words.beta;
  belief.kappa = words.kappa;
  if (words.belief.rfind("flat:", 0) == 0) {
    belief.mode = alignment::BeliefMode::Flat;
    if (!CLI::detail::lexical_cast(words.belief.substr(5), belief.flat)) {
      throw CLI::ValidationError("--belief",
                                 "expected a number after flat:, found '" + words.belief + "'");
    }
    return belief;
  }
  belief.mode = lookUp<alignment::BeliefMode>({{"normalised", alignment::BeliefMode::Normalised},
                                               {"raw", alignment::BeliefMode::Raw},
                                               {"flat:P", alignment::BeliefMode::Flat}},
                                              words.belief, "--belief");
  return belief;
}

/// Takes the option's values under its former name too, with a warning, until the next release.
void addFormerName(CLI::App& command, const std::string& former, const std::string& name,
                   std::vector<std::string>& values) {
  const auto take = [former, name, &values](const std::vector<std::string>& given) {
    std::cerr << "hagl: " << former << " is now called " << name << "; the name " << former
              << " will be removed in the next release\n";
    values.insert(values.end(), given.begin(), given.end());
  };
  command.add_option_function<std::vector<std::string>>(former, take)->group("");
}

}  // namespace

void AlignmentWords::add(CLI::App& command) {
  command.add_option("--seed", seed, "breaks ties");
  command.add_option("--belief", belief, "normalised, raw or flat:P");
  command.add_option("--beta", beta, "rationality of the human");
  command.add_option("--kappa", kappa, "how many goals are expected to be missing");
  command.add_option("--conflicts", conflicts, "full or lazy");
  command.add_option("--group", group, "fluents a question may offer");
  command.add_option("--unsure-policy", unsure_policy, "as-yes, defer or abort");
  command.add_flag("--negative-candidates", negative_candidates, "ask about side effects, too");
  command.add_option("--assumed-wanted", assumed_wanted,
                     "predicate nobody is asked about, assumed to be wanted; may be repeated");
  command.add_option("--assumed-unwanted", assumed_unwanted, "the same, assumed not to be wanted");
  addFormerName(command, "--hidden-wanted", "--assumed-wanted", assumed_wanted);
  addFormerName(command, "--hidden-not-wanted", "--assumed-unwanted", assumed_unwanted);
  command.add_option("--max-extra-cost", max_extra_cost,
                     "ask about what would cost more than this to keep");
  command.add_flag("--costs", costs, "use :action-costs where both models have them");
  command.add_flag("--no-static", no_static, "paper, ask-all: leave static fluents out");
  command.add_option("--plan", plan, "first, optimal or anytime");
  command.add_option("--time-limit", time_limit, "seconds of thinking");
  command.add_option("--memory-limit", memory_limit_mib, "MiB");
  command.add_option("--threads", threads, "planner threads");
}

session::Options AlignmentWords::options() const {
  if (group < 1) throw CLI::ValidationError("--group", "expected 1 or more");
  if (threads < 1) throw CLI::ValidationError("--threads", "expected 1 or more");
  if (time_limit < 0) throw CLI::ValidationError("--time-limit", "expected seconds, 0 for none");
  requirePolicy(policy);
  session::Options options;
  options.policy = policy;
  options.seed = seed;
  options.belief = beliefOptions(*this);
  options.conflicts = lookUp<session::ConflictMode>(
      {{"full", session::ConflictMode::Full}, {"lazy", session::ConflictMode::Lazy}}, conflicts,
      "--conflicts");
  options.unsure_policy = lookUp<session::UnsurePolicy>({{"as-yes", session::UnsurePolicy::AsYes},
                                                         {"defer", session::UnsurePolicy::Defer},
                                                         {"abort", session::UnsurePolicy::Abort}},
                                                        unsure_policy, "--unsure-policy");
  options.plan = lookUp<session::PlanMode>({{"first", session::PlanMode::First},
                                            {"optimal", session::PlanMode::Optimal},
                                            {"anytime", session::PlanMode::Anytime}},
                                           plan, "--plan");
  options.threads = threads;
  options.max_group_size = static_cast<std::size_t>(group);
  options.negative_candidates = negative_candidates;
  options.assumed_wanted_predicates = assumed_wanted;
  options.assumed_unwanted_predicates = assumed_unwanted;
  options.max_extra_cost = max_extra_cost;
  options.costs = costs;
  options.static_candidates = !no_static;
  if (time_limit > 0) options.time_limit = time_limit;
  options.memory_limit = memory_limit_mib << 20U;
  return options;
}

}  // namespace goal_alignment::cli
