// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/phrasing/outcomes.h"

#include <algorithm>

namespace goal_alignment::phrasing {

namespace {

std::string limitName(Limit limit) {
  switch (limit) {
    case Limit::Time:
      return "out_of_time";
    case Limit::Memory:
      return "out_of_memory";
    case Limit::Budget:
      break;
  }
  return "out_of_budget";
}

}  // namespace

std::string goalUnsolvable(const Phrases& phrases, const std::vector<Literal>& specified) {
  const std::string what = specified.empty()
                               ? phrases.say("outcome_goal_unnamed")
                               : phrases.say("outcome_goal", {phrases.fewClauses(specified)});
  return what + " " + phrases.say("certain");
}

std::string insteadOf(const Phrases& phrases,
                      const std::vector<std::vector<Literal>>& alternatives) {
  if (alternatives.empty()) return "";
  const std::size_t spoken = std::min(alternatives.size(), kSpokenAlternatives);
  const std::string first = phrases.alternatives(
      {alternatives.begin(), alternatives.begin() + static_cast<std::ptrdiff_t>(spoken)});
  const std::size_t more = alternatives.size() - spoken;
  return first + (more == 0 ? "" : " " + phrases.counted("more_ways", more));
}

std::string expectationUnachievable(const Phrases& phrases, const questions::Reason& reason,
                                    const std::vector<std::vector<Literal>>& alternatives) {
  const std::string instead = insteadOf(phrases, alternatives);
  return phrases.reason(reason.conflict, true, reason.alone) + " " + phrases.say("certain") +
         (instead.empty() ? "" : " " + instead);
}

std::string unsureBlocks(const Phrases& phrases, const questions::Reason& reason,
                         const std::vector<Literal>& deciding,
                         const std::vector<std::vector<Literal>>& alternatives) {
  const std::string instead = insteadOf(phrases, alternatives);
  return phrases.reason(reason.conflict, reason.proven, reason.alone) + " " +
         phrases.say(deciding.size() > 1 ? "depends_on_which" : "depends_on",
                     {phrases.fewClauses(deciding)}) +
         (instead.empty() ? "" : " " + instead);
}

std::string leftOpen(const Phrases& phrases, const std::vector<Literal>& conflict, Limit limit) {
  return phrases.reason(conflict, false) + " " + phrases.say(limitName(limit));
}

std::string leftOpen(const Phrases& phrases, const std::string& where, Limit limit) {
  return phrases.say(limitName(limit) + "_in", {where});
}

std::string planFound(const Phrases& phrases, const std::vector<Literal>& not_promised) {
  std::string plan = phrases.say("outcome_plan");
  if (not_promised.empty()) return plan;
  return plan + " " + phrases.say("outcome_not_promised", {phrases.fewClauses(not_promised)});
}

std::string planMisses(const Phrases& phrases, const std::vector<Literal>& missing, bool has_plan) {
  return phrases.say(has_plan ? "plan_misses" : "plan_missing", {phrases.fewClauses(missing)});
}

std::string supposition(const Phrases& phrases, const std::vector<Literal>& wanted,
                        const std::vector<Literal>& not_wanted) {
  const std::string yes = phrases.thats(wanted);
  const std::string no = phrases.thats(not_wanted);
  if (not_wanted.empty()) {
    return wanted.empty() ? phrases.say("suppose_nothing") : phrases.say("suppose_yes", {yes});
  }
  return wanted.empty() ? phrases.say("suppose_no", {no}) : phrases.say("suppose_both", {yes, no});
}

}  // namespace goal_alignment::phrasing
