// SPDX-License-Identifier: BSD-3-Clause
#include "state_reporter.h"

#include <algorithm>
#include <vector>

namespace goal_alignment::aligner {

StateReporter::StateReporter(const SessionRecord& current, Announcer& announcer,
                             QuestionBridge& bridge)
    : current_(current), announcer_(announcer), bridge_(bridge) {}

void StateReporter::announceGoal(const AlignGoal& goal) {
  announcer_.tell(goal.continue_session.empty()
                      ? taskText(goal.task)
                      : current_.phrases.say("event_goes_on", {goal.continue_session}));
}

std::string StateReporter::taskText(const HumanTask& task) const {
  const phrasing::Phrases& phrases = current_.phrases;
  const std::string wish = task.goal.empty()
                               ? phrases.say("event_goal_of_files")
                               : current_.clausesOf(ros_common::toLiterals(task.goal, "task.goal"));
  std::vector<std::string> arguments = {
      task.plan.empty() ? phrases.say("event_without_plan", {wish})
                        : phrases.counted("event_with_plan", task.plan.size(), {wish})};
  std::string name = "event_task";
  if (!task.task_id.empty()) {
    name += "_named";
    arguments.push_back(task.task_id);
  }
  if (!task.person.empty()) {
    name += "_from";
    arguments.push_back(task.person);
  }
  return phrases.say(name, arguments);
}

void StateReporter::warnAboutUnmatchedHidden() {
  const session::Snapshot now = current_.session->snapshot();
  const session::Options& options = current_.options.session;
  for (const auto* hidden :
       {&options.assumed_wanted_predicates, &options.assumed_unwanted_predicates}) {
    for (const std::string& predicate : *hidden)
      warnIfUnmatched(predicate, now);
  }
}

void StateReporter::warnIfUnmatched(const std::string& predicate, const session::Snapshot& now) {
  const bool matched = std::any_of(
      now.candidates.begin(), now.candidates.end(),
      [&](const session::CandidateView& view) { return view.fluent.atom.name == predicate; });
  if (matched) return;
  announcer_.warn(current_.phrases.say("event_hidden_unknown", {predicate}));
}

void StateReporter::report(GoalTicket& ticket, const session::Snapshot& now,
                           const std::string& message, const Question& open) {
  reportPlanBreak();
  // Before anything is published: whoever sees the state may cancel at once, and then this is the
  // result.
  ticket.setInterim(current_.usageResult(now));
  AlignmentState state = stateMessage(now, message);
  // DONE is published together with the outcome. Until then the session is still thinking.
  if (state.phase == AlignmentState::DONE) state.phase = AlignmentState::ANALYSING;
  announcer_.publish(state);
  bridge_.markShown();
  shows_open_question_ = now.state == session::State::AwaitingAnswer;
  AlignFeedback feedback;
  feedback.phase = state.phase;
  feedback.progress = state.progress;
  feedback.question = open;
  feedback.questions_asked = state.questions_asked;
  feedback.max_remaining = state.max_remaining;
  ticket.publishFeedback(feedback);
}

void StateReporter::reportPlanBreak() {
  const std::string plan_break = current_.planBreak();
  if (plan_break != reported_plan_break_ && !plan_break.empty()) {
    announcer_.tell(current_.phrases.say("event_break", {plan_break}));
  }
  reported_plan_break_ = plan_break;
}

AlignmentState StateReporter::stateMessage(const session::Snapshot& now,
                                           const std::string& message) const {
  AlignmentState state = current_.stateMessage(now);
  state.message = message;
  state.human_plan_break = reported_plan_break_;
  return state;
}

}  // namespace goal_alignment::aligner
