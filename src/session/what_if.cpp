// SPDX-License-Identifier: BSD-3-Clause
#include "what_if.h"

#include <stdexcept>

#include "fluents.h"
#include "open_question.h"

namespace goal_alignment::session {

using achievability::CandidateSet;
using achievability::Check;
using achievability::Conflict;
using achievability::Verdict;
using questions::Knowledge;

namespace {

void supposeEach(const Dialogue& dialogue, const std::vector<Literal>& fluents, Knowledge knowledge,
                 std::vector<Knowledge>& then) {
  for (const Literal& fluent : fluents) {
    const auto candidate = dialogue.find(fluent);
    if (!candidate) throw std::invalid_argument(fluent.text() + " is no candidate");
    if (then[*candidate] != dialogue.knowledge()[*candidate] && then[*candidate] != knowledge) {
      throw std::invalid_argument(fluent.text() + " can't be both wanted and not wanted");
    }
    then[*candidate] = knowledge;
  }
}

CandidateSet setOf(const std::vector<Knowledge>& knowledge, Knowledge kind) {
  CandidateSet set(knowledge.size());
  for (std::size_t f = 0; f < knowledge.size(); ++f)
    set.set(f, knowledge[f] == kind);
  return set;
}

Consequence moreQuestions(const std::vector<Knowledge>& then, const Analysis& analysis,
                          const Options& options) {
  const questions::Situation situation = analysis.situation(then);
  Consequence result;
  result.kind = Consequence::Kind::Questions;
  result.max_remaining = maxRemaining(analysis, situation, options);
  result.bound_is_provisional = !analysis.robot().complete();
  for (const Conflict& conflict : situation.conflicts) {
    if (!situation.isLive(conflict)) continue;
    result.conflict = fluentsOf(analysis.problem(), conflict.members);
    break;
  }
  return result;
}

}  // namespace

std::vector<Knowledge> suppose(const Dialogue& dialogue, const std::vector<Literal>& wanted,
                               const std::vector<Literal>& not_wanted) {
  std::vector<Knowledge> then = dialogue.knowledge();
  supposeEach(dialogue, wanted, Knowledge::Wanted, then);
  supposeEach(dialogue, not_wanted, Knowledge::NotWanted, then);
  return then;
}

Consequence consequenceOf(const std::vector<Knowledge>& then, Analysis& analysis,
                          const Options& options, double seconds) {
  achievability::Achievability& robot = analysis.robot();
  const Limits own = analysis.budget().limitsFor(seconds);
  const CandidateSet must = setOf(then, Knowledge::Wanted);
  Consequence result;
  const Check least = robot.check(must, own);
  if (least.verdict == Verdict::Unachievable) {
    result.kind = Consequence::Kind::NoPlan;
    result.conflict = fluentsOf(analysis.problem(), robot.smallConflictWithin(must, own)->members);
    return result;
  }
  const Check whole = robot.check(~setOf(then, Knowledge::NotWanted), own);
  if (whole.verdict == Verdict::Achievable) {
    result.kind = Consequence::Kind::Plan;
    result.plan = task::names(robot.task(), whole.plan);
  } else if (least.verdict == Verdict::Achievable && whole.verdict == Verdict::Unachievable) {
    return moreQuestions(then, analysis, options);
  }
  return result;
}

}  // namespace goal_alignment::session
