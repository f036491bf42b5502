// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <chrono>
#include <utility>

#include "goal_alignment/common/exceptions.h"
#include "goal_alignment/questions/grouping.h"
#include "implementation.h"

/// The heart of a session: from what is known to a question or an outcome. A dialogue may end
/// exactly when the fluents answered NO hit every conflict (then everything else has a plan), or a
/// proven conflict lies within the fluents answered YES.
namespace goal_alignment::session {

using achievability::CandidateSet;
using achievability::Check;
using achievability::Conflict;
using achievability::Verdict;
using questions::Knowledge;

questions::Situation Session::Implementation::situation() const {
  return {dialogue_.knowledge(), beliefs_, robot().conflicts()};
}

bool Session::Implementation::anyLive() const {
  const CandidateSet no = dialogue_.with(Knowledge::NotWanted);
  const auto& conflicts = robot().conflicts();
  return std::any_of(conflicts.begin(), conflicts.end(),
                     [&](const Conflict& conflict) { return !conflict.members.intersects(no); });
}

/// Whether the open question can still change the outcome, after what was volunteered.
bool Session::Implementation::openQuestionMatters() const {
  if (!policy_->usesConflicts()) return true;
  const questions::Situation now = situation();
  const questions::AnswerEffect as_it_is = questions::answerEffect(now, {}, Knowledge::Open);
  const auto& reasons = question_->reasons;
  if (as_it_is.ending == questions::AnswerEffect::Ending::Plan) {
    return std::any_of(reasons.begin(), reasons.end(),
                       [](const Reason& reason) { return reason.extra_cost > 0; });
  }
  const auto& waiting = dialogue_.openCandidates();
  const CandidateSet relevantCandidates = now.relevantCandidates();
  return as_it_is.ending == questions::AnswerEffect::Ending::Open &&
         std::any_of(waiting.begin(), waiting.end(),
                     [&](std::size_t f) { return relevantCandidates.test(f); });
}

void Session::Implementation::decide() {
  if (concludeNoPlan()) return;
  // With no conflict left that is not hit, everything not answered NO should have a plan. Where it
  // has none, a conflict comes to light, and the next turn asks inside it.
  while (!anyLive()) {
    if (concludePlan()) return;
    if (concludeNoPlan()) return;
  }
  if (ends_unsure_) return concludeUnsure();
  if (concludeBlocked()) return;
  const auto choices = questions::nextGroup(*policy_, situation(), options_.max_group_size);
  if (!choices.empty()) {
    if (minimiseReasons(choices)) return decide();
    ask(choices);
  } else if (options_.unsure_policy == UnsurePolicy::Defer &&
             dialogue_.reopenUnsure(dialogue_.with(Knowledge::Unsure))) {
    decide();
  } else {
    throw LimitReached(LimitReason::States,
                       "every question is answered, and the rest of the search");
  }
}

/// Nobody is asked about a fluent for the company that it is in; true where that was so.
bool Session::Implementation::minimiseReasons(const std::vector<questions::Choice>& choices) {
  if (!policy_->usesConflicts()) return false;
  std::vector<CandidateSet> reasons;
  for (const questions::Choice& choice : choices) {
    if (!choice.conflict) continue;
    const Conflict& conflict = robot().conflicts()[*choice.conflict];
    if (conflict.proven && !conflict.minimal) reasons.push_back(conflict.members);
  }
  bool any = false;
  for (const CandidateSet& reason : reasons)
    any = robot().smallConflictWithin(reason, limits())->members != reason || any;
  return any;
}

/// Names the conflict that the outcome rests on.
void Session::Implementation::blame(Outcome& outcome, const Conflict& conflict) const {
  outcome.conflict = fluents(conflict.members);
  outcome.conflict_proven = conflict.proven;
  outcome.conflict_minimal = conflict.minimal;
}

bool Session::Implementation::concludeNoPlan() {
  const CandidateSet wanted = dialogue_.with(Knowledge::Wanted);
  if (!robot().complete()) {
    // A conflict nobody knows yet may lie among what is wanted.
    const Check check = robot().check(wanted, limits());
    if (check.limit == LimitReason::Cancelled || check.limit == LimitReason::Time) {
      throw LimitReached(check.limit, "the search for a plan");
    }
    if (check.verdict == Verdict::Unknown) robot().suspect(wanted);
  }
  const Conflict* conflict = robot().provenConflictWithin(wanted);
  if (conflict == nullptr) return false;
  Outcome outcome;
  outcome.code = OutcomeCode::ExpectationUnachievable;
  // The way to the alternatives may bring to light that less than the conflict is one.
  const CandidateSet within = conflict->members;
  outcome.alternatives = alternativesAfter(outcome.code);
  blame(outcome, *robot().smallConflictWithin(within, limits()));
  outcome.message =
      "proven: no plan achieves what was asked for together with " + listed(outcome.conflict);
  finish(std::move(outcome));
  return true;
}

/// Tries to plan for everything not answered NO; false when a conflict was found instead.
bool Session::Implementation::concludePlan() {
  const CandidateSet wished = ~dialogue_.with(Knowledge::NotWanted);
  const Check check = robot().check(wished, limits());
  if (check.verdict == Verdict::Achievable) {
    if (!askAboutCost(wished, check.plan)) conclude(wished, check.plan);
    return true;
  }
  if (check.verdict == Verdict::Unachievable) return false;
  if (check.limit == LimitReason::Cancelled || check.limit == LimitReason::Time ||
      !policy_->usesConflicts()) {
    throw LimitReached(check.limit, "the search for a plan");
  }
  robot().suspect(wished);
  return false;
}

/// Under UnsurePolicy::Abort: what the person is not sure of ends the dialogue.
void Session::Implementation::concludeUnsure() {
  const questions::Situation now = situation();
  const CandidateSet unsure = dialogue_.with(Knowledge::Unsure) - dialogue_.assumed();
  Outcome outcome;
  outcome.code = OutcomeCode::UnsureBlocks;
  CandidateSet deciding = unsure;
  for (const std::size_t f : achievability::members(unsure)) {
    const auto reason = questions::smallestLiveConflict(now, f);
    if (!reason) continue;
    blame(outcome, now.conflicts[*reason]);
    deciding = now.conflicts[*reason].members & unsure;
    break;
  }
  outcome.message =
      "\"don't know\" ends this dialogue undecided; it depends on " + listed(fluents(deciding));
  finish(std::move(outcome));
}

/// A live conflict without open candidates can't be hit any more: no plan will be found.
bool Session::Implementation::concludeBlocked() {
  const questions::Situation now = situation();
  const CandidateSet unsure = dialogue_.with(Knowledge::Unsure);
  for (const Conflict& conflict : now.conflicts) {
    if (!now.isLive(conflict) || now.openMembers(conflict) > 0) continue;
    if (conflict.members.intersects(unsure)) {
      // Those of other conflicts would be asked for nothing.
      if (options_.unsure_policy == UnsurePolicy::Defer &&
          dialogue_.reopenUnsure(conflict.members)) {
        return false;
      }
      const Conflict* small =
          conflict.proven ? robot().smallConflictWithin(conflict.members, limits()) : &conflict;
      if (small->members != conflict.members) {
        decide();
        return true;
      }
      Outcome outcome;
      outcome.code = OutcomeCode::UnsureBlocks;
      blame(outcome, *small);
      outcome.message = (conflict.proven ? "what is wanted can't be had all together"
                                         : "what is wanted may not be had all together") +
                        ("; it depends on " + listed(fluents(conflict.members & unsure)));
      finish(std::move(outcome));
    } else {
      Outcome outcome;
      outcome.code = outcomeOf(robot().lastLimit());
      blame(outcome, conflict);
      outcome.message =
          "I could not find out within the limits whether all this can be had together: " +
          listed(outcome.conflict);
      finish(std::move(outcome));
    }
    return true;
  }
  return false;
}

}  // namespace goal_alignment::session
