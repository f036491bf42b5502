// SPDX-License-Identifier: BSD-3-Clause
#include "alignment_runner.h"

#include <ros/console.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "goal_alignment/ros_common/message_conversion.h"

namespace goal_alignment::aligner {

using session::OutcomeCode;
using session::State;
using Clock = QuestionBridge::Clock;
using Wake = QuestionBridge::Wake;

AlignmentRunner::AlignmentRunner(const ros::NodeHandle& private_node, const Dependencies& parts)
    : bridge_(parts.bridge),
      task_notes_(parts.task_notes),
      answers_(current_, parts.journal,
               [&announcer = parts.announcer](const std::string& line) { announcer.tell(line); }),
      starter_(private_node, {parts.announcer, parts.bridge, parts.journal, parts.facts, parts.tf},
               current_, answers_),
      facts_(current_, parts.facts, parts.tf,
             [&announcer = parts.announcer](const std::string& line) { announcer.tell(line); }),
      states_(current_, parts.announcer, parts.bridge),
      explanations_(current_, parts.explainer),
      question_(current_, parts.announcer, parts.bridge, parts.ask_human, states_),
      outcomes_(current_, {parts.announcer, parts.bridge, parts.journal, parts.plan_watch},
                answers_, states_, explanations_) {}

bool AlignmentRunner::cancel(GoalTicket& ticket) {
  if (!running_.cancel(ticket)) return false;
  bridge_.interrupt();
  return true;
}

void AlignmentRunner::run(GoalTicket& ticket) {
  const std::optional<session::Outcome> refusal = starter_.start(ticket.goal());
  if (refusal) return outcomes_.refuse(ticket, *refusal);
  if (!ticket.continuesSession()) {
    facts_.beginSession();
    states_.beginSession();
  }
  facts_.beginGoal();
  running_.begin(ticket, current_.session);
  try {
    runAccepted(ticket);
  } catch (const std::exception& error) {
    abort(ticket, error);
  }
  task_notes_.end();
  running_.end();
}

void AlignmentRunner::runAccepted(GoalTicket& ticket) {
  ticket.accept();
  const SessionLabels& labels = current_.labels;
  if (current_.options.journal_expiry > 0)
    task_notes_.begin({labels.id, labels.task_id, labels.person});
  states_.announceGoal(ticket.goal());
  loop(ticket);
  finish(ticket);
}

// The session turns all of its own errors into outcomes, so this one is the node's.
void AlignmentRunner::abort(GoalTicket& ticket, const std::exception& error) {
  ROS_ERROR("the alignment was aborted: %s", error.what());
  question_.close();
  bridge_.endSession();
  outcomes_.refuse(ticket, session::outcomeOf(error));
}

void AlignmentRunner::loop(GoalTicket& ticket) {
  states_.report(ticket, current_.session->snapshot(), "", question_.message());
  while (!ticket.ended()) {
    applyAnswers();
    facts_.update();
    if (facts_.mustWait()) {
      waitForFacts(ticket);
      continue;
    }
    if (current_.session->state() == State::Done && hasEnded()) break;
    // A session that was resumed after the cancel has forgotten it, so the ticket has to be asked.
    if (ticket.ended()) break;
    const session::Snapshot now = step();
    if (now.state == State::Done) continue;  // answers and facts that came meanwhile still count
    if (now.state == State::AwaitingAnswer) {
      waitForAnswer(ticket, now);
      // One query at a time: an answer or a cancel may have come meanwhile.
      if (current_.session->state() == State::AwaitingAnswer) answerQuery();
      if (hasQueries()) bridge_.wakeUp();
    } else {
      states_.report(ticket, now, "", question_.message());
    }
  }
  question_.close();
  bridge_.endSession();
  // Answers accepted before a cancel count for the journal and for the session's next goal.
  if (ticket.ended()) applyAnswers();
}

session::Snapshot AlignmentRunner::step() {
  const auto began = Clock::now();
  const State state = current_.session->step();
  const std::chrono::duration<double> took = Clock::now() - began;
  ROS_DEBUG("a step of %.3f s led to phase %d", took.count(), int{ros_common::phaseOf(state)});
  if (!current_.models_loaded && current_.session->robotModel() != nullptr) onModelsLoaded();
  session::Snapshot now = current_.session->snapshot();
  bridge_.update(now);
  explanations_.show(now);
  return now;
}

void AlignmentRunner::onModelsLoaded() {
  current_.models_loaded = true;
  facts_.onModelsLoaded();
  answers_.restoreFromJournal();
  states_.warnAboutUnmatchedHidden();
}

void AlignmentRunner::applyAnswers() {
  const std::vector<AcceptedAnswer> answers = bridge_.take();
  for (const AcceptedAnswer& answer : answers) {
    answers_.apply(answer);
    // A declined dialogue is over; later answers must not begin it anew.
    if (current_.session->state() == State::Done) return;
  }
  // Volunteered or revised answers may have made the open question needless. New facts may as well,
  // but mostly they don't; then nobody should be asked once more.
  if (answers.empty()) return;
  if (current_.session->state() != State::AwaitingAnswer) return question_.close();
  question_.updateView();
}

void AlignmentRunner::waitForFacts(GoalTicket& ticket) {
  states_.report(ticket, current_.session->snapshot(), "waiting for tf: " + facts_.missingFacts(),
                 question_.message());
  while (bridge_.wait(facts_.nextLook()) == Wake::TimedOut) {
    if (!facts_.isWithinTimeout()) return;
  }
}

void AlignmentRunner::waitForAnswer(GoalTicket& ticket, const session::Snapshot& now) {
  const auto began = Clock::now();
  if (!question_.ask(ticket, now)) return;
  const Wake wake = waitForEvent();
  const std::chrono::duration<double> waited = Clock::now() - began;
  current_.usage.waiting_time += waited.count();
  if (wake == Wake::TimedOut) question_.onTimeout();
  question_.closeIfAnswered();
}

// Like bridge_.wait() until the question's deadline; new facts end it as well.
QuestionBridge::Wake AlignmentRunner::waitForEvent() {
  const Clock::time_point deadline = question_.deadline();
  while (true) {
    const Wake wake = bridge_.wait(std::min(deadline, facts_.nextLook()));
    if (wake != Wake::TimedOut || Clock::now() >= deadline) return wake;
    if (facts_.haveChanged()) return Wake::News;
  }
}

// An answer that came in during the last step was accepted, so it has to count.
bool AlignmentRunner::hasEnded() {
  if (session::outcomeTraits(current_.session->outcome().code).ended_on_request) return true;
  return bridge_.endSessionIfIdle();
}

void AlignmentRunner::finish(GoalTicket& ticket) {
  const bool claimed = running_.claimOutcome(ticket);
  session::Outcome outcome;
  if (claimed) {
    outcome = current_.session->outcome();
  } else {
    outcome.code = OutcomeCode::Canceled;
    outcome.message = "canceled";
  }
  try {
    const AlignResult result = outcomes_.announce(
        outcome, ticket.isDisplaced() ? current_.phrases.say("outcome_displaced") : "");
    if (claimed) ticket.sendResult(result);
  } catch (const std::exception& error) {
    // Whoever claims a goal owes its client a result, even if the outcome can't be put into words.
    ROS_ERROR("the outcome %d can't be published: %s",
              int{static_cast<std::uint16_t>(outcome.code)}, error.what());
    if (claimed) outcomes_.endWith(ticket, session::outcomeOf(error));
  }
}

}  // namespace goal_alignment::aligner
