// SPDX-License-Identifier: BSD-3-Clause
// Sessions that go on: after every outcome, with other answers, with another world. Nothing that
// was answered is asked again.
#include <map>
#include <set>

#include "aligner_calls.h"
#include "generated_tasks.h"

namespace goal_alignment::test {
namespace {

using State = actionlib::SimpleClientGoalState;
constexpr int kNo = Answer::Request::NO;
constexpr int kYes = Answer::Request::YES;
constexpr int kUnsure = Answer::Request::UNSURE;
constexpr int kDecline = Answer::Request::DECLINE;

using Texts = std::vector<std::string>;

class Sessions : public Scenario {
 protected:
  // The next question; fails where it was put before.
  Question ask() {
    const Question question = askAgain();
    for (const std::string& text : textsOf(question.fluents))
      EXPECT_TRUE(asked_.insert(text).second) << text << " is asked a second time";
    return question;
  }

  // The same for one that may have been put before.
  Question askAgain() {
    Question question = awaitQuestionAfter(last_id_);
    last_id_ = question.question_id;
    EXPECT_EQ(question.fluents.size(), 1U);
    return question;
  }

  Question begin(const AlignGoal& goal) {
    for (const Question& question : questions_.all())
      last_id_ = std::max(last_id_, question.question_id);
    asked_.clear();
    align_.sendGoal(goal);
    return ask();
  }

  void reply(const Question& question, int value) {
    const auto response = answer(value, question.question_id);
    EXPECT_TRUE(response.accepted) << response.message;
  }

  // Sends the goal that goes on with a session.
  void resume(const AlignResult& before, const std::function<void(AlignGoal&)>& change = {}) {
    AlignGoal goal;
    goal.continue_session = before.session_id;
    goal.max_questions = -1;
    if (change) change(goal);
    align_.sendGoal(goal);
  }

  AlignResult expectEnd(int outcome) {
    AlignResult result = awaitResult();
    EXPECT_EQ(result.outcome, outcome) << result.message;
    EXPECT_EQ(align_.getState() == State::SUCCEEDED, outcome == AlignResult::SUCCESS);
    expectNothingKeptThatIsNotWanted(result.plan);
    return result;
  }

  // The same session, which expects the same.
  void expectSameSession(const AlignResult& before, const AlignResult& after) {
    EXPECT_EQ(after.session_id, before.session_id);
    ASSERT_EQ(after.candidates.size(), before.candidates.size());
    for (std::size_t i = 0; i < after.candidates.size(); ++i)
      EXPECT_EQ(textOf(after.candidates[i].fluent), textOf(before.candidates[i].fluent));
  }

  static void expectNothingKeptThatIsNotWanted(const Plan& plan) {
    for (const std::string& kept : textsOf(plan.kept_unasked)) {
      for (const std::string& not_wanted : textsOf(plan.not_wanted))
        EXPECT_NE(kept, not_wanted);
    }
  }

  // One guest or the other: each is offered, in the state and in words, too, and leads to a plan.
  void expectAChoice(const AlignResult& before) {
    ASSERT_EQ(before.alternatives.size(), 2U);
    EXPECT_GE(before.alternatives[0].probability, before.alternatives[1].probability);
    const AlternativeGoal& chosen = before.alternatives[0];
    EXPECT_EQ(chosen.given_up.size(), 1U);
    EXPECT_NE(before.message.find(chosen.given_up.at(0).text), std::string::npos) << before.message;
    const auto shown = states_.waitFor([&](const AlignmentState& state) {
      return state.session_id == before.session_id && state.outcome == before.outcome;
    });
    ASSERT_TRUE(shown);
    EXPECT_EQ(shown->alternatives, before.alternatives);
    resume(before, [&](AlignGoal& next) {
      next.unsure_policy = AlignGoal::KEEP;
      next.revised_not_wanted = chosen.given_up;
    });
    const AlignResult after = expectEnd(AlignResult::SUCCESS);
    EXPECT_EQ(after.questions, 0U);
    EXPECT_EQ(textsOf(after.plan.not_wanted), textsOf(chosen.given_up));
  }

  static int stateOf(const AlignResult& result, const std::string& text) {
    for (const Candidate& candidate : result.candidates) {
      if (textOf(candidate.fluent) == text) return candidate.state;
    }
    ADD_FAILURE() << text << " is no candidate";
    return -1;
  }

 private:
  std::uint32_t last_id_ = 0;
  std::set<std::string> asked_;
};

TEST_F(Sessions, goOnAfterSuccess) {
  reply(begin(sweepHall()), kNo);
  const AlignResult before = expectEnd(AlignResult::SUCCESS);
  resume(before);
  const AlignResult same = expectEnd(AlignResult::SUCCESS);
  expectSameSession(before, same);
  EXPECT_EQ(same.questions, 0U);
  EXPECT_EQ(same.plan.steps.size(), before.plan.steps.size());
  EXPECT_GT(same.plan.plan_id, before.plan.plan_id);

  resume(before, [](AlignGoal& goal) { goal.revised_wanted = {fluent("quiet", {"hall"})}; });
  const AlignResult other = expectEnd(AlignResult::EXPECTATION_UNACHIEVABLE);
  expectSameSession(before, other);
  EXPECT_EQ(textsOf(other.conflict), Texts{"(quiet hall)"});
  EXPECT_EQ(other.questions, 0U);
}

TEST_F(Sessions, goOnAfterNoPlanWithAnAlternative) {
  reply(begin(seatGuests(3)), kYes);
  reply(ask(), kYes);
  const AlignResult before = expectEnd(AlignResult::EXPECTATION_UNACHIEVABLE);
  EXPECT_EQ(textsOf(before.conflict), (Texts{"(seated g1)", "(seated g2)"}));
  ASSERT_EQ(before.alternatives.size(), 2U);
  for (const std::string& message : {before.message, currentState().message}) {
    EXPECT_EQ(message.find("I can't have both: \"seated\" holds for g"), 0U) << message;
    EXPECT_NE(message.find("That is certain. I can do everything except: \"seated\" holds for g"),
              std::string::npos)
        << message;
    EXPECT_NE(message.find(". Or everything except: "), std::string::npos) << message;
  }
  const auto given_up = before.alternatives[1].given_up;
  ASSERT_EQ(given_up.size(), 1U);

  resume(before, [&](AlignGoal& goal) { goal.revised_not_wanted = given_up; });
  const AlignResult after = expectEnd(AlignResult::SUCCESS);
  expectSameSession(before, after);
  EXPECT_EQ(after.questions, 0U);
  EXPECT_EQ(textsOf(after.plan.not_wanted), textsOf(given_up));
  EXPECT_EQ(after.plan.steps.size(), 2U);
}

TEST_F(Sessions, goOnAfterACancel) {
  reply(begin(sweepBothRooms()), kNo);
  const Question open = ask();
  cancelKnownGoal(align_);
  const AlignResult before = expectEnd(AlignResult::CANCELED);
  resume(before);
  const Question again = askAgain();
  EXPECT_EQ(textsOf(again.fluents), textsOf(open.fluents));
  EXPECT_EQ(again.session_id, before.session_id);
  reply(again, kNo);
  const AlignResult after = expectEnd(AlignResult::SUCCESS);
  expectSameSession(before, after);
  EXPECT_EQ(after.questions, 1U) << "of this goal";
  EXPECT_EQ(after.plan.not_wanted.size(), 2U) << "the first answer is kept";
}

TEST_F(Sessions, goOnAfterSilence) {
  reply(begin(sweepBothRooms()), kNo);
  const Question open = ask();
  cancelKnownGoal(align_);
  AlignResult before = expectEnd(AlignResult::CANCELED);
  {
    const Parameter timeout("ask_timeout", 0.2);
    resume(before);
    EXPECT_EQ(textsOf(askAgain().fluents), textsOf(open.fluents));
    before = expectEnd(AlignResult::NO_ANSWER);
  }
  resume(before);
  const Question again = askAgain();
  EXPECT_EQ(textsOf(again.fluents), textsOf(open.fluents));
  EXPECT_TRUE(again.expires.isZero()) << "the parameter is read anew";
  reply(again, kNo);
  expectSameSession(before, expectEnd(AlignResult::SUCCESS));
}

TEST_F(Sessions, goOnAfterDecline) {
  reply(begin(sweepBothRooms()), kNo);
  const Question open = ask();
  reply(open, kDecline);
  const AlignResult before = expectEnd(AlignResult::DECLINED);
  resume(before);
  const Question again = askAgain();
  EXPECT_EQ(textsOf(again.fluents), textsOf(open.fluents));
  reply(again, kNo);
  expectSameSession(before, expectEnd(AlignResult::SUCCESS));
}

TEST_F(Sessions, goOnAfterTheQuestionLimitWithALargerOne) {
  AlignGoal goal = sweepRooms(4);
  goal.max_questions = 1;
  reply(begin(goal), kNo);
  AlignResult before = expectEnd(AlignResult::QUESTION_LIMIT);
  EXPECT_EQ(before.questions, 1U);
  resume(before, [](AlignGoal& next) { next.max_questions = 2; });
  reply(ask(), kNo);
  reply(ask(), kNo);
  AlignResult after = expectEnd(AlignResult::QUESTION_LIMIT);
  expectSameSession(before, after);
  EXPECT_EQ(after.questions, 2U);
  resume(before);
  reply(ask(), kNo);
  after = expectEnd(AlignResult::SUCCESS);
  expectSameSession(before, after);
  EXPECT_EQ(after.plan.not_wanted.size(), 4U);
}

TEST_F(Sessions, obeyTheSmallerOfBothQuestionLimits) {
  {
    const Parameter limit("max_questions", 1);
    AlignGoal goal = sweepRooms(3);
    goal.max_questions = 2;
    reply(begin(goal), kNo);
    EXPECT_EQ(expectEnd(AlignResult::QUESTION_LIMIT).questions, 1U);
  }
  const Parameter limit("max_questions", 2);
  AlignGoal goal = sweepRooms(3);
  goal.max_questions = 1;
  reply(begin(goal), kNo);
  EXPECT_EQ(expectEnd(AlignResult::QUESTION_LIMIT).questions, 1U);
}

TEST_F(Sessions, goOnAfterTheTimeLimit) {
  AlignGoal goal = seatGuests(10);
  goal.time_limit = ros::Duration(0.01);  // a fraction of what it takes
  align_.sendGoal(goal);
  const AlignResult before = expectEnd(AlignResult::TIME_LIMIT);
  EXPECT_EQ(before.questions, 0U);
  resume(before);
  const auto question = questions_.waitFor(
      [&](const Question& shown) { return shown.session_id == before.session_id; });
  ASSERT_TRUE(question);
  reply(*question, kNo);
  const AlignResult after = expectEnd(AlignResult::SUCCESS);
  EXPECT_EQ(after.session_id, before.session_id);
  EXPECT_EQ(after.questions, 1U);
  resume(after);
  const AlignResult again = expectEnd(AlignResult::SUCCESS);
  expectSameSession(after, again);
  EXPECT_EQ(again.questions, 0U);
}

TEST_F(Sessions, refuseAFluentThatIsWantedAndNotAndStayAsTheyAre) {
  reply(begin(sweepHall()), kNo);
  const AlignResult before = expectEnd(AlignResult::SUCCESS);
  const AlignmentState state = currentState();
  resume(before, [](AlignGoal& goal) {
    goal.revised_wanted = {fluent("room", {"hall"}), fluent("quiet", {"hall"})};
    goal.revised_not_wanted = {fluent("Quiet", {"HALL"})};
  });
  const AlignResult refused = expectEnd(AlignResult::CONTRADICTION);
  EXPECT_EQ(align_.getState(), State::REJECTED);
  EXPECT_NE(refused.message.find("(quiet hall)"), std::string::npos) << refused.message;
  EXPECT_TRUE(currentState() == state) << "not even its state was published anew";

  resume(before);
  const AlignResult after = expectEnd(AlignResult::SUCCESS);
  expectSameSession(before, after);
  EXPECT_EQ(stateOf(after, "(room hall)"), stateOf(before, "(room hall)"));
}

TEST_F(Sessions, refuseToReviseWhatIsNoCandidate) {
  reply(begin(sweepHall()), kNo);
  const AlignResult before = expectEnd(AlignResult::SUCCESS);
  for (const Fluent& foreign : {fluent("clean", {"hall"}), fluent("quiet", {"cellar"})}) {
    resume(before, [&](AlignGoal& goal) { goal.revised_not_wanted = {foreign}; });
    const AlignResult refused = expectEnd(AlignResult::INVALID_MODEL);
    EXPECT_NE(refused.message.find("revised_not_wanted"), std::string::npos) << refused.message;
  }
  resume(before);
  expectSameSession(before, expectEnd(AlignResult::SUCCESS));
}

TEST_F(Sessions, takeARevisedAnswerWhileAQuestionIsOpen) {
  const Question first = begin(seatGuests(3));
  reply(first, kYes);
  const Question second = ask();
  const auto revised = reviseAnswer(kNo, textsOf(first.fluents));
  EXPECT_TRUE(revised.accepted) << revised.message;
  const AlignResult result = expectEnd(AlignResult::SUCCESS);
  EXPECT_EQ(textsOf(result.plan.not_wanted), textsOf(first.fluents));
  EXPECT_FALSE(answer(kNo, second.question_id).accepted) << "it has gone with its reason";
}

TEST_F(Sessions, countEveryRevisionOfSeveralInARow) {
  reply(begin(sweepBothRooms()), kNo);
  reply(ask(), kNo);
  const Texts fluents = textsOf(expectEnd(AlignResult::SUCCESS).plan.not_wanted);
  ASSERT_EQ(fluents.size(), 2U);
  for (int round = 0; round < 20; ++round) {
    SCOPED_TRACE(round);
    const int value = round % 2 == 0 ? kYes : kNo;
    for (const std::string& text : fluents) {
      const auto revised = reviseAnswer(value, {text});
      EXPECT_TRUE(revised.accepted) << revised.message;
    }
    const int expected = value == kYes ? Candidate::WANTED : Candidate::NOT_WANTED;
    EXPECT_TRUE(eventually([&] {
      const AlignmentState state = currentState();
      const auto counts = std::count_if(
          state.candidates.begin(), state.candidates.end(), [&](const Candidate& candidate) {
            const std::string text = textsOf({candidate.fluent}).front();
            return candidate.state == expected &&
                   std::find(fluents.begin(), fluents.end(), text) != fluents.end();
          });
      return state.phase == AlignmentState::DONE && counts == 2;
    }));
  }
}

TEST_F(Sessions, putTheOpenQuestionAgainWhereARevisionLeavesIt) {
  const Question first = begin(sweepRooms(2));
  reply(first, kNo);
  const Question second = ask();
  EXPECT_TRUE(reviseAnswer(kNo, textsOf(first.fluents)).accepted) << "the same once more";
  EXPECT_TRUE(eventually([&] {
    return answer(kNo, 0).accepted;  // under whatever id it is open now
  }));
  const AlignResult result = expectEnd(AlignResult::SUCCESS);
  EXPECT_EQ(result.plan.not_wanted.size(), 2U);
}

TEST_F(Sessions, endAQuestionThatAFactHasMadeNeedless) {
  const Question question = begin(seatGuests(3));
  const auto mended = setFacts({fluent("free", {"Spare"})});
  EXPECT_TRUE(mended.accepted) << mended.message;
  const AlignResult result = expectEnd(AlignResult::SUCCESS);
  EXPECT_EQ(result.session_id, question.session_id);
  EXPECT_EQ(result.plan.steps.size(), 3U);
  EXPECT_FALSE(answer(kNo, question.question_id).accepted);
}

TEST_F(Sessions, askNothingAnewWhenAFactMakesSomethingImpossible) {
  const Question first = begin(seatGuests(4));
  reply(first, kYes);
  const Question second = ask();
  // One chair fewer: the conflicts are others, the answer stays.
  EXPECT_TRUE(setFacts({negated(fluent("free", {"c0"}))}).accepted);
  EXPECT_TRUE(eventually([&] {
    const auto shown = questions_.last();
    const auto why = explain({});
    return shown && shown->question_id != 0 && shown->conflict.size() < second.conflict.size() &&
           why.conflicts.size() == 1 &&
           textsOf(why.conflicts[0].fluents) == textsOf(shown->conflict);
  })) << "the reason is not the one that was shown";
  // The open question may stay or be replaced by another; whichever it is, the answer is no.
  EXPECT_TRUE(eventually([&] {
    const auto shown = questions_.last();
    if (shown && shown->question_id != 0) answer(kNo, shown->question_id);
    return align_.getState().isDone();
  }));
  for (const Question& shown : questions_.all()) {
    if (shown.question_id >= second.question_id) {
      EXPECT_NE(textsOf(shown.fluents), textsOf(first.fluents));
    }
  }
  const AlignResult result = expectEnd(AlignResult::SUCCESS);
  EXPECT_EQ(result.session_id, first.session_id);
  EXPECT_EQ(stateOf(result, textOf(first.fluents[0])), Candidate::WANTED);
  EXPECT_EQ(result.plan.steps.size(), 2U);
  for (const ActionDispatch& dispatch : result.plan.steps)
    EXPECT_NE(dispatch.parameters.at(1).value, "c0");
}

TEST_F(Sessions, showTheReasonThatTheFactsGive) {
  const Question before = begin(seatGuests(3));
  EXPECT_EQ(before.conflict.size(), 2U);
  EXPECT_TRUE(setFacts({negated(fluent("free", {"c0"}))}).accepted);
  // With one chair for g0 alone neither of the others can be seated.
  const auto now = questions_.waitFor([&](const Question& shown) {
    return shown.session_id == before.session_id && shown.conflict.size() == 1;
  });
  ASSERT_TRUE(now) << "the reason shown is the old one";
  EXPECT_GT(now->question_id, before.question_id) << "another question, though of the same fluent";
  EXPECT_EQ(now->why, explain({}).text);
  EXPECT_TRUE(eventually([&] {
    const auto shown = questions_.last();
    if (shown && shown->question_id != 0) answer(kNo, shown->question_id);
    return align_.getState().isDone();
  }));
  EXPECT_EQ(expectEnd(AlignResult::SUCCESS).plan.steps.size(), 1U);
}

TEST_F(Sessions, seeFactsThatCameBetweenTheirGoals) {
  reply(begin(seatGuests(3)), kNo);
  const AlignResult before = expectEnd(AlignResult::SUCCESS);
  EXPECT_EQ(before.plan.steps.size(), 2U);
  EXPECT_TRUE(setFacts({fluent("free", {"spare"})}).accepted);
  resume(before);
  const AlignResult richer = expectEnd(AlignResult::SUCCESS);
  expectSameSession(before, richer);
  EXPECT_EQ(richer.questions, 0U);

  // One chair is left for the guest asked for, none for the third, of whom nobody was asked yet.
  EXPECT_TRUE(
      setFacts({negated(fluent("free", {"c0"})), negated(fluent("free", {"spare"}))}).accepted);
  resume(before);
  reply(ask(), kNo);
  const AlignResult poorer = expectEnd(AlignResult::SUCCESS);
  expectSameSession(before, poorer);
  EXPECT_EQ(poorer.plan.steps.size(), 1U);
  EXPECT_EQ(textsOf(poorer.plan.not_wanted), (Texts{"(seated g1)", "(seated g2)"}));
}

TEST_F(Sessions, keepWhatNobodyIsSureOf) {
  AlignGoal goal = seatGuests(3);
  goal.unsure_policy = AlignGoal::AS_YES;
  const Question first = begin(goal);
  reply(first, kUnsure);
  const Question second = ask();
  reply(second, kNo);
  const AlignResult result = expectEnd(AlignResult::SUCCESS);
  const Texts guaranteed = textsOf(result.plan.guaranteed);
  EXPECT_EQ(std::count(guaranteed.begin(), guaranteed.end(), textOf(first.fluents[0])), 1);
}

TEST_F(Sessions, goOnWhereUnsureBlocked) {
  AlignGoal goal = seatGuests(3);
  goal.unsure_policy = AlignGoal::AS_YES;
  const Question first = begin(goal);
  reply(first, kUnsure);
  reply(ask(), kUnsure);
  const AlignResult before = expectEnd(AlignResult::UNSURE_BLOCKS);
  EXPECT_EQ(before.conflict.size(), 2U);
  EXPECT_EQ(before.questions, 2U);
  resume(before, [&](AlignGoal& next) { next.revised_not_wanted = first.fluents; });
  const AlignResult after = expectEnd(AlignResult::SUCCESS);
  expectSameSession(before, after);
  EXPECT_EQ(after.questions, 0U);
}

TEST_F(Sessions, deferAsksOnceMore) {
  AlignGoal goal = seatGuests(3);
  goal.unsure_policy = AlignGoal::DEFER;
  std::map<std::string, int> put;
  Question question = begin(goal);
  for (int i = 0; i < 4; ++i) {
    if (i > 0) question = askAgain();
    ++put[textOf(question.fluents.at(0))];
    reply(question, kUnsure);
  }
  EXPECT_EQ(put, (std::map<std::string, int>{{"(seated g1)", 2}, {"(seated g2)", 2}}));
  EXPECT_EQ(expectEnd(AlignResult::UNSURE_BLOCKS).questions, 4U);

  question = begin(goal);
  reply(question, kUnsure);
  reply(ask(), kUnsure);
  reply(askAgain(), kNo);
  EXPECT_EQ(expectEnd(AlignResult::SUCCESS).questions, 3U);
}

TEST_F(Sessions, abortEndsAtTheFirstDontKnow) {
  AlignGoal goal = seatGuests(3);
  goal.unsure_policy = AlignGoal::ABORT;
  const Question question = begin(goal);
  reply(question, kUnsure);
  const AlignResult before = expectEnd(AlignResult::UNSURE_BLOCKS);
  EXPECT_EQ(before.questions, 1U);
  EXPECT_EQ(textsOf(before.conflict), (Texts{"(seated g1)", "(seated g2)"}));
  expectAChoice(before);
}

// A revised answer, a goal of the node's own: the session asks once more, as it was begun.
TEST_F(Sessions, keepDeferAfterARevisedAnswer) {
  AlignGoal goal = seatGuests(3);
  goal.unsure_policy = AlignGoal::DEFER;
  const Question first = begin(goal);
  reply(first, kNo);
  const std::string session = expectEnd(AlignResult::SUCCESS).session_id;
  EXPECT_TRUE(reviseAnswer(kUnsure, {textOf(first.fluents.at(0))}).accepted);
  std::map<std::string, int> put;
  for (int i = 0; i < 3; ++i) {
    const Question question = askAgain();
    ++put[textOf(question.fluents.at(0))];
    reply(question, kUnsure);
  }
  EXPECT_EQ(put[textOf(first.fluents.at(0))], 1) << "once more";
  EXPECT_EQ(put.size(), 2U);
  EXPECT_TRUE(states_.waitFor([&](const AlignmentState& state) {
    return state.session_id == session && state.outcome == AlignResult::UNSURE_BLOCKS &&
           state.alternatives.size() == 2;
  }));
}

TEST_F(Sessions, keepTheirUnsurePolicyOrTakeAnother) {
  AlignGoal goal = seatGuests(3);
  goal.unsure_policy = AlignGoal::DEFER;
  reply(begin(goal), kDecline);
  AlignResult before = expectEnd(AlignResult::DECLINED);
  const auto keep = [](AlignGoal& next) { next.unsure_policy = AlignGoal::KEEP; };
  resume(before, keep);
  for (int i = 0; i < 4; ++i)
    reply(askAgain(), kUnsure);
  before = expectEnd(AlignResult::UNSURE_BLOCKS);
  EXPECT_EQ(before.questions, 4U);

  reply(begin(goal), kDecline);
  before = expectEnd(AlignResult::DECLINED);
  resume(before, [](AlignGoal& next) { next.unsure_policy = AlignGoal::ABORT; });
  reply(askAgain(), kUnsure);
  before = expectEnd(AlignResult::UNSURE_BLOCKS);
  EXPECT_EQ(before.questions, 1U);
  resume(before, keep);  // now it is ABORT that is kept
  reply(askAgain(), kUnsure);
  EXPECT_EQ(expectEnd(AlignResult::UNSURE_BLOCKS).questions, 1U);
}

TEST_F(Sessions, beginUnderTheParameterWhereTheirGoalNamesNoPolicy) {
  const Parameter policy("unsure_policy", "abort");
  AlignGoal goal = seatGuests(3);
  goal.unsure_policy = AlignGoal::KEEP;
  reply(begin(goal), kUnsure);
  EXPECT_EQ(expectEnd(AlignResult::UNSURE_BLOCKS).questions, 1U);
}

TEST_F(Sessions, offerAlternativesWhereverADialogueEndsWithoutAPlan) {
  AlignGoal goal = seatGuests(3);
  goal.unsure_policy = AlignGoal::AS_YES;
  reply(begin(goal), kUnsure);
  reply(ask(), kUnsure);
  expectAChoice(expectEnd(AlignResult::UNSURE_BLOCKS));
  reply(begin(goal), kDecline);
  expectAChoice(expectEnd(AlignResult::DECLINED));
  goal.max_questions = 0;
  align_.sendGoal(goal);
  expectAChoice(expectEnd(AlignResult::QUESTION_LIMIT));
}

TEST_F(Sessions, putAQuestionAgainAfterSilence) {
  const Parameter timeout("ask_timeout", 0.2);
  const Parameter retries("ask_retries", 2);
  const Question first = begin(sweepHall());
  const AlignResult result = expectEnd(AlignResult::NO_ANSWER);
  EXPECT_TRUE(questionIsClosed());
  std::vector<std::uint32_t> ids;
  for (const Question& shown : questions_.all()) {
    if (shown.session_id != first.session_id) continue;
    ids.push_back(shown.question_id);
    EXPECT_EQ(shown.text, first.text);
    EXPECT_FALSE(shown.expires.isZero());
  }
  ASSERT_EQ(ids.size(), 3U);
  EXPECT_TRUE(ids[0] < ids[1] && ids[1] < ids[2]);
  EXPECT_EQ(result.questions, 1U) << "it is one question";
  EXPECT_GE(result.waiting_time, 0.5);
}

TEST_F(Sessions, takeTheAnswerToAQuestionPutAgain) {
  const Parameter timeout("ask_timeout", 0.3);
  const Parameter retries("ask_retries", 1000);
  const Question first = begin(sweepHall());
  awaitQuestionAfter(first.question_id);
  // It may be put again just now, but it is always the same that id 0 means.
  EXPECT_TRUE(eventually([&] { return answer(kNo).accepted; }));
  EXPECT_EQ(expectEnd(AlignResult::SUCCESS).questions, 1U);
}

}  // namespace
}  // namespace goal_alignment::test
