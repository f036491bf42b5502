// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "goal_alignment/AlignmentState.h"
#include "text_widgets.h"

namespace goal_alignment::rviz_panel {

/// How an alignment without a plan ended: why, what can't be had together, and as buttons the
/// alternatives and another try. Hidden otherwise.
class OutcomeCard : public Card {
  Q_OBJECT

 public:
  explicit OutcomeCard(QWidget* parent = nullptr);
  void show(const AlignmentState& state);

 signals:
  void takenUp(const QString& session_id, const std::vector<goal_alignment::Fluent>& given_up);
  /// The task once more; `session_id` "": there is no session to go on with.
  void retried(const QString& session_id);

 private:
  void showAlternatives(const AlignmentState& state);

  AlignmentState shown_;
  WrappedLabel* headline_;
  WrappedLabel* message_;
  WrappedLabel* conflict_;
  ShortScroll* scroll_;
  QPushButton* again_;
};

}  // namespace goal_alignment::rviz_panel
