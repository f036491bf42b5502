// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/questions/answer_effect.h"

#include "goal_alignment/questions/policy.h"

namespace goal_alignment::questions {

using achievability::CandidateSet;
using achievability::Conflict;
using Ending = AnswerEffect::Ending;

namespace {

Ending endingOf(const Situation& situation) {
  Ending ending = Ending::Plan;
  for (const Conflict& conflict : situation.conflicts) {
    if (!situation.isLive(conflict)) continue;
    if (ending == Ending::Plan) ending = Ending::Open;
    if (situation.openMembers(conflict) > 0) continue;
    bool all_wanted = true;
    for (const std::size_t f : achievability::members(conflict.members))
      all_wanted = all_wanted && situation.knowledge[f] == Knowledge::Wanted;
    if (conflict.proven && all_wanted) return Ending::NoPlan;
    ending = Ending::Undecided;
  }
  return ending;
}

}  // namespace

AnswerEffect answerEffect(const Situation& situation, const std::vector<std::size_t>& candidates,
                          Knowledge answer) {
  CandidateSet before = situation.relevantCandidates();
  Situation then = situation;
  for (const std::size_t f : candidates) {
    then.knowledge[f] = answer;
    before.reset(f);
  }
  AnswerEffect result;
  result.ending = endingOf(then);
  if (result.ending == Ending::Open) result.left = then.relevantCandidates().count();
  result.settled = before.count() - result.left;
  return result;
}

}  // namespace goal_alignment::questions
