// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "goal_alignment/AlignmentState.h"

namespace goal_alignment::rviz_panel {

/// The answers so far, the oldest first.
class AnswerModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { Answer, Phrase, Change, Columns };
  enum Role { PddlRole = Qt::UserRole, StateRole };

  using QAbstractTableModel::QAbstractTableModel;

  void show(const AlignmentState& state);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  std::vector<Candidate> answered_;
};

}  // namespace goal_alignment::rviz_panel
