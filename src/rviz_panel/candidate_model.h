// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QAbstractTableModel>
#include <QStringList>
#include <boost/make_shared.hpp>

#include "goal_alignment/AlignmentState.h"

namespace goal_alignment::rviz_panel {

/// The candidates of a state as rows. A newer state of the same candidates changes only the rows
/// that differ, so that selection, scrolling and sorting stay.
class CandidateModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { Phrase, Belief, State, Columns };
  enum Role {
    SortRole = Qt::UserRole,
    PddlRole,        // QString
    StateRole,       // int, of Candidate
    BeliefRole,      // double
    AnsweredRole,    // bool: answered by somebody
    AnswerableRole,  // bool: ~answer or ~revise_answer would take it
  };

  using QAbstractTableModel::QAbstractTableModel;

  void show(const AlignmentState::ConstPtr& state);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  bool hasSameRows(const AlignmentState& state) const;
  void announceChanges(const AlignmentState& before);
  QVariant textOf(const Candidate& candidate, int column) const;
  QVariant sortKeyOf(const Candidate& candidate, int column) const;
  QString toolTipOf(const Candidate& candidate) const;

  AlignmentState::ConstPtr state_ = boost::make_shared<AlignmentState>();
};

}  // namespace goal_alignment::rviz_panel
