// SPDX-License-Identifier: BSD-3-Clause
#include "achievability/goal_set_knowledge.h"

#include <gtest/gtest.h>

#include <vector>

#include "goal_alignment/grounding/grounder.h"
#include "goal_alignment/pddl/model.h"

namespace goal_alignment::achievability {
namespace {

const char* const kDomain = R"((define (domain lamps)
  (:predicates (lit ?x) (dark ?x))
  (:action light :parameters (?x) :precondition (dark ?x)
    :effect (and (lit ?x) (not (dark ?x))))))";
const char* const kProblem = R"((define (problem p) (:domain lamps) (:objects a b c d)
  (:init (dark a) (dark b) (dark c) (dark d)) (:goal (and))))";

/// Four lamps to light, of which the first is asked for: three candidates without a conflict.
class GoalSetKnowledgeTest : public testing::Test {
 protected:
  CandidateSet set(std::uint64_t bits) const { return CandidateSet(3, bits); }
  std::size_t unexploredSets() { return knowledge_.unexplored(100, {}).sets.size(); }

  const pddl::Model model_ = pddl::readModel({"domain.pddl", kDomain}, {"problem.pddl", kProblem});
  const std::vector<Literal> specified_ = {Literal::parse("(lit a)")};
  const std::vector<Literal> candidates_ = {Literal::parse("(lit b)"), Literal::parse("(lit c)"),
                                            Literal::parse("(lit d)")};
  const GoalSetTask task_{
      grounding::ground(model_, {specified_[0], candidates_[0], candidates_[1], candidates_[2]}, {},
                        {}),
      specified_, candidates_, Limits{}};
  GoalSetKnowledge knowledge_{task_};

  task::Plan plan(const std::vector<std::string>& steps) const {
    task::Plan result;
    for (const std::string& step : steps) {
      for (task::OperatorId op = 0; op < task_.task().operators.size(); ++op) {
        if (task_.task().operators[op].name.text() == step) result.push_back(op);
      }
    }
    return result;
  }
};

TEST_F(GoalSetKnowledgeTest, BeginsWithNothing) {
  EXPECT_EQ(knowledge_.recall(set(0)), std::nullopt);
  EXPECT_EQ(knowledge_.recallAlone(0), std::nullopt);
  EXPECT_TRUE(knowledge_.conflicts().empty());
  EXPECT_FALSE(knowledge_.complete());
  EXPECT_FALSE(knowledge_.allReached());
}

TEST_F(GoalSetKnowledgeTest, APlanTeachesItsStates) {
  knowledge_.learnPlan(plan({"(light b)", "(light a)", "(light c)"}));
  ASSERT_EQ(knowledge_.achieved().size(), 1U);  // {b} is within {b, c}
  EXPECT_EQ(knowledge_.achieved().front().set, set(0b011));
  EXPECT_EQ(knowledge_.recall(set(0b010))->verdict, Verdict::Achievable);
  EXPECT_EQ(knowledge_.recall(set(0b010))->plan.size(), 3U);
  EXPECT_EQ(knowledge_.recall(set(0b100)), std::nullopt);
  EXPECT_TRUE(knowledge_.hasPlanFor(set(0b011)));
  EXPECT_EQ(knowledge_.recallAlone(1), Verdict::Achievable);
}

TEST_F(GoalSetKnowledgeTest, WithoutTheSpecifiedGoalAStateIsReachedButNotAchieved) {
  knowledge_.learnPlan(plan({"(light b)"}));
  EXPECT_TRUE(knowledge_.achieved().empty());
  EXPECT_EQ(knowledge_.recallAlone(0), Verdict::Achievable);
}

TEST_F(GoalSetKnowledgeTest, WhereAllIsAchievedNothingIsLeftToLearn) {
  knowledge_.learnPlan(plan({"(light a)", "(light b)", "(light c)", "(light d)"}));
  EXPECT_TRUE(knowledge_.complete());
  EXPECT_TRUE(knowledge_.allReached());
}

TEST_F(GoalSetKnowledgeTest, ConflictsAnswerForTheirSupersetsSuspicionsDoNot) {
  knowledge_.learnConflict({set(0b011), true, false});
  knowledge_.suspect(set(0b100));
  EXPECT_EQ(knowledge_.recall(set(0b111))->verdict, Verdict::Unachievable);
  EXPECT_NE(knowledge_.provenConflictWithin(set(0b011)), nullptr);
  EXPECT_EQ(knowledge_.recall(set(0b100)), std::nullopt);
  EXPECT_EQ(knowledge_.conflicts().size(), 2U);
}

TEST_F(GoalSetKnowledgeTest, NeverTrueSettlesACandidateAlone) {
  knowledge_.learnNeverTrue(2);
  EXPECT_EQ(knowledge_.recallAlone(2), Verdict::Unachievable);
  knowledge_.learnReached(set(0b001));
  EXPECT_EQ(knowledge_.recallAlone(0), Verdict::Achievable);
}

TEST_F(GoalSetKnowledgeTest, UnexploredIsWhatNothingKnownSettles) {
  EXPECT_EQ(unexploredSets(), 1U);  // all
  knowledge_.learnConflict({set(0b011), true, false});
  EXPECT_EQ(unexploredSets(), 2U);  // {b, d}, {c, d}
  knowledge_.learnPlan(plan({"(light a)", "(light b)", "(light d)"}));
  EXPECT_EQ(unexploredSets(), 1U);
  knowledge_.suspect(set(0b110));
  EXPECT_EQ(unexploredSets(), 1U);  // {c}
  EXPECT_EQ(knowledge_.unexplored(1, {}).sets.front(), set(0b010));
  // A suspicion that a plan refutes no longer hides what contains it.
  knowledge_.learnPlan(plan({"(light a)", "(light c)", "(light d)"}));
  EXPECT_EQ(unexploredSets(), 0U);
  EXPECT_EQ(knowledge_.conflicts().size(), 1U);
}

TEST_F(GoalSetKnowledgeTest, ManyAchievedSetsAtOnceClearSuspicions) {
  knowledge_.suspect(set(0b100));
  EXPECT_EQ(unexploredSets(), 1U);
  knowledge_.learnAchieved({{set(0b101), {}}, {set(0b110), {}}});
  EXPECT_TRUE(knowledge_.conflicts().empty());
  EXPECT_EQ(unexploredSets(), 1U);
  EXPECT_FALSE(knowledge_.complete());
  knowledge_.learnAchieved({{set(0b111), {}}});
  EXPECT_TRUE(knowledge_.complete());
}

TEST_F(GoalSetKnowledgeTest, AllConflictsReplaceSuspicions) {
  knowledge_.suspect(set(0b001));
  knowledge_.learnAllConflicts({set(0b011)});
  ASSERT_EQ(knowledge_.conflicts().size(), 1U);
  EXPECT_TRUE(knowledge_.conflicts().front().proven && knowledge_.conflicts().front().minimal);
}

TEST_F(GoalSetKnowledgeTest, IsCompleteWhereAllIsExploredAndNothingSuspected) {
  knowledge_.learnConflict({set(0b011), true, false});
  knowledge_.concludeEnumeration(false);
  EXPECT_FALSE(knowledge_.complete());
  EXPECT_FALSE(knowledge_.conflicts().front().minimal);
  knowledge_.suspect(set(0b100));
  knowledge_.concludeEnumeration(true);
  EXPECT_FALSE(knowledge_.complete());
  knowledge_.learnPlan(plan({"(light a)", "(light d)"}));
  knowledge_.concludeEnumeration(true);
  EXPECT_TRUE(knowledge_.complete());
  EXPECT_TRUE(knowledge_.conflicts().front().minimal);
}

}  // namespace
}  // namespace goal_alignment::achievability
