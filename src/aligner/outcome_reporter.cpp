// SPDX-License-Identifier: BSD-3-Clause
#include "outcome_reporter.h"

#include <vector>

#include "goal_alignment/ros_common/message_conversion.h"
#include "goal_alignment/ros_common/stamp.h"
#include "outcome_text.h"

namespace goal_alignment::aligner {

using session::OutcomeCode;

OutcomeReporter::OutcomeReporter(const SessionRecord& current, const Sinks& sinks,
                                 SessionAnswers& answers, StateReporter& states,
                                 ExplanationFeed& explanations)
    : current_(current),
      sinks_(sinks),
      answers_(answers),
      states_(states),
      explanations_(explanations) {}

AlignResult OutcomeReporter::announce(const session::Outcome& outcome, const std::string& instead) {
  const session::Snapshot last = current_.session->snapshot();
  AlignResult result = resultOf(outcome, last, instead);
  if (outcome.code == OutcomeCode::Success) publishPlan(result);
  settleJournal(outcome.code);
  explanations_.show(last);
  publishState(last, result);
  sinks_.announcer.tell(current_.phrases.say(
      "event_outcome",
      {std::to_string(result.outcome), session::outcomeWord(outcome.code), result.message}));
  return result;
}

AlignResult OutcomeReporter::resultOf(const session::Outcome& outcome,
                                      const session::Snapshot& last,
                                      const std::string& instead) const {
  AlignResult result = current_.usageResult(last);
  const AlignResult said = ros_common::toMessage(outcome, current_.phrases);
  result.outcome = said.outcome;
  result.message = instead.empty()
                       ? spokenOutcome(outcome, last, current_.phrases, current_.human_plan)
                       : instead;
  result.conflict = said.conflict;
  result.conflict_proven = said.conflict_proven;
  result.conflict_minimal = said.conflict_minimal;
  result.alternatives = said.alternatives;
  result.failing_step = said.failing_step;
  return result;
}

void OutcomeReporter::publishPlan(AlignResult& result) {
  const SessionLabels& labels = current_.labels;
  result.plan = ros_common::toMessage(*current_.session, ++plans_, current_.phrases);
  result.plan.session_id = labels.id;
  result.plan.header.stamp = ros_common::stampNow();
  // Before anybody can have the plan.
  sinks_.plan_watch.onPlanPublished(
      {result.plan.plan_id, labels.task_id, labels.person, labels.goal_identity});
  sinks_.announcer.publish(result.plan);
}

void OutcomeReporter::settleJournal(OutcomeCode code) {
  if (session::outcomeTraits(code).closes_journal) sinks_.journal.drop();
  if (code == OutcomeCode::UnsureBlocks) answers_.forgetUnsureAnswers();
}

void OutcomeReporter::publishState(const session::Snapshot& last, const AlignResult& result) {
  AlignmentState state = states_.stateMessage(last, result.message);
  state.phase = AlignmentState::DONE;
  state.outcome = result.outcome;
  state.conflict = result.conflict;
  state.conflict_proven = result.conflict_proven;
  state.conflict_minimal = result.conflict_minimal;
  state.alternatives = result.alternatives;
  sinks_.announcer.publish(state);
  sinks_.bridge.markShown();
}

void OutcomeReporter::refuse(GoalTicket& ticket, const session::Outcome& outcome) {
  std::vector<std::string> why = {std::to_string(static_cast<int>(outcome.code)), outcome.message};
  const std::string& task = ticket.goal().task.task_id;
  if (!task.empty()) why.push_back(task);
  sinks_.announcer.tell(
      current_.phrases.say(task.empty() ? "event_refused" : "event_refused_named", why));
  if (ticket.claim()) endWith(ticket, outcome);
}

void OutcomeReporter::endWith(GoalTicket& ticket, const session::Outcome& outcome) {
  AlignResult result = ticket.interim();
  result.outcome = static_cast<std::uint16_t>(outcome.code);
  result.message = outcome.message;
  // Who sent the task by topic gets no result, so ~state has to say it. A session that could not be
  // continued stays as it was.
  if (ticket.goal().continue_session.empty()) {
    AlignmentState state;
    state.phase = AlignmentState::DONE;
    state.session_id = result.session_id;
    state.task_id = ticket.goal().task.task_id;
    state.person = ticket.goal().task.person;
    state.outcome = result.outcome;
    state.message = result.message;
    sinks_.announcer.publish(state);
  }
  ticket.sendResult(result);
}

}  // namespace goal_alignment::aligner
