// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <chrono>
#include <cstdint>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "announcer.h"
#include "ask_human_client.h"
#include "explainer.h"
#include "goal_alignment/ros_common/message_conversion.h"
#include "goal_alignment/session/session.h"
#include "goal_ticket.h"
#include "journal.h"
#include "node_options.h"
#include "plan_watch.h"
#include "question_bridge.h"
#include "robot_facts.h"
#include "tf_state_bridge.h"
#include "under_way.h"

namespace goal_alignment::aligner {

/// Takes one goal after the other through a session, from the solver thread, and keeps the last
/// session for goals that continue it.
class AlignmentRunner {
 public:
  /// The parts of the node that a session meets. They outlive the runner.
  struct Parts {
    Announcer& announcer;
    QuestionBridge& bridge;
    AskHumanClient& ask_human;
    Journal& journal;
    RobotFacts& facts;
    UnderWay& under_way;
    TfStateBridge& tf;
    Explainer& explainer;
    PlanWatch& plan_watch;
  };

  AlignmentRunner(ros::NodeHandle private_node, const Parts& parts);

  /// Ends the goal, whatever happens. Of the solver thread.
  void run(GoalTicket& ticket);

  /// Claims the goal for a cancel and stops the work on it; false: it has ended already. The caller
  /// concludes it. Of any thread.
  bool stop(GoalTicket& ticket);

  // While no goal runs, of the solver thread: what onlookers suppose of the last session.
  bool isAskedToSuppose() const { return !explainer_.suppositions().empty(); }
  void answerSupposition();

 private:
  using Clock = QuestionBridge::Clock;
  using State = session::State;

  // A session and what the node knows about it.
  struct Kept {
    std::string id;
    std::string person;
    std::string task_id;
    std::string identity;  // of the goal that began it
    std::shared_ptr<session::Session> session;
    std::vector<GroundName> human_plan;
    phrasing::Phrases phrases;
    ros_common::AnswerTimes times;
    NodeOptions options;
    double waiting_time = 0;     // seconds, of the goal under way
    double thinking_before = 0;  // seconds, of earlier goals
    std::size_t calls_before = 0;
    std::size_t questions_before = 0;
    std::string reported_divergence;  // what was said about the human's plan
    bool models_known = false;
    unsigned facts_seen = 0;  // RobotFacts::version()
    spatial_facts::Observation seen;
    bool facts_known = false;  // since the goal under way began
    std::optional<Clock::time_point> unknown_since;
    std::set<GroundName> told_left_out;
    std::vector<JournalAnswer> journaled;  // not yet told to the session
    unsigned silences = 0;                 // how often the open question was put in vain
  };

  // Before the goal is accepted; they throw.
  void prepare(const AlignGoal& goal);
  void begin(const AlignGoal& goal, const NodeOptions& options);
  void continueSession(const AlignGoal& goal, const NodeOptions& options);
  void warnAboutUnknown(const NodeOptions& options);

  void loop(GoalTicket& ticket);
  session::Snapshot step();  // and how things stand after it
  void onModelsLoaded();
  void warnIfNobodyIs(const std::string& hidden, const session::Snapshot& now);
  bool hasEnded();
  bool claimOutcome(GoalTicket& ticket);
  void conclude(GoalTicket& ticket);
  AlignResult announceOutcome(const session::Outcome& outcome, const std::string& instead);
  void abort(GoalTicket& ticket, const std::exception& error);
  void refuse(GoalTicket& ticket, const session::Outcome& outcome);
  void endWith(GoalTicket& ticket, const session::Outcome& outcome);

  // alignment_facts.cpp: what is so in the robot's world
  void inheritFacts(const NodeOptions& options, session::Input& input);
  void checkRules();
  void takeUpFacts();
  void missFacts(const spatial_facts::Observation& seen);
  bool patienceLasts();
  void applyFacts(const spatial_facts::Observation& seen, bool is_first);
  bool factsAreAwaited() const;
  bool factsHaveChanged();
  void awaitFacts(GoalTicket& ticket);
  Clock::time_point nextLook() const;

  // alignment_answers.cpp: how questions are put, and what becomes of the answers
  std::vector<Literal> candidatesOf(const std::vector<Fluent>& fluents,
                                    const std::string& field) const;
  void takeUpJournal();
  void applyAnswers();
  void apply(const AcceptedAnswer& answer);
  session::SubmitResult applyToSession(const AcceptedAnswer& answer);
  std::vector<JournalAnswer> journalAnswers() const;
  void forgetUnsureAnswers();
  std::set<Literal> answered() const;
  void waitForAnswer(GoalTicket& ticket, const session::Snapshot& now);
  QuestionBridge::Wake waitForEvent();
  void onAnswerTimeout();
  bool openQuestion(GoalTicket& ticket, const session::Snapshot& now);
  void refreshQuestion(GoalTicket& ticket, const session::Snapshot& now);
  void beginPatience();
  void putQuestion(GoalTicket& ticket, const session::Snapshot& now);
  void closeQuestion();
  void hideQuestion();  // it can still be answered

  // alignment_reports.cpp: what is said about the session
  void report(GoalTicket& ticket, const session::Snapshot& now, const std::string& message);
  void showToExplainer(const session::Snapshot& now);
  std::optional<Explain::Response> suppose(const std::vector<Literal>& fluents);
  AlignmentState stateMessage(const session::Snapshot& now, const std::string& message) const;
  AlignResult figures(const session::Snapshot& now) const;
  std::string spoken(const std::vector<Literal>& fluents) const;
  std::string planBreak() const;
  std::string storyOf(const AlignGoal& goal) const;

  ros::NodeHandle private_node_;
  Announcer& announcer_;
  QuestionBridge& bridge_;
  AskHumanClient& ask_human_;
  Journal& journal_;
  RobotFacts& facts_;
  UnderWay& under_way_;
  TfStateBridge& tf_;
  Explainer& explainer_;
  PlanWatch& plan_watch_;
  Kept kept_;
  Question open_;                    // question_id 0: none
  session::QuestionView open_view_;  // as the session asked it
  Clock::time_point open_until_;
  bool shows_open_ = false;  // the state that was published last says that the question is open
  std::int32_t plans_ = 0;
  std::set<std::string> warned_about_;

  std::mutex running_mutex_;             // a goal ends by its outcome or by a cancel, never both
  const GoalTicket* running_ = nullptr;  // whose session kept_.session is
};

}  // namespace goal_alignment::aligner
