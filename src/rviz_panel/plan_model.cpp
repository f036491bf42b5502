// SPDX-License-Identifier: BSD-3-Clause
#include "plan_model.h"

#include "goal_alignment/ActionFeedback.h"
#include "wording.h"

namespace goal_alignment::rviz_panel {
namespace {

PlanModel::Progress progressFor(std::uint8_t status) {
  switch (status) {
    case ActionFeedback::ACTION_SUCCEEDED_TO_GOAL_STATE:
    case ActionFeedback::ACTION_SUCCEEDED_TO_START_STATE:
      return PlanModel::Progress::Done;
    case ActionFeedback::ACTION_FAILED:
    case ActionFeedback::ACTION_PRECONDITION_FALSE:
      return PlanModel::Progress::Failed;
    default:
      return PlanModel::Progress::Running;
  }
}

}  // namespace

void PlanModel::show(const Plan::ConstPtr& plan) {
  beginResetModel();
  if (plan->session_id == plan_->session_id) {
    keepDone();
  } else {
    done_.clear();
  }
  plan_ = plan;
  step_ = -1;
  of_step_ = Progress::Ahead;
  endResetModel();
}

// What still ran has not come to its end in view of us.
void PlanModel::keepDone() {
  for (int step = 0; step < stepCount(); ++step) {
    const Progress progress = progressOf(step);
    if (progress == Progress::Done || progress == Progress::Failed)
      done_.push_back(stepOf(firstRow() + step));
  }
}

void PlanModel::clear() {
  if (plan_->plan_id == 0 && rowCount() == 0) return;
  show(boost::make_shared<Plan>());
  beginResetModel();
  done_.clear();
  endResetModel();
}

void PlanModel::begin() {
  move(-1, Progress::Ahead);
}

void PlanModel::hear(const ExecutePlanFeedback& feedback) {
  if (feedback.plan_id != plan_->plan_id) return;
  if (feedback.step >= 0 && feedback.step < stepCount())
    move(feedback.step, progressFor(feedback.status));
}

void PlanModel::end(const ExecutePlanResult& result) {
  // An execution that could not be finished in order names no plan.
  const bool names_plan = result.plan.plan_id != 0 || !result.plan.steps.empty();
  if (names_plan && result.plan.plan_id != plan_->plan_id) return;
  if (result.outcome == ExecutePlanResult::SUCCESS) {
    move(stepCount() - 1, Progress::Done);
  } else if (result.failed_step >= 0 && result.failed_step < stepCount()) {
    move(result.failed_step, Progress::Failed);
  } else if (of_step_ == Progress::Running) {
    move(step_, Progress::Failed);
  }
}

void PlanModel::move(int step, Progress progress) {
  step_ = step;
  of_step_ = progress;
  if (rowCount() > 0) emit dataChanged(index(0, 0), index(rowCount() - 1, Columns - 1));
}

int PlanModel::runningStep() const {
  return of_step_ == Progress::Running ? step_ : -1;
}

PlanModel::Progress PlanModel::progressOf(int step) const {
  if (step == step_) return of_step_;
  return step < step_ ? Progress::Done : Progress::Ahead;
}

int PlanModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : firstRow() + stepCount();
}

int PlanModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : Columns;
}

QString PlanModel::textOf(int step) const {
  const auto& texts = plan_->step_texts;
  const auto at = static_cast<std::size_t>(step);
  if (at < texts.size() && !texts[at].empty()) return sentence(QString::fromStdString(texts[at]));
  return pddlOf(plan_->steps[at]);
}

PlanModel::Step PlanModel::stepOf(int row) const {
  if (row < firstRow()) return done_[static_cast<std::size_t>(row)];
  const int step = row - firstRow();
  return {textOf(step), pddlOf(plan_->steps[static_cast<std::size_t>(step)]), progressOf(step)};
}

QVariant PlanModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const Step step = stepOf(index.row());
  const int number = index.row() - firstRow() + 1;
  switch (role) {
    case Qt::DisplayRole: {
      if (index.column() == Text) return step.text;
      if (step.progress == Progress::Done) return QStringLiteral("✓");
      if (step.progress == Progress::Failed) return QStringLiteral("✗");
      if (step.progress == Progress::Running) return QStringLiteral("▶");
      return QString::number(number);
    }
    case Qt::ToolTipRole:
      return number > 0 ? QStringLiteral("step %1: %2").arg(number).arg(step.pddl)
                        : QStringLiteral("of the plan before: %1").arg(step.pddl);
    case Qt::TextAlignmentRole:
      return index.column() == Mark ? QVariant(Qt::AlignCenter) : QVariant();
    case ProgressRole:
      return static_cast<int>(step.progress);
    default:
      return {};
  }
}

QVariant PlanModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  return section == Text ? QVariant(QStringLiteral("Step")) : QVariant(QString());
}

}  // namespace goal_alignment::rviz_panel
