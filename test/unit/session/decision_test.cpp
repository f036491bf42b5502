// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "analysed_desk.h"
#include "goal_alignment/session/session.h"
#include "goal_alignment/validation/execution.h"
#include "oracles/algorithm_one.h"
#include "oracles/lifted_space.h"
#include "oracles/random_hagl.h"
#include "oracles/seeds.h"
#include "samples.h"
#include "session/decision.h"

/// Whole dialogues on random problems, compared with what enumeration says.
namespace goal_alignment::session {
namespace {

using oracles::CandidateBits;
using oracles::Hagl;
using samples::code;
using samples::expectedCode;
using samples::honest;
using samples::options;
using samples::talk;

std::vector<Options> allModes(std::uint64_t seed) {
  std::vector<Options> modes;
  for (const std::string& policy : questions::policyNames()) {
    for (const ConflictMode conflicts : {ConflictMode::Full, ConflictMode::Lazy}) {
      modes.push_back(options(policy, conflicts, seed));
    }
  }
  return modes;
}

std::vector<Literal> sorted(std::vector<Literal> literals) {
  std::sort(literals.begin(), literals.end());
  return literals;
}

std::vector<Literal> answered(const Session& session, AnswerKind kind) {
  return sorted(samples::answered(session, kind));
}

void requireGoodPlan(const Hagl& hagl, const Session& session) {
  const FinalPlan& plan = session.outcome().plan;
  const std::vector<Literal> goal(hagl.true_goal.begin(), hagl.true_goal.end());
  RC_ASSERT(!validation::fault(hagl.robot, plan.steps, goal).has_value());
  RC_ASSERT(!validation::fault(hagl.robot, plan.steps, plan.kept_unasked).has_value());
  // What was promised is the specified goal and the YES; the rest is kept or was not wanted.
  std::vector<Literal> promised = hagl.specified;
  const std::vector<Literal> yes = answered(session, AnswerKind::Yes);
  promised.insert(promised.end(), yes.begin(), yes.end());
  RC_ASSERT(sorted(plan.guaranteed) == sorted(promised));
  RC_ASSERT(sorted(plan.not_wanted) == answered(session, AnswerKind::No));
  RC_ASSERT(yes.size() + plan.kept_unasked.size() + plan.not_wanted.size() == hagl.size());
  RC_ASSERT(plan.cost == static_cast<std::int64_t>(plan.steps.size()));
}

void requireGoodRefusal(const Hagl& hagl, const Session& session, bool conflicts_complete) {
  const Outcome& outcome = session.outcome();
  const CandidateBits conflict = hagl.bits(outcome.conflict);
  RC_ASSERT(hagl.minimalConflicts().count(conflict) > 0);
  RC_ASSERT(outcome.conflict_proven && outcome.conflict_minimal);
  RC_ASSERT((conflict & ~hagl.bits(answered(session, AnswerKind::Yes))) == 0U);
  for (const Alternative& alternative : outcome.alternatives) {
    const CandidateBits given_up = hagl.bits(alternative.given_up);
    RC_ASSERT((given_up & ~hagl.wanted()) == 0U);
    RC_ASSERT(alternative.probability >= 0 && alternative.probability <= 1);
    if (conflicts_complete) {
      RC_ASSERT(hagl.achievable(hagl.bits(answered(session, AnswerKind::Yes)) & ~given_up));
    }
  }
  if (conflicts_complete) {
    RC_ASSERT(!outcome.alternatives.empty());
  }
}

void requireRightEnds(const Hagl& hagl, std::uint64_t seed) {
  RC_LOG() << samples::text(hagl);
  for (const Options& mode : allModes(seed)) {
    Session session(mode);
    session.begin(hagl.input);
    const std::vector<Literal> asked = talk(session, honest(hagl));
    RC_LOG() << mode.policy << ": " << session.outcome().message << "\n";
    RC_ASSERT(code(session) == expectedCode(hagl));
    if (code(session) == 1) requireGoodPlan(hagl, session);
    if (code(session) == 52) {
      requireGoodRefusal(hagl, session, session.snapshot().conflicts_complete);
    }
    RC_ASSERT(std::set<Literal>(asked.begin(), asked.end()).size() == asked.size());
    RC_ASSERT(session.questions().size() == asked.size());
    for (const Literal& fluent : asked) {
      RC_ASSERT(std::count(hagl.candidates.begin(), hagl.candidates.end(), fluent) == 1);
    }
  }
}

/// Five problems a case: 500 in the usual run.
RC_GTEST_PROP(Decision, EveryPolicyEndsAsBruteForceSays, ()) {
  RandomSource random = oracles::anySource();
  for (int i = 0; i < 5; ++i) {
    const Hagl hagl = oracles::randomHagl(random);
    requireRightEnds(hagl, random.below(1000));
  }
}

void requireLiveReasons(const Hagl& hagl, const Options& mode) {
  RC_LOG() << mode.policy << "\n";
  Session session(mode);
  session.begin(hagl.input);
  CandidateBits no = 0;
  while (samples::think(session) == State::AwaitingAnswer) {
    const QuestionView& question = *session.question();
    const Literal fluent = question.fluents.front();
    const CandidateBits conflict = hagl.bits(question.reasons.front().conflict);
    RC_ASSERT((conflict & hagl.bits({fluent})) != 0U);
    RC_ASSERT((conflict & no) == 0U);  // it is live
    RC_ASSERT(question.reasons.front().proven);
    RC_ASSERT(hagl.minimalConflicts().count(conflict) > 0);
    if (mode.conflicts == ConflictMode::Full) RC_ASSERT(!question.bound_is_provisional);
    if (!hagl.wants(fluent)) no |= hagl.bits({fluent});
    session.answer({fluent}, honest(hagl)(fluent), "person");
  }
  RC_ASSERT(code(session) == expectedCode(hagl));
}

RC_GTEST_PROP(Decision, AsksOnlyInsideLiveConflicts, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomDisputedHagl(random);
  RC_LOG() << samples::text(hagl);
  for (const Options& mode : allModes(random.below(1000)))
    if (mode.policy != "paper" && mode.policy != "ask-all") requireLiveReasons(hagl, mode);
}

/// What the outcome says of its conflict is so.
void requireHonestConflict(const Hagl& hagl, const Outcome& outcome) {
  const bool has_one = !outcome.conflict.empty() || outcome.code == OutcomeCode::GoalUnsolvable;
  if (!has_one) RC_ASSERT(!outcome.conflict_proven && !outcome.conflict_minimal);
  const CandidateBits conflict = hagl.bits(outcome.conflict);
  if (outcome.conflict_proven) RC_ASSERT(!hagl.achievable(conflict));
  if (outcome.conflict_minimal) RC_ASSERT(hagl.minimalConflicts().count(conflict) > 0);
  if (outcome.code == OutcomeCode::GoalUnsolvable ||
      outcome.code == OutcomeCode::ExpectationUnachievable)
    RC_ASSERT(outcome.conflict_proven);
}

// With "don't know" among the answers and memory that may not suffice for a proof.
RC_GTEST_PROP(Decision, AConflictIsProvenAndMinimalWhereItSaysSo, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomHagl(random);
  RC_LOG() << samples::text(hagl);
  const double unsure = oracles::chance(random, 0.5) ? 0 : 0.4;
  for (Options mode : allModes(random.below(1000))) {
    const bool plenty = oracles::chance(random, 0.5);
    if (!plenty) mode.memory_limit = 10'000 + random.below(300'000);
    Session session(mode);
    session.begin(hagl.input);
    talk(session, [&](const Literal& fluent) {
      return oracles::chance(random, unsure) ? AnswerKind::Unsure : honest(hagl)(fluent);
    });
    RC_LOG() << mode.policy << ": " << session.outcome().message << "\n";
    requireHonestConflict(hagl, session.outcome());
    if (plenty && !session.outcome().conflict.empty())
      RC_ASSERT(session.outcome().conflict_proven && session.outcome().conflict_minimal);
  }
}

RC_GTEST_PROP(Decision, NeverAsksMoreThanItAnnounced, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomDisputedHagl(random);
  for (const Options& mode : allModes(random.below(1000))) {
    Session session(mode);
    session.begin(hagl.input);
    std::size_t bound = hagl.size();
    while (samples::think(session) == State::AwaitingAnswer) {
      const QuestionView& question = *session.question();
      RC_ASSERT(question.asked == session.questions().size());
      RC_ASSERT(question.max_remaining >= 1U);
      if (!question.bound_is_provisional) {
        RC_ASSERT(question.asked + question.max_remaining <= bound);
        bound = question.asked + question.max_remaining;
      }
      const Literal fluent = question.fluents.front();
      session.answer({fluent}, honest(hagl)(fluent), "person");
    }
    RC_ASSERT(session.questions().size() <= bound);
  }
}

std::vector<std::size_t> indices(const Hagl& hagl, const std::vector<Literal>& fluents) {
  std::vector<std::size_t> result;
  for (const Literal& fluent : fluents) {
    const auto at = std::find(hagl.candidates.begin(), hagl.candidates.end(), fluent);
    result.push_back(static_cast<std::size_t>(at - hagl.candidates.begin()));
  }
  return result;
}

// Algorithm 1 is deterministic once its queue is ordered: with the order in which the session asked
// (the fluents never asked behind them) it must ask exactly as many and end the same way.
RC_GTEST_PROP(Decision, PaperReplaysAlgorithmOne, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomHagl(random);
  RC_LOG() << samples::text(hagl);
  Session session(options("paper", ConflictMode::Full, random.below(1000)));
  session.begin(hagl.input);
  const std::vector<std::size_t> asked = indices(hagl, talk(session, honest(hagl)));
  std::vector<std::size_t> queue = asked;
  for (std::size_t f = 0; f < hagl.size(); ++f) {
    if (std::count(asked.begin(), asked.end(), f) == 0) queue.push_back(f);
  }
  const oracles::AlgorithmOneRun expected = oracles::algorithmOne(hagl, queue);
  RC_ASSERT(asked == expected.questions);
  RC_ASSERT((code(session) == 1) == expected.plan_found);

  std::vector<bool> unachievable;
  for (std::size_t f = 0; f < hagl.size(); ++f)
    unachievable.push_back(!hagl.achievableAlone(f));
  const std::vector<double> value =
      oracles::valueOfQuery(oracles::normalisedBeliefs(hagl.costDifferences(), 1), unachievable);
  for (std::size_t i = 1; i < queue.size() && i <= asked.size(); ++i) {
    if (i < asked.size()) RC_ASSERT(value[queue[i - 1]] > value[queue[i]] - 1e-8);
  }
  for (std::size_t i = asked.size(); i < queue.size() && !asked.empty(); ++i) {
    RC_ASSERT(value[asked.back()] > value[queue[i]] - 1e-8);
  }
}

RC_GTEST_PROP(Decision, OptimalPlansAreTheCheapestForAllThatIsKept, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomHagl(random);
  Options chosen = options("auto");
  chosen.plan = PlanMode::Optimal;
  chosen.costs = oracles::chance(random, 0.5);
  Session session(chosen);
  session.begin(hagl.input);
  talk(session, honest(hagl));
  RC_PRE(code(session) == 1);
  const FinalPlan& plan = session.outcome().plan;
  RC_ASSERT(plan.optimal);
  std::vector<Literal> goal = plan.guaranteed;
  goal.insert(goal.end(), plan.kept_unasked.begin(), plan.kept_unasked.end());
  const bool unit_costs = !(chosen.costs && hagl.robot.has_costs && hagl.human.has_costs);
  RC_ASSERT(plan.cost == oracles::LiftedSpace(hagl.robot, 10'000, unit_costs).cheapest(goal));
}

RC_GTEST_PROP(Decision, ReplaysASeed, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomDisputedHagl(random);
  for (const Options& mode : allModes(random.below(1000))) {
    Session first(mode);
    first.begin(hagl.input);
    Session second(mode);
    second.begin(hagl.input);
    RC_ASSERT(talk(first, honest(hagl)) == talk(second, honest(hagl)));
    RC_ASSERT(first.outcome().plan.steps == second.outcome().plan.steps);
  }
}

RC_GTEST_PROP(Decision, AQuestionLimitEndsUndecidedOrInTime, ()) {
  RandomSource random = oracles::anySource();
  const Hagl hagl = oracles::randomDisputedHagl(random);
  for (Options mode : allModes(0)) {
    mode.max_questions = static_cast<int>(random.below(4));
    Session session(mode);
    session.begin(hagl.input);
    const std::size_t asked = talk(session, honest(hagl)).size();
    RC_ASSERT(asked <= static_cast<std::size_t>(mode.max_questions));
    if (code(session) == 62) {
      RC_ASSERT(asked == static_cast<std::size_t>(mode.max_questions));
    } else {
      RC_ASSERT(code(session) == expectedCode(hagl));
    }
  }
}

using samples::AnalysedDesk;

Decision decide(AnalysedDesk& at, bool ends_unsure = false) {
  return session::decide(at.dialogue, at.analysis, at.options, ends_unsure);
}

TEST(Decide, AsksWhileAnswersMatter) {
  AnalysedDesk at;
  EXPECT_FALSE(decideWithoutAnswers(at.analysis, at.options).has_value());
  const Decision decision = decide(at);
  ASSERT_TRUE(std::holds_alternative<Ask>(decision));
  const Dialogue::AskedCandidate& posed = std::get<Ask>(decision).posed.front();
  EXPECT_EQ(at.dialogue.fluents()[posed.candidate], samples::literal("(held b)"));
  EXPECT_EQ(posed.reason.conflict, samples::literals({"(held b)"}));
  EXPECT_FALSE(at.dialogue.isOpen()) << "to decide is not to ask";
}

TEST(Decide, PlansWhereEveryConflictIsHit) {
  AnalysedDesk at;
  at.answer({"(held a)", "(held b)"}, AnswerKind::No);
  const Decision decision = decide(at);
  ASSERT_TRUE(std::holds_alternative<PlanFor>(decision));
  EXPECT_EQ(std::get<PlanFor>(decision).achieved, ~at.setOf({"(held a)", "(held b)"}));
}

TEST(Decide, ProvesThatThereIsNoPlanForWhatIsWanted) {
  AnalysedDesk at;
  at.answer({"(held a)", "(free)"}, AnswerKind::Yes);
  const Decision decision = decide(at);
  ASSERT_TRUE(std::holds_alternative<NoPlan>(decision));
  EXPECT_EQ(std::get<NoPlan>(decision).conflict, at.setOf({"(free)", "(held a)"}));
}

TEST(Decide, IsBlockedByWhatNobodyKnows) {
  AnalysedDesk at;
  at.answer({"(held b)"}, AnswerKind::Unsure);
  const Decision decision = decide(at);
  ASSERT_TRUE(std::holds_alternative<Blocked>(decision));
  EXPECT_EQ(std::get<Blocked>(decision).unsure, at.setOf({"(held b)"}));
  EXPECT_FALSE(std::get<Blocked>(decision).at_once);
}

TEST(Decide, EndsAtOnceWhereDontKnowIsToEndIt) {
  AnalysedDesk at;
  at.answer({"(free)"}, AnswerKind::Unsure);
  const Decision decision = decide(at, true);
  ASSERT_TRUE(std::holds_alternative<Blocked>(decision));
  EXPECT_EQ(std::get<Blocked>(decision).unsure, at.setOf({"(free)"}));
  EXPECT_TRUE(std::get<Blocked>(decision).at_once);
  EXPECT_TRUE(std::get<Blocked>(decision).conflict.has_value());
}

TEST(Decide, ReopensOnceWhatIsDeferred) {
  Options defer;
  defer.unsure_policy = UnsurePolicy::Defer;
  AnalysedDesk at(defer);
  at.answer({"(held b)"}, AnswerKind::Unsure);
  const Decision decision = decide(at);
  ASSERT_TRUE(std::holds_alternative<Reopen>(decision));
  EXPECT_EQ(std::get<Reopen>(decision).candidates, at.setOf({"(held b)"}));
  EXPECT_TRUE(std::get<Reopen>(decision).then_ask);
  at.dialogue.reopen(std::get<Reopen>(decision).candidates);
  EXPECT_TRUE(std::holds_alternative<Ask>(nextQuestion(at.dialogue, at.analysis, at.options)));
  at.answer({"(held b)"}, AnswerKind::Unsure);
  EXPECT_TRUE(std::holds_alternative<Blocked>(decide(at)));
}

}  // namespace
}  // namespace goal_alignment::session
