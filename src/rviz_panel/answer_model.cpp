// SPDX-License-Identifier: BSD-3-Clause
#include "answer_model.h"

#include <QDateTime>
#include <algorithm>

#include "wording.h"

namespace goal_alignment::rviz_panel {
namespace {

QString answerWord(std::uint8_t state) {
  switch (state) {
    case Candidate::WANTED:
      return QStringLiteral("Yes");
    case Candidate::NOT_WANTED:
      return QStringLiteral("No");
    default:
      return QStringLiteral("Don't know");
  }
}

QString toolTipOf(const Candidate& candidate) {
  QString text = pddlOf(candidate.fluent);
  if (!candidate.answered_by.empty())
    text += QStringLiteral("\nanswered by %1").arg(QString::fromStdString(candidate.answered_by));
  if (!candidate.answered_at.isZero()) {
    const QDateTime when = QDateTime::fromSecsSinceEpoch(candidate.answered_at.sec);
    text += QStringLiteral("\nat %1").arg(when.toString(QStringLiteral("hh:mm:ss")));
  }
  return text;
}

bool isSame(const Candidate& a, const Candidate& b) {
  return pddlOf(a.fluent) == pddlOf(b.fluent) && a.state == b.state &&
         a.answered_by == b.answered_by && a.answered_at == b.answered_at;
}

}  // namespace

void AnswerModel::show(const AlignmentState& state) {
  std::vector<Candidate> answered;
  std::copy_if(state.candidates.begin(), state.candidates.end(), std::back_inserter(answered),
               isAnswered);
  std::stable_sort(answered.begin(), answered.end(), [](const Candidate& a, const Candidate& b) {
    return a.answered_at < b.answered_at;
  });
  if (std::equal(answered_.begin(), answered_.end(), answered.begin(), answered.end(), isSame))
    return;
  beginResetModel();
  answered_ = std::move(answered);
  endResetModel();
}

int AnswerModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(answered_.size());
}

int AnswerModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : Columns;
}

QVariant AnswerModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const Candidate& candidate = answered_[index.row()];
  switch (role) {
    case Qt::DisplayRole:
      if (index.column() == Answer) return answerWord(candidate.state);
      if (index.column() == Phrase) return phraseOf(candidate.fluent);
      return QStringLiteral("change");
    case Qt::ToolTipRole:
      return toolTipOf(candidate);
    case PddlRole:
      return pddlOf(candidate.fluent);
    case StateRole:
      return int{candidate.state};
    default:
      return {};
  }
}

QVariant AnswerModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  static const QStringList titles = {QStringLiteral("Answer"), QStringLiteral("Does it matter?"),
                                     QString()};
  return titles.value(section);
}

}  // namespace goal_alignment::rviz_panel
