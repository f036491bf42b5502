// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QAbstractTableModel>
#include <boost/make_shared.hpp>
#include <vector>

#include "goal_alignment/ExecutePlanFeedback.h"
#include "goal_alignment/ExecutePlanResult.h"
#include "goal_alignment/Plan.h"

namespace goal_alignment::rviz_panel {

/// The steps of a plan, and how far its execution has come. What was done of earlier plans for the
/// same task stays above them.
class PlanModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { Mark, Text, Columns };
  enum Role { ProgressRole = Qt::UserRole };
  enum class Progress { Ahead, Running, Done, Failed };

  using QAbstractTableModel::QAbstractTableModel;

  void show(const Plan::ConstPtr& plan);
  void clear();
  /// Execution begins at the first step.
  void begin();
  /// Of another plan: nothing changes, since its steps are not these.
  void hear(const ExecutePlanFeedback& feedback);
  void end(const ExecutePlanResult& result);

  const Plan& plan() const { return *plan_; }
  int stepCount() const { return static_cast<int>(plan_->steps.size()); }
  /// Index of the step in execution, -1: none.
  int runningStep() const;
  /// Where the plan's own steps begin.
  int firstRow() const { return static_cast<int>(done_.size()); }

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  struct Step {
    QString text;
    QString pddl;
    Progress progress;
  };

  Step stepOf(int row) const;
  Progress progressOf(int step) const;
  void move(int step, Progress progress);
  QString textOf(int step) const;
  void keepDone();

  std::vector<Step> done_;  // of earlier plans
  Plan::ConstPtr plan_ = boost::make_shared<Plan>();
  int step_ = -1;  // all before it are done
  Progress of_step_ = Progress::Ahead;
};

}  // namespace goal_alignment::rviz_panel
