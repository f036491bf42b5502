// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QStringList>
#include <QTimer>
#include <memory>

#include "abandonable_worker.h"
#include "aligner_topics.h"
#include "goal_alignment/Answer.h"
#include "mailbox.h"

namespace goal_alignment::rviz_panel {

/// Speaks with one aligner for the panel. All signals come in the thread that owns it, no method
/// waits for anything: what may hang (the master, a service) hangs in a thread that is abandoned.
///
/// An aligner is There while its action server's status comes in, several times a second. When it
/// comes back after it was gone, everything latched is asked for anew, so that nothing of an
/// earlier run stays. Messages without a status are a Replay: there is nobody to answer to.
class AlignerLink : public QObject {
  Q_OBJECT

 public:
  enum class Presence { Absent, Replay, There };
  Q_ENUM(Presence)

  explicit AlignerLink(QObject* parent = nullptr);
  ~AlignerLink() override;

  /// Relative to rviz's namespace, "/robot/goal_alignment", or empty for none at all. An error says
  /// what is wrong with the name.
  QString connectTo(const QString& aligner);
  Presence presence() const { return presence_; }

  /// `fluents` as PDDL; see Answer.srv. Replied with replied().
  void answer(int answer, quint32 question_id, const QStringList& fluents,
              const QString& answered_by);
  void revise(int answer, const QStringList& fluents, const QString& answered_by);
  /// Continues the session without these fluents.
  void takeUp(const QString& session_id, const std::vector<Fluent>& given_up,
              const QString& answered_by);
  /// The task once more: the session goes on, or where there is none the last goal is sent again.
  void tryAgain(const QString& session_id, const QString& answered_by);
  void execute(const Plan& plan);
  void cancelAlignment();
  /// One task that waits.
  void withdraw(const QString& goal_id);
  void cancelExecution();

 signals:
  /// All that was heard so far is of no account any more.
  void cleared();
  /// Nothing can be heard of the aligner; `why` is for people.
  void failed(const QString& why);
  void presenceChanged(goal_alignment::rviz_panel::AlignerLink::Presence presence);
  void stateHeard(const goal_alignment::AlignmentState::ConstPtr& state);
  void questionHeard(const goal_alignment::Question::ConstPtr& question);
  void planHeard(const goal_alignment::Plan::ConstPtr& plan);
  void executionBegun();
  void executionHeard(const goal_alignment::ExecutePlanFeedback& feedback);
  void executionEnded(const goal_alignment::ExecutePlanResult& result);
  /// To answer(), revise(), takeUp() and what else is sent; `message` says why it was refused.
  void replied(bool accepted, const QString& message);

 private:
  struct Shared;

  void subscribe();
  Listener listener();
  template <typename Message>
  std::function<void(const boost::shared_ptr<const Message>&)> forward(
      void (AlignerLink::*take)(const boost::shared_ptr<const Message>&));
  void hear(const AlignmentState::ConstPtr& state);
  void hear(const Question::ConstPtr& question);
  void hear(const Plan::ConstPtr& plan);
  void hear(const AlignActionGoal::ConstPtr& goal);
  void hear(const AlignActionResult::ConstPtr& result);
  void hear(const ExecutePlanActionGoal::ConstPtr& goal);
  void hear(const ExecutePlanActionFeedback::ConstPtr& feedback);
  void hear(const ExecutePlanActionResult::ConstPtr& result);
  void send(AlignGoal goal);
  void call(const char* service, const Answer::Request& request);
  void look();
  void setPresence(Presence presence);
  bool isHeard() const;
  void noteMessage();

  std::string aligner_;  // resolved; "": none
  MailboxPtr mailbox_;
  std::shared_ptr<Shared> shared_;
  AbandonableWorker worker_;
  QTimer timer_;
  Presence presence_ = Presence::Absent;
  bool was_there_ = false;       // and is gone
  QElapsedTimer first_message_;  // since the aligner was last There
  std::string last_goal_;        // of ours
  AlignGoal::ConstPtr task_;     // the last one that began a session
};

}  // namespace goal_alignment::rviz_panel
