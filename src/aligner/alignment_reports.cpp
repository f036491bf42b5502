// SPDX-License-Identifier: BSD-3-Clause
// What the runner says about the session under way.
#include <chrono>
#include <optional>
#include <utility>

#include "alignment_runner.h"
#include "goal_alignment/ros_common/names.h"

namespace goal_alignment::aligner {

void AlignmentRunner::report(GoalTicket& ticket, const session::Snapshot& now,
                             const std::string& message) {
  const std::string plan_break = planBreak();
  if (plan_break != kept_.reported_divergence && !plan_break.empty()) {
    announcer_.tell(kept_.phrases.say("event_break", {plan_break}));
  }
  kept_.reported_divergence = plan_break;

  // First of all, for who sees the state may cancel at once, and then this is the result.
  ticket.setInterim(figures(now));
  AlignmentState state = stateMessage(now, message);
  // DONE comes with its outcome. A session that goes on, or is about to be told of, still thinks.
  if (state.phase == AlignmentState::DONE) state.phase = AlignmentState::ANALYSING;
  announcer_.publish(state);
  bridge_.markShown();
  shows_open_ = now.state == session::State::AwaitingAnswer;
  AlignFeedback feedback;
  feedback.phase = state.phase;
  feedback.progress = state.progress;
  feedback.question = open_;
  feedback.questions_asked = state.questions_asked;
  feedback.max_remaining = state.max_remaining;
  ticket.publishFeedback(feedback);
}

void AlignmentRunner::showToExplainer(const session::Snapshot& now) {
  ExplanationContext explained;
  explained.snapshot = now;
  if (const auto& question = kept_.session->question()) {
    explained.open_question = question->fluents;
    explained.open_why = ros_common::toMessage(*question, kept_.phrases).why;
    for (const session::Reason& reason : question->reasons)
      explained.open_conflicts.push_back(reason.conflict);
  }
  if (now.state == session::State::Done) {
    const session::Outcome& outcome = kept_.session->outcome();
    explained.outcome = outcome.code;
    explained.outcome_conflict = outcome.conflict;
    explained.plan = outcome.plan.steps;
  }
  explained.human_plan = kept_.human_plan;
  explained.human_plan_break = planBreak();
  explained.phrases = kept_.phrases;
  explainer_.show(std::move(explained));
}

void AlignmentRunner::answerSupposition() {
  explainer_.suppositions().answerOne(
      [this](const std::vector<Literal>& fluents) { return suppose(fluents); });
}

std::optional<Explain::Response> AlignmentRunner::suppose(const std::vector<Literal>& fluents) {
  const session::Snapshot now = kept_.session->snapshot();
  const WhatIfQuery supposed = supposition(fluents, now, kept_.phrases);
  if (!supposed.refusal.empty()) {
    Explain::Response response;
    response.text = supposed.refusal;
    return response;
  }
  const auto began = Clock::now();
  const session::Consequence consequence =
      kept_.session->whatIf(supposed.wanted, supposed.not_wanted, ros_common::kSupposeSeconds);
  if (consequence.kind == session::Consequence::Kind::Unknown) {
    // What is given up before its time is out does not become known by being tried again.
    const std::chrono::duration<double> took = Clock::now() - began;
    return took.count() < ros_common::kSupposeSeconds
               ? std::make_optional(notKnownYet(kept_.phrases))
               : std::nullopt;
  }
  return explainConsequence(supposed, consequence, kept_.session->snapshot(), kept_.phrases);
}

AlignmentState AlignmentRunner::stateMessage(const session::Snapshot& now,
                                             const std::string& message) const {
  AlignmentState state = ros_common::toMessage(now, kept_.phrases, kept_.times);
  state.session_id = kept_.id;
  state.task_id = kept_.task_id;
  state.person = kept_.person;
  state.message = message;
  state.human_plan_break = kept_.reported_divergence;
  return state;
}

AlignResult AlignmentRunner::figures(const session::Snapshot& now) const {
  const session::Statistics& statistics = kept_.session->statistics();
  AlignResult result;
  result.failing_step = -1;
  result.session_id = kept_.id;
  result.candidates = ros_common::toMessage(now, kept_.phrases, kept_.times).candidates;
  result.questions = static_cast<std::uint32_t>(now.questions_asked - kept_.questions_before);
  result.planner_calls = static_cast<std::uint32_t>(statistics.planner_calls - kept_.calls_before);
  result.thinking_time = statistics.total - kept_.thinking_before;
  result.waiting_time = kept_.waiting_time;
  return result;
}

std::string AlignmentRunner::spoken(const std::vector<Literal>& fluents) const {
  return kept_.phrases.clauses(fluents);
}

std::string AlignmentRunner::planBreak() const {
  const auto& violation = kept_.session->humanPlanViolation();
  if (!violation) return "";
  return kept_.phrases.failure(*violation, kept_.human_plan.at(violation->step));
}

std::string AlignmentRunner::storyOf(const AlignGoal& goal) const {
  const phrasing::Phrases& phrases = kept_.phrases;
  if (!goal.continue_session.empty()) return phrases.say("event_goes_on", {goal.continue_session});
  const std::string wish = goal.task.goal.empty()
                               ? phrases.say("event_goal_of_files")
                               : spoken(ros_common::toLiterals(goal.task.goal, "task.goal"));
  std::vector<std::string> of = {
      goal.task.plan.empty() ? phrases.say("event_without_plan", {wish})
                             : phrases.counted("event_with_plan", goal.task.plan.size(), {wish})};
  std::string name = "event_task";
  if (!goal.task.task_id.empty()) {
    name += "_named";
    of.push_back(goal.task.task_id);
  }
  if (!goal.task.person.empty()) {
    name += "_from";
    of.push_back(goal.task.person);
  }
  return phrases.say(name, of);
}

}  // namespace goal_alignment::aligner
