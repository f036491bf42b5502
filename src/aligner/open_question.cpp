// SPDX-License-Identifier: BSD-3-Clause
#include "open_question.h"

#include <fmt/format.h>

#include <chrono>
#include <string>
#include <utility>

#include "goal_alignment/ros_common/message_conversion.h"

namespace goal_alignment::aligner {
namespace {

bool isUnanswered(const session::Snapshot& snapshot, const Literal& fluent) {
  const session::CandidateView* candidate = snapshot.candidateOf(fluent);
  return candidate != nullptr && candidate->state == session::CandidateState::Asked;
}

// Without those fluents of the group that were answered already.
session::QuestionView unansweredPart(const session::QuestionView& view,
                                     const session::Snapshot& now) {
  session::QuestionView part = view;
  part.fluents.clear();
  part.reasons.clear();
  part.probabilities.clear();
  for (std::size_t i = 0; i < view.fluents.size(); ++i) {
    if (!isUnanswered(now, view.fluents[i])) continue;
    part.fluents.push_back(view.fluents[i]);
    part.reasons.push_back(view.reasons[i]);
    part.probabilities.push_back(view.probabilities[i]);
  }
  return part;
}

}  // namespace

OpenQuestion::OpenQuestion(SessionRecord& current, Announcer& announcer, QuestionBridge& bridge,
                           AskHumanClient& ask_human, StateReporter& reporter)
    : current_(current),
      announcer_(announcer),
      bridge_(bridge),
      ask_human_(ask_human),
      reporter_(reporter) {}

bool OpenQuestion::ask(GoalTicket& ticket, const session::Snapshot& now) {
  const session::QuestionView& view = *current_.session->question();
  if (!isAsked(view)) return open(ticket, now);
  view_ = view;
  refresh(ticket, now);
  if (!reporter_.showsOpenQuestion()) reporter_.report(ticket, now, message_.text, message_);
  return true;
}

// New facts may have given the same fluents another reason; then it is another question.
bool OpenQuestion::isAsked(const session::QuestionView& view) const {
  return isOpen() && bridge_.openId() == message_.question_id && view_.fluents == view.fluents &&
         ros_common::toMessage(view_, current_.phrases).why ==
             ros_common::toMessage(view, current_.phrases).why;
}

void OpenQuestion::updateView() {
  if (isOpen()) view_ = *current_.session->question();
}

// A question that is asked again has a new id, so that a dialogue node leaves the old call. Until
// then it can still be answered with its old id.
void OpenQuestion::onTimeout() {
  const phrasing::Phrases& phrases = current_.phrases;
  const auto tries = static_cast<unsigned>(current_.options.ask_retries) + 1;
  if (++current_.timeouts < tries) {
    announcer_.tell(phrases.say("event_again", {std::to_string(message_.question_id)}));
    hide();
    return;
  }
  const std::string timeout = fmt::format("{}", current_.options.ask_timeout);
  std::string reason = tries == 1
                           ? phrases.say("nobody_answered", {timeout})
                           : phrases.say("nobody_answered_times", {std::to_string(tries), timeout});
  const std::string refusals = bridge_.refusals();
  if (!refusals.empty()) {
    const std::string refused = phrases.say("answers_refused", {refusals});
    reason += "; " + refused;
    announcer_.warn(fmt::format("question {}: {}", message_.question_id, refused));
  }
  current_.session->answerTimedOut(reason);
}

bool OpenQuestion::open(GoalTicket& ticket, const session::Snapshot& now) {
  hide();  // one that new facts have replaced
  const session::QuestionView& view = *current_.session->question();
  const std::uint32_t id = bridge_.open(view.fluents);
  if (id == 0) return false;
  message_ = ros_common::toMessage(unansweredPart(view, now), current_.phrases);
  view_ = view;
  message_.session_id = current_.labels.id;
  message_.person = current_.labels.person;
  message_.question_id = id;
  startTimeout();
  // This sets the result of a cancel, which may come as soon as the question is seen.
  reporter_.report(ticket, now, message_.text, message_);
  publish(ticket, now);
  return true;
}

// Also after a partial answer: it shows that somebody is there.
void OpenQuestion::startTimeout() {
  deadline_ = Clock::time_point::max();
  if (current_.options.ask_timeout > 0) {
    const std::chrono::duration<double> timeout(current_.options.ask_timeout);
    // People live in wall time, also where the robot's clock is a simulated one.
    const ros::WallTime expires = ros::WallTime::now() + ros::WallDuration(timeout.count());
    message_.expires = {expires.sec, expires.nsec};
    deadline_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(timeout);
  }
}

void OpenQuestion::publish(GoalTicket& ticket, const session::Snapshot& now) {
  message_ = announcer_.publish(message_);
  announcer_.tell(current_.phrases.say(
      "event_question", {std::to_string(message_.question_id),
                         message_.text + (message_.why.empty() ? "" : " ") + message_.why}));
  reporter_.report(ticket, now, message_.text, message_);
  ask_human_.ask(message_);
}

// Fluents of the group that were answered are not shown any more, and other answers may have
// changed the reason and the number of questions that may follow. The question keeps its id.
void OpenQuestion::refresh(GoalTicket& ticket, const session::Snapshot& now) {
  const session::QuestionView part = unansweredPart(view_, now);
  if (part.fluents.empty()) return reporter_.report(ticket, now, message_.text, message_);
  Question shown = message_;
  const Question fresh = ros_common::toMessage(part, current_.phrases);
  shown.fluents = fresh.fluents;
  shown.text = fresh.text;
  shown.why = fresh.why;
  shown.conflict = fresh.conflict;
  shown.probabilities = fresh.probabilities;
  shown.max_remaining = fresh.max_remaining;
  shown.bound_is_provisional = fresh.bound_is_provisional;
  const bool is_narrower = shown.fluents.size() < message_.fluents.size();
  const bool is_new = shown != message_;
  message_ = std::move(shown);
  if (is_narrower) {
    startTimeout();
    return publish(ticket, now);
  }
  if (is_new) message_ = announcer_.publish(message_);
  reporter_.report(ticket, now, message_.text, message_);  // shows volunteered answers, too
}

void OpenQuestion::closeIfAnswered() {
  if (isOpen() && bridge_.openId() != message_.question_id) close();
}

void OpenQuestion::close() {
  bridge_.close();
  hide();
}

void OpenQuestion::hide() {
  if (!isOpen()) return;
  message_ = Question{};
  view_ = {};
  ask_human_.withdraw();
  announcer_.publishNoQuestion();
}

}  // namespace goal_alignment::aligner
