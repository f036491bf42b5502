// SPDX-License-Identifier: BSD-3-Clause
#include "candidate_sorter.h"

#include "candidate_model.h"

namespace goal_alignment::rviz_panel {

void CandidateSorter::filter(const QString& text) {
  text_ = text.trimmed();
  invalidateFilter();
}

bool CandidateSorter::filterAcceptsRow(int row, const QModelIndex& parent) const {
  if (text_.isEmpty()) return true;
  const QModelIndex index = sourceModel()->index(row, CandidateModel::Phrase, parent);
  return index.data(Qt::DisplayRole).toString().contains(text_, Qt::CaseInsensitive) ||
         index.data(CandidateModel::PddlRole).toString().contains(text_, Qt::CaseInsensitive);
}

bool CandidateSorter::lessThan(const QModelIndex& left, const QModelIndex& right) const {
  if (left.column() == CandidateModel::Phrase) {
    return QString::localeAwareCompare(left.data(CandidateModel::SortRole).toString(),
                                       right.data(CandidateModel::SortRole).toString()) < 0;
  }
  const double a = left.data(CandidateModel::SortRole).toDouble();
  const double b = right.data(CandidateModel::SortRole).toDouble();
  if (a != b) return a < b;
  return left.data(CandidateModel::BeliefRole).toDouble() >
         right.data(CandidateModel::BeliefRole).toDouble();
}

}  // namespace goal_alignment::rviz_panel
