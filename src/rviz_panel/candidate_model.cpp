// SPDX-License-Identifier: BSD-3-Clause
#include "candidate_model.h"

#include <algorithm>

#include "wording.h"

namespace goal_alignment::rviz_panel {
namespace {

constexpr int kNamedConflicts = 8;  // a tooltip has to fit on the screen

bool isSame(const Fluent& a, const Fluent& b) {
  return a.name == b.name && a.negated == b.negated && a.args == b.args && a.text == b.text;
}

bool looksSame(const Candidate& a, const Candidate& b) {
  return a.state == b.state && a.probability == b.probability && a.conflicts == b.conflicts &&
         a.achievable == b.achievable && a.answered_by == b.answered_by;
}

// What the person has a say in comes first, then what was said, then the rest.
int rankOf(std::uint8_t state) {
  constexpr std::uint8_t kOrder[] = {Candidate::ASKED,  Candidate::OPEN,       Candidate::UNSURE,
                                     Candidate::WANTED, Candidate::NOT_WANTED, Candidate::SPECIFIED,
                                     Candidate::SETTLED};
  return static_cast<int>(std::find(std::begin(kOrder), std::end(kOrder), state) -
                          std::begin(kOrder));
}

}  // namespace

void CandidateModel::show(const AlignmentState::ConstPtr& state) {
  if (!hasSameRows(*state)) {
    beginResetModel();
    state_ = state;
    endResetModel();
    return;
  }
  const AlignmentState::ConstPtr before = state_;
  state_ = state;
  announceChanges(*before);
}

bool CandidateModel::hasSameRows(const AlignmentState& state) const {
  const auto& mine = state_->candidates;
  const auto& other = state.candidates;
  return std::equal(
      mine.begin(), mine.end(), other.begin(), other.end(),
      [](const Candidate& a, const Candidate& b) { return isSame(a.fluent, b.fluent); });
}

// One signal for all: a sorter that hears of the rows one by one would sort each among others that
// it has not heard of yet.
void CandidateModel::announceChanges(const AlignmentState& before) {
  int first = -1;
  int last = -1;
  for (int row = 0; row < rowCount(); ++row) {
    if (looksSame(before.candidates[row], state_->candidates[row])) continue;
    if (first < 0) first = row;
    last = row;
  }
  if (first >= 0) emit dataChanged(index(first, 0), index(last, Columns - 1));
}

int CandidateModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(state_->candidates.size());
}

int CandidateModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : Columns;
}

QVariant CandidateModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const Candidate& candidate = state_->candidates[index.row()];
  switch (role) {
    case Qt::DisplayRole:
      return textOf(candidate, index.column());
    case Qt::ToolTipRole:
      return toolTipOf(candidate);
    case SortRole:
      return sortKeyOf(candidate, index.column());
    case PddlRole:
      return pddlOf(candidate.fluent);
    case StateRole:
      return int{candidate.state};
    case BeliefRole:
      return candidate.probability;
    case AnsweredRole:
      return isAnswered(candidate);
    case AnswerableRole:
      return candidate.state != Candidate::SPECIFIED;
    default:
      return {};
  }
}

QVariant CandidateModel::textOf(const Candidate& candidate, int column) const {
  if (column == Phrase) return phraseOf(candidate.fluent);
  if (column == Belief) return percent(candidate.probability);
  return stateWord(candidate.state);
}

QVariant CandidateModel::sortKeyOf(const Candidate& candidate, int column) const {
  if (column == Phrase) return phraseOf(candidate.fluent);
  if (column == Belief) return candidate.probability;
  return rankOf(candidate.state);
}

QString CandidateModel::toolTipOf(const Candidate& candidate) const {
  QStringList lines = {sentence(phraseOf(candidate.fluent)), pddlOf(candidate.fluent),
                       QStringLiteral("%1, wanted with %2")
                           .arg(stateWord(candidate.state), percent(candidate.probability))};
  if (candidate.state == Candidate::SETTLED)
    lines << QStringLiteral("whatever you say of it, the outcome is the same");
  if (!candidate.answered_by.empty())
    lines << QStringLiteral("answered by %1").arg(QString::fromStdString(candidate.answered_by));
  if (!candidate.achievable) lines << QStringLiteral("can't be had with what was asked for");
  int named = 0;
  for (const std::uint16_t index : candidate.conflicts) {
    if (index >= state_->conflicts.size()) continue;
    if (++named > kNamedConflicts) continue;
    const Conflict& conflict = state_->conflicts[index];
    if (conflict.fluents.size() < 2) continue;
    lines << QStringLiteral("can't all be had%1: %2")
                 .arg(conflict.proven != 0 ? QString() : QStringLiteral(" (suspected)"),
                      phrasesOf(conflict.fluents).join(QStringLiteral("; ")));
  }
  if (named > kNamedConflicts)
    lines << QStringLiteral("and %1 more conflicts").arg(named - kNamedConflicts);
  return lines.join('\n');
}

QVariant CandidateModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  static const QStringList titles = {QStringLiteral("What you may want"), QStringLiteral("Chance"),
                                     QStringLiteral("So far")};
  return titles.value(section);
}

}  // namespace goal_alignment::rviz_panel
