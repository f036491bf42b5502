// SPDX-License-Identifier: BSD-3-Clause
// What is asked: several fluents at once, nothing about what is hidden, side effects, what keeping
// things costs. And what becomes of a question when people say more, or less, than they were asked.
#include <std_msgs/String.h>

#include <cstdio>

#include "aligner_calls.h"

namespace goal_alignment::test {
namespace {

constexpr int kNo = Answer::Request::NO;
constexpr int kYes = Answer::Request::YES;

using Texts = std::vector<std::string>;

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// The other lamp of the pair.
std::string partnerOf(const std::string& lamp) {
  std::string partner = lamp;
  char& number = partner.at(partner.find_first_of("12"));
  number = number == '1' ? '2' : '1';
  return partner;
}

class Questions : public Scenario {
 protected:
  Questions() : events_(node_, "/goal_alignment/events") {}

  void SetUp() override {
    Scenario::SetUp();
    ASSERT_TRUE(eventually([this] { return events_.isHeard(); }));
  }

  // A question about one lamp of each pair: where a no is the likelier answer, the first lamp of a
  // pair is likely to settle the other.
  Question askAboutLamps() {
    const Parameter groups("max_group_size", 2);
    const Parameter belief("belief", "flat:0.2");
    const Question question = sendAndAwaitQuestion(lightLamps());
    EXPECT_EQ(question.fluents.size(), 2U);
    EXPECT_EQ(question.probabilities, (std::vector<double>{0.2, 0.2}));
    EXPECT_TRUE(contains(question.text, "hich of these matter to you")) << question.text;
    return question;
  }

  AlignResult expectEnd(int outcome) {
    AlignResult result = awaitResult();
    EXPECT_EQ(result.outcome, outcome) << result.message;
    return result;
  }

  static Candidate candidateOf(const AlignResult& result, const std::string& text) {
    for (const Candidate& candidate : result.candidates) {
      if (textOf(candidate.fluent) == text) return candidate;
    }
    ADD_FAILURE() << text << " is no candidate";
    return {};
  }

  static void expectAnswered(const AlignResult& result, const std::string& text, int state) {
    const Candidate candidate = candidateOf(result, text);
    EXPECT_EQ(int{candidate.state}, state) << text;
    EXPECT_EQ(candidate.answered_by, "test") << text;
    EXPECT_FALSE(candidate.answered_at.isZero()) << text;
  }

  bool tells(const std::string& part) {
    return events_.waitFor([&](const std_msgs::String& line) { return contains(line.data, part); })
        .has_value();
  }

  Topic<std_msgs::String> events_;
};

TEST_F(Questions, ofAGroupThoseNamedMatterAndTheOthersDoNot) {
  const Question group = askAboutLamps();
  const std::string first = textOf(group.fluents[0]);
  const std::string second = textOf(group.fluents[1]);
  EXPECT_TRUE(answer(kYes, group.question_id, {first}).accepted);
  const Question next = awaitQuestionAfter(group.question_id);
  EXPECT_EQ(textsOf(next.fluents), Texts{partnerOf(first)});
  EXPECT_EQ(next.asked, 1U);
  EXPECT_FALSE(answer(kYes, 0, {second}).accepted) << "it is answered";
  EXPECT_TRUE(answer(kNo, next.question_id).accepted);
  const AlignResult result = expectEnd(AlignResult::SUCCESS);
  EXPECT_EQ(result.questions, 2U);
  expectAnswered(result, first, Candidate::WANTED);
  expectAnswered(result, second, Candidate::NOT_WANTED);
  EXPECT_EQ(int{candidateOf(result, partnerOf(second)).state}, Candidate::SETTLED);
}

TEST_F(Questions, ofAGroupYesTypedWithRosserviceMeansAllOfThem) {
  const Question group = askAboutLamps();
  FILE* pipe = popen("timeout 20 rosservice call /goal_alignment/answer '{answer: yes}' 2>&1", "r");
  ASSERT_NE(pipe, nullptr);
  char said[256] = {};
  EXPECT_GT(fread(said, 1, sizeof said - 1, pipe), 0U);
  pclose(pipe);
  EXPECT_TRUE(contains(said, "accepted: True")) << said;
  const Question next = awaitQuestionAfter(group.question_id);
  for (const Fluent& fluent : group.fluents) {
    EXPECT_FALSE(answer(kNo, 0, {textOf(fluent)}).accepted) << "it is answered";
  }
  EXPECT_TRUE(answer(kYes, next.question_id).accepted);
  const AlignResult result = expectEnd(AlignResult::EXPECTATION_UNACHIEVABLE);
  for (const Fluent& fluent : group.fluents)
    EXPECT_EQ(int{candidateOf(result, textOf(fluent)).state}, Candidate::WANTED);
}

TEST_F(Questions, aVolunteeredAnswerToOneOfAGroupLeavesTheOthersOpen) {
  const Question group = askAboutLamps();
  const std::string first = textOf(group.fluents[0]);
  const std::string second = textOf(group.fluents[1]);
  EXPECT_TRUE(answer(kYes, 0, {first}).accepted);
  // What is shown from now on is what is left of it.
  EXPECT_TRUE(questions_.waitFor([&](const Question& shown) {
    return shown.question_id == group.question_id && textsOf(shown.fluents) == Texts{second} &&
           contains(shown.text, "oes it matter to you");
  }));
  EXPECT_EQ(explain({second}).conflicts.size(), 1U);
  EXPECT_TRUE(contains(answer(kYes, group.question_id, {first}).message, "answered already"));
  EXPECT_TRUE(answer(kYes, group.question_id).accepted) << "it is still open";
  const Question next = awaitQuestionAfter(group.question_id);
  Texts partners = {partnerOf(first), partnerOf(second)};
  std::sort(partners.begin(), partners.end());
  EXPECT_EQ(textsOf(next.fluents), partners);
  EXPECT_TRUE(answer(kNo, next.question_id).accepted);
  const AlignResult result = expectEnd(AlignResult::SUCCESS);
  expectAnswered(result, first, Candidate::WANTED);
  expectAnswered(result, second, Candidate::WANTED);
}

TEST_F(Questions, aVolunteeredAnswerChangesHowManyMayFollowAndNotTheQuestion) {
  const Question first = sendAndAwaitQuestion(lightLamps());
  ASSERT_EQ(first.fluents.size(), 1U);
  const std::string lamp = textOf(first.fluents[0]);
  const std::string of_other_pair = lamp[5] == 'a' ? "(lit b1)" : "(lit a1)";
  EXPECT_TRUE(answer(kNo, 0, {of_other_pair}).accepted);
  const auto again = questions_.waitFor([&](const Question& shown) {
    return shown.question_id == first.question_id && shown.max_remaining < first.max_remaining;
  });
  ASSERT_TRUE(again);
  EXPECT_EQ(textsOf(again->fluents), Texts{lamp});
  EXPECT_EQ(again->text, first.text);
  EXPECT_EQ(again->asked, first.asked);
  EXPECT_TRUE(states_.waitFor([&](const AlignmentState& state) {
    return state.session_id == first.session_id && state.max_remaining == again->max_remaining;
  }));
  // Both pairs are settled by a no, so that the reason now is all that is known to stand in the
  // way.
  EXPECT_TRUE(answer(kNo, first.question_id).accepted) << "it is still open";
  EXPECT_EQ(expectEnd(AlignResult::SUCCESS).questions, 1U);
}

TEST_F(Questions, whatIsLeftOfAGroupIsPutAgainAfterSilence) {
  const Parameter timeout("ask_timeout", 0.3);
  const Parameter retries("ask_retries", 1000);
  const Question group = askAboutLamps();
  const std::string left = textOf(group.fluents[1]);
  // It may be put again just now, but it is always the same group.
  EXPECT_TRUE(answer(kNo, 0, {textOf(group.fluents[0])}).accepted);
  const auto again = questions_.waitFor([&](const Question& shown) {
    return shown.question_id > group.question_id && textsOf(shown.fluents) == Texts{left};
  });
  ASSERT_TRUE(again);
  EXPECT_FALSE(again->expires.isZero());
  EXPECT_TRUE(eventually([&] { return answer(kNo).accepted; }));
  EXPECT_EQ(expectEnd(AlignResult::SUCCESS).questions, 1U) << "it is one question";
}

TEST_F(Questions, whatAnAnswerMakesNeedlessIsTakenBackAndTheDialogueGoesOn) {
  const Question first = sendAndAwaitQuestion(lightLamps());
  ASSERT_EQ(first.fluents.size(), 1U);
  const std::string lamp = textOf(first.fluents[0]);
  EXPECT_TRUE(answer(kNo, 0, {partnerOf(lamp)}).accepted);
  const Question second = awaitQuestionAfter(first.question_id);
  EXPECT_FALSE(answer(kYes, first.question_id).accepted);
  EXPECT_NE(textOf(second.fluents.at(0)).substr(0, 6), lamp.substr(0, 6)) << "of the other pair";
  EXPECT_TRUE(answer(kNo, second.question_id).accepted);
  const AlignResult result = expectEnd(AlignResult::SUCCESS);
  EXPECT_EQ(int{candidateOf(result, lamp).state}, Candidate::SETTLED);
  EXPECT_EQ(textsOf(result.plan.kept_unasked).size(), 6U) << "two lamps and four facts";
}

TEST_F(Questions, theGoalsGroupSizeCountsMoreThanTheParameter) {
  const Parameter groups("max_group_size", 4);
  AlignGoal goal = lightLamps();
  goal.max_group_size = 1;
  const Question single = sendAndAwaitQuestion(goal);
  EXPECT_EQ(single.fluents.size(), 1U);
  cancelKnownGoal(align_);
  goal.continue_session = expectEnd(AlignResult::CANCELED).session_id;
  goal.max_group_size = 0;
  const Question group = sendAndAwaitQuestion(goal);
  EXPECT_GT(group.fluents.size(), 1U) << "a goal that goes on has its own";
  EXPECT_TRUE(answer(kNo, group.question_id).accepted);
  EXPECT_EQ(expectEnd(AlignResult::SUCCESS).questions, 1U);
}

TEST_F(Questions, nobodyIsAskedAboutHiddenPredicatesAndTheResultSaysSo) {
  const Parameter hidden("assumed_unwanted_predicates", Texts{"QUIET"});
  align_.sendGoal(sweepHall());
  const AlignResult result = expectEnd(AlignResult::SUCCESS);
  EXPECT_EQ(result.questions, 0U);
  EXPECT_EQ(textsOf(result.plan.assumed_not_wanted), Texts{"(quiet hall)"});
  EXPECT_TRUE(result.plan.not_wanted.empty());
  EXPECT_TRUE(contains(result.message, "since nobody was asked about it")) << result.message;
  EXPECT_TRUE(contains(result.message, "\"quiet\" holds for hall")) << result.message;
  const Candidate assumed = candidateOf(result, "(quiet hall)");
  EXPECT_EQ(assumed.answered_by, "assumed");
  EXPECT_TRUE(assumed.answered_at.isZero());
  EXPECT_TRUE(contains(explain({"(quiet hall)"}).text, "Nobody is asked"));
  EXPECT_TRUE(tells("outcome 1 (plan_found): I have a plan"));
}

TEST_F(Questions, whatIsHiddenMayStillBeSaid) {
  const Parameter hidden("assumed_wanted_predicates", Texts{"quiet"});
  align_.sendGoal(sweepHall());
  const AlignResult blocked = expectEnd(AlignResult::UNSURE_BLOCKS);
  EXPECT_EQ(blocked.questions, 0U);
  EXPECT_TRUE(contains(blocked.message, "It depends on whether this matters to you"))
      << blocked.message;
  EXPECT_FALSE(contains(blocked.message, "(quiet hall)")) << blocked.message;
  EXPECT_TRUE(reviseAnswer(kNo, {"(quiet hall)"}).accepted);
  const auto plan =
      plans_.waitFor([&](const Plan& shown) { return shown.session_id == blocked.session_id; });
  ASSERT_TRUE(plan) << "the session did not go on";
  EXPECT_EQ(textsOf(plan->not_wanted), Texts{"(quiet hall)"});
  EXPECT_TRUE(plan->assumed_not_wanted.empty());
}

TEST_F(Questions, aHiddenPredicateThatNoCandidateHasIsToldOf) {
  const Parameter hidden("assumed_wanted_predicates", Texts{"quite"});
  EXPECT_TRUE(answer(kNo, sendAndAwaitQuestion(sweepHall()).question_id).accepted);
  EXPECT_TRUE(tells("quite"));
  expectEnd(AlignResult::SUCCESS);
}

TEST_F(Questions, sideEffectsAreAskedAboutWhereThatIsWanted) {
  AlignGoal goal = sweepHall();
  goal.robot_domain = model("dusty_robot_domain.pddl");
  align_.sendGoal(goal);
  EXPECT_EQ(expectEnd(AlignResult::SUCCESS).questions, 0U);

  for (const bool by_goal : {true, false}) {
    const Parameter negative("negative_candidates", !by_goal);
    goal.negative_candidates = by_goal;
    const Question question = sendAndAwaitQuestion(goal);
    EXPECT_EQ(textsOf(question.fluents), Texts{"(not (dusty hall))"});
    EXPECT_TRUE(answer(by_goal ? kYes : kNo, question.question_id).accepted);
    const AlignResult result =
        expectEnd(by_goal ? AlignResult::EXPECTATION_UNACHIEVABLE : AlignResult::SUCCESS);
    EXPECT_EQ(textsOf(by_goal ? result.conflict : result.plan.not_wanted),
              Texts{"(not (dusty hall))"});
  }
}

TEST_F(Questions, whatCostsTooMuchToKeepIsAskedAbout) {
  AlignGoal goal = sweepHall();
  goal.robot_domain = model("airing_robot_domain.pddl");
  goal.human_domain = model("airing_human_domain.pddl");
  align_.sendGoal(goal);
  const AlignResult kept = expectEnd(AlignResult::SUCCESS);
  EXPECT_EQ(kept.plan.cost, 4);
  EXPECT_EQ(kept.plan.extra_cost, 3);

  const Parameter limit("max_extra_cost", 2.0);
  const Question question = sendAndAwaitQuestion(goal);
  EXPECT_EQ(textsOf(question.fluents), Texts{"(aired hall)"});
  EXPECT_TRUE(contains(question.why, "cost 3 more")) << question.why;
  EXPECT_TRUE(question.conflict.empty());
  EXPECT_TRUE(answer(kNo, question.question_id).accepted);
  const AlignResult cheap = expectEnd(AlignResult::SUCCESS);
  EXPECT_EQ(cheap.plan.cost, 1);
  EXPECT_EQ(cheap.plan.extra_cost, 0);
  EXPECT_EQ(textsOf(cheap.plan.not_wanted), Texts{"(aired hall)"});
}

}  // namespace
}  // namespace goal_alignment::test
