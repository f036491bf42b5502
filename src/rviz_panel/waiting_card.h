// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "goal_alignment/AlignmentState.h"
#include "text_widgets.h"

namespace goal_alignment::rviz_panel {

/// The tasks that wait until the plan under way has been carried out, each with a button that
/// withdraws it. Hidden while there are none.
class WaitingCard : public Card {
  Q_OBJECT

 public:
  explicit WaitingCard(QWidget* parent = nullptr);
  void show(const std::vector<WaitingTask>& tasks);

 signals:
  void withdrawn(const QString& goal_id);

 private:
  std::vector<WaitingTask> shown_;
  ShortScroll* scroll_;
};

}  // namespace goal_alignment::rviz_panel
