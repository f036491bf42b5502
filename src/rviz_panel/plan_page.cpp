// SPDX-License-Identifier: BSD-3-Clause
#include "plan_page.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

#include "wording.h"

namespace goal_alignment::rviz_panel {
namespace {

constexpr int kMargin = 2;   // pixels
constexpr int kSpacing = 4;  // pixels

void addLine(QStringList& lines, const QString& title, const std::vector<Fluent>& fluents) {
  if (fluents.empty()) return;
  lines << QStringLiteral("%1: %2.").arg(title, phrasesOf(fluents).join(QStringLiteral("; ")));
}

}  // namespace

PlanPage::PlanPage(QWidget* parent)
    : QWidget(parent),
      plan_(new PlanTable(this)),
      note_(new WrappedLabel(this)),
      do_it_(new QPushButton(QStringLiteral("Do it"), this)),
      try_again_(new QPushButton(QStringLiteral("Try again"), this)) {
  note_->setObjectName(QStringLiteral("plan_note"));
  do_it_->setObjectName(QStringLiteral("do_it"));
  do_it_->setToolTip(QStringLiteral("Has the plan carried out"));
  try_again_->setObjectName(QStringLiteral("plan_again"));
  try_again_->setToolTip(QStringLiteral("Makes a new plan from how things are now"));
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
  rows->setSpacing(kSpacing);
  rows->addWidget(plan_, 1);
  rows->addWidget(note_);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(do_it_);
  buttons->addWidget(try_again_);
  rows->addLayout(buttons);
  connect(do_it_, &QPushButton::clicked, this,
          [this] { emit executionWanted(plan_->steps().plan()); });
  connect(try_again_, &QPushButton::clicked, this,
          [this] { emit retried(QString::fromStdString(session_)); });
  refresh();
}

void PlanPage::clear() {
  run_ = Run::None;
  end_.clear();
  latest_ = boost::make_shared<Plan>();
  session_.clear();
  under_way_ = false;
  plan_->steps().clear();
  refresh();
}

void PlanPage::showSession(const std::string& session_id, bool under_way) {
  session_ = session_id;
  under_way_ = under_way;
  takeUpNewPlan();
}

void PlanPage::showPlan(const Plan::ConstPtr& plan) {
  latest_ = plan;
  takeUpNewPlan();
}

// While another is carried out the steps stay, until the executor says that it goes on with the new
// one.
void PlanPage::takeUpNewPlan() {
  PlanModel& steps = plan_->steps();
  const Plan& shown = steps.plan();
  const bool ours = latest_->session_id == session_;
  const bool other = shown.plan_id != latest_->plan_id || shown.session_id != latest_->session_id;
  if (!ours && !isExecuting()) {
    steps.clear();
    run_ = Run::None;
    end_.clear();
  } else if (ours && other && latest_->plan_id != 0 && (!isExecuting() || shown.plan_id == 0)) {
    if (!isExecuting()) run_ = Run::None;
    end_.clear();
    steps.show(latest_);
    emit newPlanShown();
  }
  refresh();
}

void PlanPage::beginExecution() {
  run_ = Run::None;
  takeUpNewPlan();
  run_ = Run::Running;
  end_.clear();
  plan_->steps().begin();
  refresh();
}

void PlanPage::showExecution(const ExecutePlanFeedback& feedback) {
  run_ = Run::Running;
  // A plan that this one displaces ends after its goal was heard.
  end_.clear();
  PlanModel& steps = plan_->steps();
  if (feedback.new_plan.plan_id > 0) {
    if (feedback.new_plan.plan_id != steps.plan().plan_id)
      steps.show(boost::make_shared<Plan>(feedback.new_plan));
  } else if (feedback.plan_id != steps.plan().plan_id && feedback.plan_id == latest_->plan_id &&
             latest_->session_id == session_) {
    steps.show(latest_);
  }
  steps.hear(feedback);
  refresh();
}

void PlanPage::endExecution(const ExecutePlanResult& result) {
  const bool success = result.outcome == ExecutePlanResult::SUCCESS;
  plan_->steps().end(result);
  run_ = success ? Run::Done : Run::Failed;
  end_ = success ? QStringLiteral("Carried out.")
                 : QStringLiteral("Not carried out: %1").arg(QString::fromStdString(result.reason));
  refresh();
}

void PlanPage::setAnswerable(bool answerable) {
  answerable_ = answerable;
  refresh();
}

QString PlanPage::headline() const {
  const PlanModel& steps = plan_->steps();
  switch (run_) {
    case Run::Running:
      return steps.runningStep() < 0 ? QStringLiteral("Carrying out the plan")
                                     : QStringLiteral("Carrying out step %1 of %2")
                                           .arg(steps.runningStep() + 1)
                                           .arg(steps.stepCount());
    case Run::Done:
      return QStringLiteral("The plan was carried out");
    case Run::Failed:
      return QStringLiteral("The plan was not carried out");
    default:
      return {};
  }
}

QString PlanPage::promise() const {
  const Plan& plan = plan_->steps().plan();
  if (plan.plan_id == 0) return {};
  QStringList lines;
  addLine(lines,
          run_ == Run::Failed ? QStringLiteral("Not promised any more")
          : run_ == Run::Done ? QStringLiteral("Done")
                              : QStringLiteral("Guaranteed"),
          plan.guaranteed);
  if (run_ != Run::Failed)
    addLine(lines, QStringLiteral("Also kept, though nobody asked for it"), plan.kept_unasked);
  addLine(lines, QStringLiteral("Left out"), plan.not_wanted);
  addLine(lines, QStringLiteral("Not promised, and nobody was asked"), plan.assumed_not_wanted);
  return lines.join('\n');
}

void PlanPage::refresh() {
  const Plan& plan = plan_->steps().plan();
  QStringList notes;
  if (!end_.isEmpty()) notes << end_;
  const QString promised = promise();
  if (!promised.isEmpty()) notes << promised;
  note_->say(notes.join('\n'));
  const bool idle = answerable_ && !under_way_ && !isExecuting();
  const bool ready = plan.plan_id != 0 && plan.session_id == session_ && run_ == Run::None;
  do_it_->setVisible(ready);
  do_it_->setEnabled(idle);
  try_again_->setVisible(run_ == Run::Failed && !session_.empty());
  try_again_->setEnabled(idle);
}

}  // namespace goal_alignment::rviz_panel
