// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "announcer.h"
#include "ask_human_client.h"
#include "goal_alignment/Question.h"
#include "goal_alignment/session/session.h"
#include "goal_ticket.h"
#include "question_bridge.h"
#include "session_record.h"
#include "state_reporter.h"

namespace goal_alignment::aligner {

/// The question that the current session waits for: asks it, keeps what is shown of it up to date,
/// asks again after a timeout, and withdraws it. Belongs to the solver thread.
class OpenQuestion {
 public:
  using Clock = QuestionBridge::Clock;

  /// All outlive this.
  OpenQuestion(SessionRecord& current, Announcer& announcer, QuestionBridge& bridge,
               AskHumanClient& ask_human, StateReporter& reporter);

  /// As published last; question_id 0: no question is open.
  const Question& message() const { return message_; }
  bool isOpen() const { return message_.question_id != 0; }
  /// When it times out; the largest time point: never.
  Clock::time_point deadline() const { return deadline_; }

  /// Asks what the session asks now, or refreshes what is shown if that is asked already. False: an
  /// answer came in meanwhile, which has to be applied first.
  bool ask(GoalTicket& ticket, const session::Snapshot& now);
  /// The session asks the same question after an answer, but what may follow from it has changed.
  void updateView();
  /// The deadline has passed without an answer: the question will be asked again, or the session
  /// ends after the last retry.
  void onTimeout();
  /// Dialogue nodes drop an answered question at once, not only when the next one is known.
  void closeIfAnswered();
  void close();

 private:
  bool isAsked(const session::QuestionView& view) const;
  bool open(GoalTicket& ticket, const session::Snapshot& now);
  void refresh(GoalTicket& ticket, const session::Snapshot& now);
  void startTimeout();
  void publish(GoalTicket& ticket, const session::Snapshot& now);
  void hide();  // it can still be answered

  SessionRecord& current_;
  Announcer& announcer_;
  QuestionBridge& bridge_;
  AskHumanClient& ask_human_;
  StateReporter& reporter_;
  Question message_;
  session::QuestionView view_;  // as the session asks it
  Clock::time_point deadline_;
};

}  // namespace goal_alignment::aligner
