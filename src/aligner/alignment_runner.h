// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <exception>

#include "announcer.h"
#include "ask_human_client.h"
#include "explainer.h"
#include "explanation_feed.h"
#include "facts_follower.h"
#include "goal_alignment/session/session.h"
#include "goal_ticket.h"
#include "journal.h"
#include "open_question.h"
#include "outcome_reporter.h"
#include "plan_watch.h"
#include "question_bridge.h"
#include "robot_facts.h"
#include "running_goal.h"
#include "session_answers.h"
#include "session_record.h"
#include "session_starter.h"
#include "state_reporter.h"
#include "task_notes.h"
#include "tf_state_bridge.h"

namespace goal_alignment::aligner {

/// Takes one goal after the other through a session, on the solver thread, and keeps the last
/// session for goals that continue it.
class AlignmentRunner {
 public:
  /// Parts of the node that a session deals with. They outlive the runner.
  struct Dependencies {
    Announcer& announcer;
    QuestionBridge& bridge;
    AskHumanClient& ask_human;
    Journal& journal;
    RobotFacts& facts;
    TaskNotes& task_notes;
    TfStateBridge& tf;
    Explainer& explainer;
    PlanWatch& plan_watch;
  };

  AlignmentRunner(const ros::NodeHandle& private_node, const Dependencies& parts);

  /// Ends the goal, whatever happens. Of the solver thread.
  void run(GoalTicket& ticket);

  /// Claims the goal for a cancel and stops the work on it; false: it has ended already. The caller
  /// sends its result. Of any thread.
  bool cancel(GoalTicket& ticket);

  // While no goal runs, of the solver thread: what-if queries about the last session.
  bool hasQueries() const { return explanations_.hasQueries(); }
  void answerQuery() { explanations_.answerQuery(); }

 private:
  void runAccepted(GoalTicket& ticket);
  void loop(GoalTicket& ticket);
  session::Snapshot step();  // returns how things stand after it
  void onModelsLoaded();
  void applyAnswers();
  void waitForFacts(GoalTicket& ticket);
  void waitForAnswer(GoalTicket& ticket, const session::Snapshot& now);
  QuestionBridge::Wake waitForEvent();
  bool hasEnded();
  void finish(GoalTicket& ticket);
  void abort(GoalTicket& ticket, const std::exception& error);

  QuestionBridge& bridge_;
  TaskNotes& task_notes_;
  SessionRecord current_;
  SessionAnswers answers_;
  SessionStarter starter_;
  FactsFollower facts_;
  StateReporter states_;
  ExplanationFeed explanations_;
  OpenQuestion question_;
  OutcomeReporter outcomes_;
  RunningGoal running_;
};

}  // namespace goal_alignment::aligner
