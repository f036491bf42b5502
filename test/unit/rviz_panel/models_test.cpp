// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <QSignalSpy>

#include "goal_alignment/ActionFeedback.h"
#include "messages.h"
#include "rviz_panel/answer_model.h"
#include "rviz_panel/candidate_model.h"
#include "rviz_panel/candidate_sorter.h"
#include "rviz_panel/colours.h"
#include "rviz_panel/plan_model.h"
#include "rviz_panel/wording.h"

namespace goal_alignment::rviz_panel {
namespace {

QString cell(const QAbstractItemModel& model, int row, int column) {
  return model.index(row, column).data().toString();
}

TEST(Wording, aFluentIsSpokenWhereItHasAText) {
  EXPECT_EQ(phraseOf(fluent("on", {"a", "b"}, "a is on b")), "a is on b");
  EXPECT_EQ(phraseOf(fluent("on-top-of", {"a", "b"})), "on top of: a, b");
}

TEST(Wording, pddlIsWhatAnswerUnderstands) {
  Fluent negated = fluent("dusty", {"cup"});
  negated.negated = 1;
  EXPECT_EQ(pddlOf(negated), "(not (dusty cup))");
  EXPECT_EQ(pddlOf(fluent("tea-served", {})), "(tea-served)");
}

TEST(CandidateModel, showsPhraseBeliefAndState) {
  auto state = stateWith(0);
  state->candidates = {candidate(fluent("on", {"a", "b"}, "a is on b"), Candidate::WANTED, 0.256)};
  CandidateModel model;
  model.show(state);
  ASSERT_EQ(model.rowCount(), 1);
  EXPECT_EQ(cell(model, 0, CandidateModel::Phrase), "a is on b");
  EXPECT_EQ(cell(model, 0, CandidateModel::Belief), "26 %");
  EXPECT_EQ(cell(model, 0, CandidateModel::State), "wanted");
}

TEST(CandidateModel, theToolTipHasThePddlAndTheConflicts) {
  auto state = stateWith(2);
  Conflict conflict;
  conflict.fluents = {state->candidates[0].fluent, state->candidates[1].fluent};
  conflict.proven = 1;
  state->conflicts = {conflict};
  state->candidates[0].conflicts = {0, 7};  // the second one is none
  CandidateModel model;
  model.show(state);
  const QString tip = model.index(0, 0).data(Qt::ToolTipRole).toString();
  EXPECT_TRUE(tip.contains("(at thing0 kitchen)")) << tip.toStdString();
  EXPECT_TRUE(tip.contains("can't all be had: the thing0")) << tip.toStdString();
  EXPECT_FALSE(model.index(1, 0).data(Qt::ToolTipRole).toString().contains("can't all be had"));
}

TEST(CandidateModel, theSameCandidatesChangeOnlyTheirRows) {
  CandidateModel model;
  const auto before = stateWith(10);
  model.show(before);
  QSignalSpy resets(&model, &QAbstractItemModel::modelReset);
  QSignalSpy changes(&model, &QAbstractItemModel::dataChanged);
  auto after = boost::make_shared<AlignmentState>(*before);
  after->candidates[3].state = Candidate::WANTED;
  after->candidates[4].probability = 1;
  after->candidates[8].answered_by = "Ada";
  model.show(after);
  EXPECT_EQ(resets.count(), 0);
  ASSERT_EQ(changes.count(), 1);
  EXPECT_EQ(changes[0][0].toModelIndex().row(), 3);
  EXPECT_EQ(changes[0][1].toModelIndex().row(), 8);
  model.show(stateWith(11));
  EXPECT_EQ(resets.count(), 1);
}

TEST(CandidateModel, whatWasAskedForAnywayCanNotBeAnswered) {
  auto state = stateWith(2);
  state->candidates[0].state = Candidate::SPECIFIED;
  CandidateModel model;
  model.show(state);
  EXPECT_FALSE(model.index(0, 0).data(CandidateModel::AnswerableRole).toBool());
  EXPECT_TRUE(model.index(1, 0).data(CandidateModel::AnswerableRole).toBool());
}

TEST(CandidateSorter, sortsBeliefsAsNumbers) {
  CandidateModel model;
  CandidateSorter sorter;
  sorter.setSourceModel(&model);
  model.show(stateWith(1000));
  sorter.sort(CandidateModel::Belief, Qt::DescendingOrder);
  for (int row = 1; row < 1000; ++row) {
    ASSERT_GE(sorter.index(row - 1, 0).data(CandidateModel::BeliefRole).toDouble(),
              sorter.index(row, 0).data(CandidateModel::BeliefRole).toDouble());
  }
}

TEST(CandidateSorter, byStateTheQuestionComesFirstAndWhatIsSettledLast) {
  auto state = stateWith(4);
  state->candidates[0].state = Candidate::SETTLED;
  state->candidates[1].state = Candidate::NOT_WANTED;
  state->candidates[3].state = Candidate::ASKED;
  CandidateModel model;
  CandidateSorter sorter;
  sorter.setSourceModel(&model);
  model.show(state);
  sorter.sort(CandidateModel::State);
  EXPECT_EQ(cell(sorter, 0, CandidateModel::State), "asked now");
  EXPECT_EQ(cell(sorter, 1, CandidateModel::State), "open");
  EXPECT_EQ(cell(sorter, 3, CandidateModel::State), "settled");
}

TEST(CandidateSorter, staysSortedThroughUpdates) {
  CandidateModel model;
  CandidateSorter sorter;
  sorter.setSourceModel(&model);
  model.show(stateWith(50));
  sorter.sort(CandidateModel::State);
  constexpr int kStates[] = {Candidate::SETTLED, Candidate::WANTED, Candidate::OPEN,
                             Candidate::NOT_WANTED, Candidate::ASKED};
  for (int round = 1; round < 8; ++round) {
    auto state = stateWith(50);
    for (int i = 0; i < 50; ++i) {
      auto& candidate = state->candidates[static_cast<std::size_t>(i)];
      candidate.state = static_cast<std::uint8_t>(kStates[i * round * 7 % 11 % 5]);
      candidate.probability = (i * round * 13 % 50) / 50.0;
    }
    model.show(state);
    for (int row = 1; row < 50; ++row) {
      ASSERT_LE(sorter.index(row - 1, CandidateModel::State).data(CandidateModel::SortRole).toInt(),
                sorter.index(row, CandidateModel::State).data(CandidateModel::SortRole).toInt())
          << "round " << round;
    }
  }
}

TEST(CandidateSorter, filtersByPhraseAndByPddl) {
  CandidateModel model;
  CandidateSorter sorter;
  sorter.setSourceModel(&model);
  model.show(stateWith(1000));
  sorter.filter("THING123 ");
  EXPECT_EQ(sorter.rowCount(), 1);
  sorter.filter("(at thing12");
  EXPECT_EQ(sorter.rowCount(), 11);  // thing12, thing120 to thing129
  sorter.filter("");
  EXPECT_EQ(sorter.rowCount(), 1000);
}

TEST(AnswerModel, holdsWhatPeopleSaidInItsOrder) {
  auto state = stateWith(4);
  state->candidates[0].state = Candidate::NOT_WANTED;
  state->candidates[0].answered_at = ros::Time(20);
  state->candidates[1].state = Candidate::WANTED;
  state->candidates[1].answered_at = ros::Time(10);
  state->candidates[1].answered_by = "Ada";
  state->candidates[2].state = Candidate::WANTED;
  state->candidates[2].answered_by = "assumed";
  AnswerModel model;
  model.show(*state);
  ASSERT_EQ(model.rowCount(), 2);
  EXPECT_EQ(cell(model, 0, AnswerModel::Answer), "Yes");
  EXPECT_EQ(cell(model, 1, AnswerModel::Answer), "No");
  EXPECT_EQ(model.index(1, 0).data(AnswerModel::PddlRole), "(at thing0 kitchen)");
  EXPECT_TRUE(model.index(0, 0).data(Qt::ToolTipRole).toString().contains("answered by Ada"));
}

PlanModel::Progress progress(const PlanModel& model, int row) {
  return static_cast<PlanModel::Progress>(
      model.index(row, 0).data(PlanModel::ProgressRole).toInt());
}

ExecutePlanFeedback feedback(int step, int status) {
  ExecutePlanFeedback message;
  message.plan_id = 1;
  message.step = step;
  message.status = static_cast<std::uint8_t>(status);
  return message;
}

ExecutePlanResult result(int outcome, int failed_step = -1, int plan_id = 1) {
  ExecutePlanResult message;
  message.outcome = static_cast<std::uint16_t>(outcome);
  message.failed_step = failed_step;
  message.plan.plan_id = plan_id;
  return message;
}

TEST(PlanModel, followsTheExecution) {
  PlanModel model;
  model.show(planOf(3));
  EXPECT_EQ(cell(model, 0, PlanModel::Text), "Go from the counter to the table");
  EXPECT_EQ(model.runningStep(), -1);
  model.hear(feedback(1, ActionFeedback::ACTION_ENABLED));
  EXPECT_EQ(model.runningStep(), 1);
  EXPECT_EQ(progress(model, 0), PlanModel::Progress::Done);
  EXPECT_EQ(progress(model, 2), PlanModel::Progress::Ahead);
  model.hear(feedback(1, ActionFeedback::ACTION_FAILED));
  EXPECT_EQ(progress(model, 1), PlanModel::Progress::Failed);
  model.begin();
  EXPECT_EQ(progress(model, 0), PlanModel::Progress::Ahead);
  model.end(result(ExecutePlanResult::SUCCESS));
  EXPECT_EQ(progress(model, 2), PlanModel::Progress::Done);
}

TEST(PlanModel, aStepThatIsNotInThePlanIsLeftOut) {
  PlanModel model;
  model.show(planOf(2));
  model.hear(feedback(7, ActionFeedback::ACTION_ENABLED));
  model.hear(feedback(-1, ActionFeedback::ACTION_ENABLED));
  EXPECT_EQ(model.runningStep(), -1);
}

TEST(PlanModel, whatWasStoppedHasFailedInItsStep) {
  PlanModel model;
  model.show(planOf(3));
  model.hear(feedback(1, ActionFeedback::ACTION_ENABLED));
  model.end(result(ExecutePlanResult::CANCELED));
  EXPECT_EQ(progress(model, 1), PlanModel::Progress::Failed);
  EXPECT_EQ(progress(model, 2), PlanModel::Progress::Ahead);
}

TEST(PlanModel, whatEndsWithoutAPlanHasFailedInItsStep) {
  PlanModel model;
  model.show(planOf(3));
  model.hear(feedback(1, ActionFeedback::ACTION_ENABLED));
  model.end(result(ExecutePlanResult::INTERNAL, -1, 0));
  EXPECT_EQ(progress(model, 1), PlanModel::Progress::Failed);
}

TEST(PlanModel, whatIsHeardOfAnotherPlanMarksNothing) {
  auto plan = planOf(3);
  plan->plan_id = 2;
  PlanModel model;
  model.show(plan);
  model.hear(feedback(1, ActionFeedback::ACTION_ENABLED));
  EXPECT_EQ(model.runningStep(), -1);
  EXPECT_EQ(progress(model, 0), PlanModel::Progress::Ahead);
  model.end(result(ExecutePlanResult::SUCCESS));
  model.end(result(ExecutePlanResult::STEP_FAILED, 0));
  EXPECT_EQ(progress(model, 0), PlanModel::Progress::Ahead);
  EXPECT_EQ(progress(model, 2), PlanModel::Progress::Ahead);
}

// The contrast of WCAG 2; 4.5 is what text of the usual size should have.
double contrast(const QColor& a, const QColor& b) {
  const auto luminance = [](const QColor& colour) {
    const auto part = [](double c) {
      return c <= 0.03928 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * part(colour.redF()) + 0.7152 * part(colour.greenF()) +
           0.0722 * part(colour.blueF());
  };
  const double brighter = std::max(luminance(a), luminance(b));
  const double darker = std::min(luminance(a), luminance(b));
  return (brighter + 0.05) / (darker + 0.05);
}

TEST(Colours, canBeReadOnLightAndOnDark) {
  QPalette light;
  light.setColor(QPalette::Base, Qt::white);
  light.setColor(QPalette::Text, Qt::black);
  QPalette dark;
  dark.setColor(QPalette::Base, QColor(35, 38, 41));
  dark.setColor(QPalette::Text, QColor(239, 240, 241));
  for (const QPalette& palette : {light, dark}) {
    for (const Tone tone :
         {Tone::Plain, Tone::Muted, Tone::Accent, Tone::Good, Tone::Bad, Tone::Warning}) {
      const QColor colour = colourOf(tone, palette);
      EXPECT_GE(contrast(colour, palette.color(QPalette::Base)), 4.5) << static_cast<int>(tone);
      EXPECT_GE(contrast(colour, tintOf(tone, palette)), 4.2) << static_cast<int>(tone);
    }
  }
}

}  // namespace
}  // namespace goal_alignment::rviz_panel
