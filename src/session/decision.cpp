// SPDX-License-Identifier: BSD-3-Clause
#include "decision.h"

#include <algorithm>

#include "extra_cost.h"
#include "fluents.h"
#include "goal_alignment/common/exceptions.h"
#include "goal_alignment/questions/grouping.h"
#include "open_question.h"

namespace goal_alignment::session {

using achievability::CandidateSet;
using achievability::Check;
using achievability::Conflict;
using achievability::Verdict;
using questions::Knowledge;
using questions::Situation;

namespace {

/// Our own budgets leave a set open; a cancel or the time limit ends the work.
bool isInterruption(LimitReason limit) {
  return limit == LimitReason::Cancelled || limit == LimitReason::Time;
}

/// One decision: what it is made from, and its stages in their order. A stage that gives nothing
/// leaves the decision to the next one.
class Decider {
 public:
  Decider(const Dialogue& dialogue, Analysis& analysis, const Options& options)
      : dialogue_(dialogue), analysis_(analysis), options_(options) {}

  Decision decide(bool ends_unsure) {
    if (auto no_plan = noPlan()) return *no_plan;
    // With no conflict left that is not hit, everything not answered NO should have a plan. Where
    // it has none, a conflict comes to light, and the next turn asks inside it.
    while (!anyLive(dialogue_, analysis_)) {
      if (auto plan = planOrCostQuestion()) return std::move(*plan);
      if (auto no_plan = noPlan()) return *no_plan;
    }
    if (ends_unsure) return blockedAtOnce(dialogue_, analysis_);
    if (auto ending = blocked()) return std::move(*ending);
    return nextQuestion();
  }

  Decision nextQuestion() {
    const auto choices =
        questions::nextGroup(analysis_.policy(), situation(), options_.max_group_size);
    if (choices.empty()) return nothingLeftToAsk();
    if (minimiseReasons(choices)) return decide(false);
    Ask question;
    for (const questions::Choice& choice : choices)
      question.posed.push_back({choice.candidate, reasonFor(analysis_, choice.conflict)});
    return question;
  }

 private:
  achievability::Achievability& robot() { return analysis_.robot(); }
  Limits limits() const { return analysis_.budget().limits(); }
  Situation situation() const { return analysis_.situation(dialogue_.knowledge()); }
  bool defers() const { return options_.unsure_policy == UnsurePolicy::Defer; }

  std::optional<NoPlan> noPlan();
  std::optional<Decision> planOrCostQuestion();
  std::optional<Ask> costQuestion(const CandidateSet& wished, const task::Plan& plan);
  std::optional<Decision> blocked();
  std::optional<Decision> blockedBy(const Conflict& conflict);
  Decision nothingLeftToAsk() const;
  bool minimiseReasons(const std::vector<questions::Choice>& choices);

  const Dialogue& dialogue_;
  Analysis& analysis_;
  const Options& options_;
};

std::optional<NoPlan> Decider::noPlan() {
  const CandidateSet wanted = dialogue_.with(Knowledge::Wanted);
  if (!robot().complete()) {
    // A conflict nobody knows yet may lie among what is wanted.
    const Check check = robot().check(wanted, limits());
    if (isInterruption(check.limit)) throw LimitReached(check.limit, "the search for a plan");
    if (check.verdict == Verdict::Unknown) robot().suspect(wanted);
  }
  const Conflict* conflict = robot().provenConflictWithin(wanted);
  if (conflict == nullptr) return std::nullopt;
  return NoPlan{conflict->members};
}

/// Tries to plan for everything not answered NO; nothing where a conflict was found instead.
std::optional<Decision> Decider::planOrCostQuestion() {
  const CandidateSet wished = ~dialogue_.with(Knowledge::NotWanted);
  Check check = robot().check(wished, limits());
  if (check.verdict == Verdict::Achievable) {
    if (auto question = costQuestion(wished, check.plan)) return std::move(*question);
    return PlanFor{wished, std::move(check.plan)};
  }
  if (check.verdict == Verdict::Unachievable) return std::nullopt;
  if (isInterruption(check.limit) || !analysis_.policy().usesConflicts())
    throw LimitReached(check.limit, "the search for a plan");
  robot().suspect(wished);
  return std::nullopt;
}

/// About a candidate that nobody asked for and that costs more than is let pass.
std::optional<Ask> Decider::costQuestion(const CandidateSet& wished, const task::Plan& plan) {
  if (!costsMatter(options_)) return std::nullopt;
  const CandidateSet kept = dialogue_.with(Knowledge::Wanted) | dialogue_.with(Knowledge::Unsure);
  const CandidateSet open = wished & dialogue_.with(Knowledge::Open);
  Ask question{tooCostly(analysis_, kept, open, plan, options_.max_extra_cost, 1)};
  if (question.posed.empty()) return std::nullopt;
  return question;
}

/// A live conflict without open candidates can't be hit any more: no plan will be found.
std::optional<Decision> Decider::blocked() {
  const Situation now = situation();
  for (const Conflict& conflict : now.conflicts) {
    if (now.isLive(conflict) && now.openMembers(conflict) == 0) return blockedBy(conflict);
  }
  return std::nullopt;
}

std::optional<Decision> Decider::blockedBy(const Conflict& conflict) {
  const CandidateSet unsure = conflict.members & dialogue_.with(Knowledge::Unsure);
  if (unsure.none()) {
    const std::string what =
        listed(analysis_.problem(), fluentsOf(analysis_.problem(), conflict.members));
    return Exhausted{
        robot().lastLimit(),
        "I could not find out within the limits whether all this can be had together: " + what,
        conflict};
  }
  // Those of other conflicts would be asked for nothing.
  const CandidateSet once_more = conflict.members & dialogue_.reopenable();
  if (defers() && once_more.any()) return Reopen{once_more, true};
  const Conflict small =
      conflict.proven ? *robot().smallConflictWithin(conflict.members, limits()) : conflict;
  if (small.members != conflict.members) return decide(false);
  return Blocked{small, unsure};
}

Decision Decider::nothingLeftToAsk() const {
  const CandidateSet once_more = dialogue_.reopenable();
  if (defers() && once_more.any()) return Reopen{once_more, false};
  const LimitReached why(LimitReason::States,
                         "every question is answered, and the rest of the search");
  return Exhausted{why.reason(), why.what(), std::nullopt};
}

/// Nobody is asked about a fluent for the company that it is in; true where that was so.
bool Decider::minimiseReasons(const std::vector<questions::Choice>& choices) {
  if (!analysis_.policy().usesConflicts()) return false;
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

}  // namespace

std::optional<Decision> decideWithoutAnswers(Analysis& analysis, const Options& options) {
  achievability::Achievability& robot = analysis.robot();
  const CandidateSet none(robot.candidateCount());
  Check whole = robot.check(~none, analysis.budget().limits());
  if (whole.verdict == Verdict::Achievable) {
    // It may cost more than the person would let pass for what nobody asked for.
    if (costsMatter(options)) return std::nullopt;
    return PlanFor{~none, std::move(whole.plan)};
  }
  if (isInterruption(whole.limit)) throw LimitReached(whole.limit, "the search for a plan");
  const Check specified = robot.check(none, analysis.budget().limits());
  if (specified.verdict == Verdict::Unachievable)
    return GoalUnsolvable{*robot.provenConflictWithin(none)};
  if (specified.verdict == Verdict::Unknown) {
    return Exhausted{
        specified.limit,
        "the limits did not suffice to find out whether the specified goal can be achieved",
        std::nullopt};
  }
  if (whole.verdict == Verdict::Unknown) robot.suspect(~none);
  return std::nullopt;
}

Decision decide(const Dialogue& dialogue, Analysis& analysis, const Options& options,
                bool ends_unsure) {
  return Decider(dialogue, analysis, options).decide(ends_unsure);
}

Decision nextQuestion(const Dialogue& dialogue, Analysis& analysis, const Options& options) {
  return Decider(dialogue, analysis, options).nextQuestion();
}

Blocked blockedAtOnce(const Dialogue& dialogue, const Analysis& analysis) {
  const Situation now = analysis.situation(dialogue.knowledge());
  const CandidateSet unsure = dialogue.with(Knowledge::Unsure) - dialogue.assumed();
  for (const std::size_t f : achievability::members(unsure)) {
    const auto reason = questions::smallestLiveConflict(now, f);
    if (!reason) continue;
    const Conflict& conflict = now.conflicts[*reason];
    return {conflict, conflict.members & unsure, true};
  }
  return {std::nullopt, unsure, true};
}

bool anyLive(const Dialogue& dialogue, const Analysis& analysis) {
  const CandidateSet no = dialogue.with(Knowledge::NotWanted);
  const auto& conflicts = analysis.robot().conflicts();
  return std::any_of(conflicts.begin(), conflicts.end(),
                     [&](const Conflict& conflict) { return !conflict.members.intersects(no); });
}

}  // namespace goal_alignment::session
