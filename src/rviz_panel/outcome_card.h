// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "goal_alignment/AlignmentState.h"
#include "text_widgets.h"

namespace goal_alignment::rviz_panel {

/// How an alignment without a plan ended: why, what can't be had together, and the alternatives as
/// buttons. Hidden otherwise.
class OutcomeCard : public Card {
  Q_OBJECT

 public:
  explicit OutcomeCard(QWidget* parent = nullptr);
  void show(const AlignmentState& state);

 signals:
  void takenUp(const QString& session_id, const std::vector<goal_alignment::Fluent>& given_up);

 private:
  void showAlternatives(const AlignmentState& state);

  AlignmentState shown_;
  WrappedLabel* headline_;
  WrappedLabel* message_;
  WrappedLabel* conflict_;
  WrappedLabel* offer_;
  ShortScroll* scroll_;
};

}  // namespace goal_alignment::rviz_panel
