// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QTabWidget>
#include <QWidget>

#include "aligner_link.h"
#include "outcome_card.h"
#include "plan_page.h"
#include "question_card.h"
#include "tables.h"
#include "waiting_card.h"

namespace goal_alignment::rviz_panel {

/// All that the panel shows of one aligner, and what a person does about it, as signals. Knows
/// messages only: who brings them and where answers go is not its business.
class AlignmentView : public QWidget {
  Q_OBJECT

 public:
  explicit AlignmentView(QWidget* parent = nullptr);

  QString aligner() const { return aligner_->text(); }
  QString answeredBy() const { return answered_by_->text(); }
  void setAligner(const QString& name) { aligner_->setText(name); }
  void setAnsweredBy(const QString& name) { answered_by_->setText(name); }

 public slots:
  void clear();
  /// Why nothing of the aligner can be shown.
  void showFault(const QString& fault);
  void showPresence(goal_alignment::rviz_panel::AlignerLink::Presence presence);
  void showState(const goal_alignment::AlignmentState::ConstPtr& state);
  void showQuestion(const goal_alignment::Question::ConstPtr& question);
  void showPlan(const goal_alignment::Plan::ConstPtr& plan);
  void beginExecution();
  void showExecution(const goal_alignment::ExecutePlanFeedback& feedback);
  void endExecution(const goal_alignment::ExecutePlanResult& result);
  /// The reply to what was asked for last.
  void showReply(bool accepted, const QString& message);

 signals:
  void answered(int answer, quint32 question_id, const QStringList& fluents);
  void revised(int answer, const QStringList& fluents);
  void takenUp(const QString& session_id, const std::vector<goal_alignment::Fluent>& given_up);
  /// The task once more; "": without a session to go on with.
  void retried(const QString& session_id);
  void executionWanted(const goal_alignment::Plan& plan);
  /// One of the tasks that wait.
  void withdrawn(const QString& goal_id);
  void alignmentCanceled();
  void executionCanceled();
  void alignerEdited(const QString& name);
  void answeredByEdited(const QString& name);

 private:
  using Presence = AlignerLink::Presence;

  QWidget* header();
  QWidget* tabs();
  QWidget* footer();
  void connectParts();
  void showHeader();
  QString statusText() const;
  void showCards();
  void showTabs();
  void tell(const QString& notice);

  Presence presence_ = Presence::Absent;
  AlignmentState::ConstPtr state_ = boost::make_shared<AlignmentState>();
  Question::ConstPtr question_ = boost::make_shared<Question>();

  QLabel* dot_;
  WrappedLabel* title_;
  WrappedLabel* status_;
  QProgressBar* progress_;
  QPushButton* cancel_;
  Card* notice_card_;
  WrappedLabel* notice_;
  QuestionCard* question_card_;
  OutcomeCard* outcome_card_;
  WaitingCard* waiting_card_;
  QTabWidget* tabs_;
  CandidateTable* candidates_;
  AnswerTable* answers_;
  PlanPage* plan_page_;
  QLineEdit* filter_;
  QLineEdit* aligner_;
  QLineEdit* answered_by_;
};

}  // namespace goal_alignment::rviz_panel
