// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>
#include <utility>

#include "goal_alignment/questions/answer_effect.h"
#include "implementation.h"

/// What would follow from answers that nobody has given.
namespace goal_alignment::session {

using achievability::CandidateSet;
using achievability::Check;
using achievability::Conflict;
using achievability::Verdict;
using questions::Knowledge;

namespace {

void suppose(const Dialogue& dialogue, const std::vector<Literal>& fluents, Knowledge knowledge,
             const std::vector<Knowledge>& before, std::vector<Knowledge>& then) {
  for (const Literal& fluent : fluents) {
    const auto candidate = dialogue.find(fluent);
    if (!candidate) throw std::invalid_argument(fluent.text() + " is no candidate");
    if (then[*candidate] != before[*candidate] && then[*candidate] != knowledge) {
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

}  // namespace

Consequence Session::Implementation::whatIf(const std::vector<Literal>& wanted,
                                            const std::vector<Literal>& not_wanted,
                                            double seconds) {
  Consequence result;
  questions::Situation then;
  then.knowledge = dialogue_.knowledge();
  suppose(dialogue_, wanted, Knowledge::Wanted, dialogue_.knowledge(), then.knowledge);
  suppose(dialogue_, not_wanted, Knowledge::NotWanted, dialogue_.knowledge(), then.knowledge);
  if (!robot_analysis_.achievability) return result;
  if (state_ == State::Done) cancel_.reset();  // one that came after the outcome

  Limits own = cancelOnly();
  own.bytes = accountable(options_.memory_limit);
  own = own.withSeconds(seconds);
  const CandidateSet must = setOf(then.knowledge, Knowledge::Wanted);
  const Check least = robot().check(must, own);
  if (least.verdict == Verdict::Unachievable) {
    result.kind = Consequence::Kind::NoPlan;
    result.conflict = fluents(robot().smallConflictWithin(must, own)->members);
    return result;
  }
  const Check whole = robot().check(~setOf(then.knowledge, Knowledge::NotWanted), own);
  if (whole.verdict == Verdict::Achievable) {
    result.kind = Consequence::Kind::Plan;
    result.plan = task::names(robot().task(), whole.plan);
  } else if (least.verdict == Verdict::Achievable && whole.verdict == Verdict::Unachievable) {
    result.kind = Consequence::Kind::Questions;
    then.conflicts = robot().conflicts();
    result.max_remaining = mostRemaining(then);
    result.bound_is_provisional = !robot().complete();
    for (const Conflict& conflict : then.conflicts) {
      if (!then.isLive(conflict)) continue;
      result.conflict = fluents(conflict.members);
      break;
    }
  }
  return result;
}

}  // namespace goal_alignment::session
