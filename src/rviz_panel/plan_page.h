// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QPushButton>
#include <QWidget>
#include <string>

#include "goal_alignment/ExecutePlanFeedback.h"
#include "goal_alignment/ExecutePlanResult.h"
#include "goal_alignment/Plan.h"
#include "tables.h"
#include "text_widgets.h"

namespace goal_alignment::rviz_panel {

/// The plan of the session that is shown: its steps, how far its execution has come, what it
/// promises, and buttons to have it carried out or to try again.
class PlanPage : public QWidget {
  Q_OBJECT

 public:
  explicit PlanPage(QWidget* parent = nullptr);

  void clear();
  /// A plan of another session says nothing about this one. `under_way`: a plan is still sought.
  void showSession(const std::string& session_id, bool under_way);
  void showPlan(const Plan::ConstPtr& plan);
  void beginExecution();
  void showExecution(const ExecutePlanFeedback& feedback);
  void endExecution(const ExecutePlanResult& result);
  /// False: there is nobody who could do anything.
  void setAnswerable(bool answerable);

  bool isExecuting() const { return run_ == Run::Running; }
  /// How the execution goes or has gone; "" where there was none of the plan shown.
  QString headline() const;
  int stepCount() const { return plan_->steps().stepCount(); }

 signals:
  void newPlanShown();
  void executionWanted(const goal_alignment::Plan& plan);
  void retried(const QString& session_id);

 private:
  enum class Run { None, Running, Done, Failed };

  void takeUpNewPlan();
  void refresh();
  QString promise() const;

  std::string session_;
  bool under_way_ = false;
  bool answerable_ = true;
  Plan::ConstPtr latest_ = boost::make_shared<Plan>();
  Run run_ = Run::None;
  QString end_;  // how it ended

  PlanTable* plan_;
  WrappedLabel* note_;
  QPushButton* do_it_;
  QPushButton* try_again_;
};

}  // namespace goal_alignment::rviz_panel
