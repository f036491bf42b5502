// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QStringList>
#include <QTableView>

#include "answer_model.h"
#include "candidate_model.h"
#include "candidate_sorter.h"
#include "plan_model.h"

/// The three tables of the panel, each over its model.
namespace goal_alignment::rviz_panel {

/// Rows of text, with a line about what would stand here while there are none.
class RowTable : public QTableView {
  Q_OBJECT

 public:
  explicit RowTable(const QString& placeholder, QWidget* parent = nullptr);
  /// What is written where there are no rows.
  const QString& placeholder() const { return placeholder_; }
  void setPlaceholder(const QString& placeholder);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString placeholder_;
};

/// All candidates; answers are volunteered or changed from its context menu.
class CandidateTable : public RowTable {
  Q_OBJECT

 public:
  explicit CandidateTable(QWidget* parent = nullptr);
  CandidateModel& candidates() { return candidates_; }
  CandidateSorter& sorter() { return sorter_; }
  void setAnswerable(bool answerable) { answerable_ = answerable; }

 signals:
  void volunteered(int answer, const QStringList& fluents);
  void revised(int answer, const QStringList& fluents);

 protected:
  void contextMenuEvent(QContextMenuEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void addAnswers(QMenu& menu, const QStringList& fluents, bool answered);

  CandidateModel candidates_;
  CandidateSorter sorter_;
  bool answerable_ = true;
};

/// The answers so far, each with "change".
class AnswerTable : public RowTable {
  Q_OBJECT

 public:
  explicit AnswerTable(QWidget* parent = nullptr);
  AnswerModel& answers() { return answers_; }
  void setAnswerable(bool answerable) { answerable_ = answerable; }

 signals:
  void revised(int answer, const QStringList& fluents);

 private:
  void offerChange(const QModelIndex& index);

  AnswerModel answers_;
  bool answerable_ = true;
};

/// The plan; keeps the step in execution in view.
class PlanTable : public RowTable {
  Q_OBJECT

 public:
  explicit PlanTable(QWidget* parent = nullptr);
  PlanModel& steps() { return steps_; }

 private:
  PlanModel steps_;
};

}  // namespace goal_alignment::rviz_panel
