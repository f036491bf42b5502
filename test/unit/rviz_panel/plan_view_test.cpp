// SPDX-License-Identifier: BSD-3-Clause
// What the view shows of an end and of a plan, and what clicks lead to there.
#include <QSignalSpy>

#include "goal_alignment/ActionFeedback.h"
#include "goal_alignment/AlignResult.h"
#include "goal_alignment/Answer.h"
#include "rviz_panel/tables.h"
#include "view_fixture.h"

namespace goal_alignment::rviz_panel {
namespace {

TEST_F(View, withoutAPlanTheAlternativesAreButtons) {
  QString session;
  std::vector<Fluent> given_up;
  QObject::connect(&view_, &AlignmentView::takenUp, &view_,
                   [&](const QString& id, const std::vector<Fluent>& fluents) {
                     session = id;
                     given_up = fluents;
                   });
  show(withoutPlan());
  EXPECT_TRUE(isShown("outcome_card"));
  EXPECT_TRUE(textOf("conflict").contains("the thing0 is where it belongs"));
  click("alternative_1");
  EXPECT_EQ(session, "s");
  ASSERT_EQ(given_up.size(), 1U);
  EXPECT_EQ(given_up[0].args[0], "thing1");
  show(stateWith(3));
  EXPECT_FALSE(isShown("outcome_card"));
}

TEST_F(View, thePlanShowsItsStepInExecution) {
  auto state = stateWith(3);
  state->phase = AlignmentState::DONE;
  state->outcome = AlignResult::SUCCESS;
  show(state);
  view_.showPlan(planOf(40));
  EXPECT_EQ(find<QTabWidget>("tabs")->tabText(2), "Plan (40)");
  view_.beginExecution();
  ExecutePlanFeedback feedback;
  feedback.plan_id = 1;
  feedback.step = 30;
  feedback.status = ActionFeedback::ACTION_ENABLED;
  view_.showExecution(feedback);
  QApplication::processEvents();
  EXPECT_EQ(textOf("status"), "Carrying out step 31 of 40");
  auto* table = find<QTableView>("plan");
  EXPECT_TRUE(table->viewport()->rect().contains(table->visualRect(table->model()->index(30, 0))));
  QSignalSpy stops(&view_, &AlignmentView::executionCanceled);
  click("cancel");
  EXPECT_EQ(stops.count(), 1);
  ExecutePlanResult result;
  result.outcome = ExecutePlanResult::STEP_FAILED;
  result.failed_step = 30;
  result.reason = "the cup slipped";
  view_.endExecution(result);
  EXPECT_TRUE(textOf("plan_note").contains("the cup slipped"));
}

AlignmentState::Ptr withPlan() {
  auto state = stateWith(3);
  state->phase = AlignmentState::DONE;
  state->outcome = AlignResult::SUCCESS;
  return state;
}

TEST_F(View, theHeadlineAndThePromiseFollowTheExecution) {
  show(withPlan());
  auto plan = planOf(2);
  plan->kept_unasked = {fluent("dry", {"floor"}, "the floor is dry")};
  view_.showPlan(plan);
  EXPECT_TRUE(textOf("status").startsWith("Plan found"));
  EXPECT_TRUE(textOf("plan_note").contains("Guaranteed: a cup of tea is served"));
  EXPECT_TRUE(textOf("plan_note").contains("the floor is dry"));
  view_.beginExecution();
  ExecutePlanResult failed;
  failed.outcome = ExecutePlanResult::STEP_FAILED;
  failed.failed_step = 0;
  failed.reason = "the cup slipped";
  failed.plan.plan_id = 1;
  view_.endExecution(failed);
  EXPECT_EQ(textOf("status"), "The plan was not carried out");
  EXPECT_FALSE(textOf("plan_note").contains("Guaranteed"));
  QSignalSpy again(&view_, &AlignmentView::retried);
  QApplication::processEvents();
  click("plan_again");
  ASSERT_EQ(again.count(), 1);
  EXPECT_EQ(again[0][0].toString(), "s");
}

TEST_F(View, aPlanIsCarriedOutOnDemandOnce) {
  int wanted = 0;
  QObject::connect(&view_, &AlignmentView::executionWanted, &view_,
                   [&](const Plan& plan) { wanted = plan.plan_id; });
  show(withPlan());
  view_.showPlan(planOf(2));
  QApplication::processEvents();
  click("do_it");
  EXPECT_EQ(wanted, 1);
  view_.beginExecution();
  EXPECT_FALSE(isShown("do_it"));
}

TEST_F(View, whatWasDoneStaysAboveANewPlan) {
  show(withPlan());
  view_.showPlan(planOf(3));
  view_.beginExecution();
  ExecutePlanFeedback feedback;
  feedback.plan_id = 1;
  feedback.step = 1;
  feedback.status = ActionFeedback::ACTION_FAILED;
  view_.showExecution(feedback);
  feedback = ExecutePlanFeedback();
  feedback.new_plan = *planOf(2);
  feedback.new_plan.plan_id = 2;
  view_.showExecution(feedback);
  auto* model = find<QTableView>("plan")->model();
  ASSERT_EQ(model->rowCount(), 4);
  EXPECT_EQ(model->index(0, 0).data().toString(), "✓");
  EXPECT_EQ(model->index(1, 0).data().toString(), "✗");
  EXPECT_EQ(model->index(2, 0).data().toString(), "1");
  feedback = ExecutePlanFeedback();
  feedback.plan_id = 2;
  feedback.step = 1;
  feedback.status = ActionFeedback::ACTION_ENABLED;
  view_.showExecution(feedback);
  EXPECT_EQ(textOf("status"), "Carrying out step 2 of 2");
}

TEST_F(View, noFurtherQuestionsIsAnAnswer) {
  QSignalSpy answers(&view_, &AlignmentView::answered);
  ask(questionAbout(7, {fluent("a", {})}));
  click("decline");
  ASSERT_EQ(answers.count(), 1);
  EXPECT_EQ(answers[0][0].toInt(), Answer::Request::DECLINE);
}

TEST_F(View, tasksThatWaitAreShownAndWithdrawn) {
  auto state = withPlan();
  EXPECT_FALSE(isShown("waiting_card"));
  for (const char* task : {"tea", "dusting"}) {
    WaitingTask waiting;
    waiting.task_id = task;
    waiting.goal_id = std::string("goal of ") + task;
    state->waiting.push_back(waiting);
  }
  show(state);
  EXPECT_TRUE(isShown("waiting_card"));
  QSignalSpy withdrawn(&view_, &AlignmentView::withdrawn);
  QApplication::processEvents();
  click("withdraw_1");
  ASSERT_EQ(withdrawn.count(), 1);
  EXPECT_EQ(withdrawn[0][0].toString(), "goal of dusting");
  show(withPlan());
  EXPECT_FALSE(isShown("waiting_card"));
}

TEST_F(View, theTaskIsTriedAgainWhereThereIsNoPlan) {
  QSignalSpy again(&view_, &AlignmentView::retried);
  auto state = withPlan();
  state->outcome = AlignResult::UNSURE_BLOCKS;
  state->alternatives.resize(1);
  state->alternatives[0].given_up = {state->candidates[0].fluent};
  show(state);
  EXPECT_TRUE(isShown("alternative_0")) << "of this outcome as well";
  click("try_again");
  ASSERT_EQ(again.count(), 1);
  EXPECT_EQ(again[0][0].toString(), "s");
}

TEST_F(View, theEndOfADisplacedPlanIsForgottenWhenTheNewOneGoesOn) {
  show(stateWith(3));
  auto plan = planOf(3);
  plan->plan_id = 2;
  view_.showPlan(plan);
  view_.beginExecution();
  ExecutePlanResult displaced;
  displaced.outcome = ExecutePlanResult::CANCELED;
  displaced.failed_step = 2;
  displaced.reason = "displaced by a newer plan";
  displaced.plan.plan_id = 1;
  view_.endExecution(displaced);
  EXPECT_TRUE(textOf("plan_note").contains("displaced"));
  ExecutePlanFeedback feedback;
  feedback.plan_id = 2;
  feedback.step = 0;
  feedback.status = ActionFeedback::ACTION_ENABLED;
  view_.showExecution(feedback);
  EXPECT_EQ(textOf("status"), "Carrying out step 1 of 3");
  EXPECT_FALSE(textOf("plan_note").contains("displaced"));
}

TEST_F(View, aPlanWithoutStepsIsAPlan) {
  auto state = stateWith(3);
  state->phase = AlignmentState::DONE;
  state->outcome = AlignResult::SUCCESS;
  show(state);
  EXPECT_EQ(find<RowTable>("plan")->placeholder(), "No plan yet");
  view_.showPlan(planOf(0));
  EXPECT_EQ(find<RowTable>("plan")->placeholder(), "Nothing to do: all is so already");
}

TEST_F(View, aPlanOfAnEarlierSessionIsNotShown) {
  show(stateWith(3));
  view_.showPlan(planOf(4));
  auto state = boost::make_shared<AlignmentState>(*stateWith(3));
  state->session_id = "another";
  show(state);
  EXPECT_EQ(find<QTableView>("plan")->model()->rowCount(), 0);
}

}  // namespace
}  // namespace goal_alignment::rviz_panel
