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
  plan_ = plan;
  step_ = -1;
  of_step_ = Progress::Ahead;
  endResetModel();
}

void PlanModel::clear() {
  if (plan_->plan_id != 0 || rowCount() > 0) show(boost::make_shared<Plan>());
}

void PlanModel::begin() {
  move(-1, Progress::Ahead);
}

void PlanModel::hear(const ExecutePlanFeedback& feedback) {
  if (feedback.plan_id != plan_->plan_id) return;
  if (feedback.step >= 0 && feedback.step < rowCount())
    move(feedback.step, progressFor(feedback.status));
}

void PlanModel::end(const ExecutePlanResult& result) {
  // An execution that could not be finished in order names no plan.
  const bool names_plan = result.plan.plan_id != 0 || !result.plan.steps.empty();
  if (names_plan && result.plan.plan_id != plan_->plan_id) return;
  if (result.outcome == ExecutePlanResult::SUCCESS) {
    move(rowCount() - 1, Progress::Done);
  } else if (result.failed_step >= 0 && result.failed_step < rowCount()) {
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

PlanModel::Progress PlanModel::progressOf(int row) const {
  if (row == step_) return of_step_;
  return row < step_ ? Progress::Done : Progress::Ahead;
}

int PlanModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(plan_->steps.size());
}

int PlanModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : Columns;
}

QString PlanModel::textOf(int row) const {
  const auto& texts = plan_->step_texts;
  const auto at = static_cast<std::size_t>(row);
  if (at < texts.size() && !texts[at].empty()) return sentence(QString::fromStdString(texts[at]));
  return pddlOf(plan_->steps[at]);
}

QVariant PlanModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const Progress progress = progressOf(index.row());
  switch (role) {
    case Qt::DisplayRole: {
      if (index.column() == Text) return textOf(index.row());
      if (progress == Progress::Done) return QStringLiteral("✓");
      if (progress == Progress::Failed) return QStringLiteral("✗");
      if (progress == Progress::Running) return QStringLiteral("▶");
      return QString::number(index.row() + 1);
    }
    case Qt::ToolTipRole:
      return QStringLiteral("step %1: %2")
          .arg(index.row() + 1)
          .arg(pddlOf(plan_->steps[static_cast<std::size_t>(index.row())]));
    case Qt::TextAlignmentRole:
      return index.column() == Mark ? QVariant(Qt::AlignCenter) : QVariant();
    case ProgressRole:
      return static_cast<int>(progress);
    default:
      return {};
  }
}

QVariant PlanModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  return section == Text ? QVariant(QStringLiteral("Step")) : QVariant(QString());
}

}  // namespace goal_alignment::rviz_panel
