// SPDX-License-Identifier: BSD-3-Clause
// How the runner puts questions, and what becomes of the answers.
#include <fmt/format.h>
#include <ros/console.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "align_goal_reader.h"
#include "alignment_runner.h"
#include "goal_alignment/ros_common/stamp.h"

namespace goal_alignment::aligner {
namespace {

using session::AnswerKind;
using session::CandidateState;
using session::CandidateView;

const char* nameOf(AnswerKind kind) {
  switch (kind) {
    case AnswerKind::No:
      return "answer_no";
    case AnswerKind::Yes:
      return "answer_yes";
    case AnswerKind::Unsure:
      return "answer_unsure";
    case AnswerKind::Decline:
      break;
  }
  return "answer_decline";
}

// The answer that stands, where somebody gave one.
std::optional<AnswerKind> answerOf(const CandidateView& candidate) {
  if (candidate.assumed) return std::nullopt;
  switch (candidate.state) {
    case CandidateState::Wanted:
      return AnswerKind::Yes;
    case CandidateState::NotWanted:
      return AnswerKind::No;
    case CandidateState::Unsure:
      return AnswerKind::Unsure;
    default:
      return std::nullopt;
  }
}

bool isAsked(const session::Snapshot& snapshot, const Literal& fluent) {
  const CandidateView* candidate = snapshot.candidateOf(fluent);
  return candidate != nullptr && candidate->state == CandidateState::Asked;
}

// Without what of the group was answered.
session::QuestionView stillAsked(const session::QuestionView& view, const session::Snapshot& now) {
  session::QuestionView rest = view;
  rest.fluents.clear();
  rest.reasons.clear();
  rest.probabilities.clear();
  for (std::size_t i = 0; i < view.fluents.size(); ++i) {
    if (!isAsked(now, view.fluents[i])) continue;
    rest.fluents.push_back(view.fluents[i]);
    rest.reasons.push_back(view.reasons[i]);
    rest.probabilities.push_back(view.probabilities[i]);
  }
  return rest;
}

}  // namespace

std::vector<Literal> AlignmentRunner::candidatesOf(const std::vector<Fluent>& fluents,
                                                   const std::string& field) const {
  std::vector<Literal> literals;
  try {
    literals = ros_common::toLiterals(fluents, field);
  } catch (const std::invalid_argument& error) {
    throw GoalError(error.what());
  }
  const session::Snapshot snapshot = kept_.session->snapshot();
  for (const Literal& literal : literals) {
    if (snapshot.candidateOf(literal) == nullptr) {
      throw GoalError(fmt::format("{}: {} is no candidate of this session", field, literal.text()));
    }
  }
  return literals;
}

// What was answered before the dialogue was broken off, perhaps by a crash, is not asked again.
void AlignmentRunner::takeUpJournal() {
  const bool ends_when_unsure = kept_.session->unsurePolicy() == session::UnsurePolicy::Abort;
  const std::set<Literal> before = answered();
  std::vector<Literal> known;
  for (const JournalAnswer& answer : std::exchange(kept_.journaled, {})) {
    // Under this policy "don't know" would end the dialogue before it begins.
    const bool useless = answer.kind == AnswerKind::Unsure && ends_when_unsure;
    if (useless || before.count(answer.fluent) > 0) continue;
    const auto receipt = kept_.session->answer({answer.fluent}, answer.kind, answer.answered_by);
    if (!receipt.accepted) {
      ROS_WARN("an answer of the journal is left out: %s", receipt.message.c_str());
      continue;
    }
    kept_.times[answer.fluent] = answer.at;
    known.push_back(answer.fluent);
  }
  if (known.empty()) return;
  announcer_.tell(kept_.phrases.say("event_answered_before", {spoken(known)}));
}

void AlignmentRunner::applyAnswers() {
  const std::vector<AcceptedAnswer> answers = bridge_.take();
  for (const AcceptedAnswer& answer : answers) {
    apply(answer);
    // A dialogue that was declined is over; what came after must not begin it anew.
    if (kept_.session->state() == State::Done) return;
  }
  // What was volunteered or revised may have made the open question needless. New facts may, too,
  // but mostly they don't; then nobody should be asked once more.
  if (answers.empty()) return;
  if (kept_.session->state() != State::AwaitingAnswer) return closeQuestion();
  // It has stayed, but where its answers would lead may be another place now.
  if (open_.question_id != 0) open_view_ = *kept_.session->question();
}

void AlignmentRunner::apply(const AcceptedAnswer& answer) {
  const session::SubmitResult receipt = applyToSession(answer);
  if (!receipt.accepted) {
    // The bridge knows all of the session's reasons, so this is a fault of ours.
    ROS_ERROR("an accepted answer was refused by the session: %s", receipt.message.c_str());
    return;
  }
  for (const Literal& fluent : answer.fluents)
    kept_.times[fluent] = answer.at;
  kept_.silences = 0;
  const std::vector<JournalAnswer> answers = journalAnswers();
  if (!answers.empty()) journal_.write(answers);
  const phrasing::Phrases& phrases = kept_.phrases;
  std::string said = phrases.say(nameOf(answer.kind));
  if (!answer.fluents.empty()) said += ": " + spoken(answer.fluents);
  announcer_.tell(answer.answered_by.empty()
                      ? phrases.say("event_answer", {said})
                      : phrases.say("event_answer_from", {said, answer.answered_by}));
}

// To the session, which tells a first answer from one that revises another.
session::SubmitResult AlignmentRunner::applyToSession(const AcceptedAnswer& answer) {
  const std::set<Literal> before = answered();
  std::vector<Literal> first;
  std::vector<Literal> again;
  for (const Literal& fluent : answer.fluents)
    (before.count(fluent) > 0 ? again : first).push_back(fluent);
  session::SubmitResult receipt{true, ""};
  if (!first.empty() || answer.kind == AnswerKind::Decline) {
    receipt = kept_.session->answer(first, answer.kind, answer.answered_by);
  }
  if (receipt.accepted && !again.empty()) {
    receipt = kept_.session->revise(again, answer.kind, answer.answered_by);
  }
  return receipt;
}

std::vector<JournalAnswer> AlignmentRunner::journalAnswers() const {
  std::vector<JournalAnswer> answers;
  for (const CandidateView& candidate : kept_.session->snapshot().candidates) {
    const std::optional<AnswerKind> kind = answerOf(candidate);
    if (!kind) continue;
    const auto time = kept_.times.find(candidate.fluent);
    answers.push_back({candidate.fluent, *kind, candidate.answered_by,
                       time == kept_.times.end() ? ros::Time() : time->second});
  }
  return answers;
}

// Whoever sends the task again, where what nobody was sure of decided it, is asked about that anew.
void AlignmentRunner::forgetUnsureAnswers() {
  std::vector<JournalAnswer> answers = journalAnswers();
  const auto is_unsure = [](const JournalAnswer& answer) {
    return answer.kind == AnswerKind::Unsure;
  };
  answers.erase(std::remove_if(answers.begin(), answers.end(), is_unsure), answers.end());
  journal_.write(answers);
}

std::set<Literal> AlignmentRunner::answered() const {
  std::set<Literal> fluents;
  for (const CandidateView& candidate : kept_.session->snapshot().candidates) {
    if (answerOf(candidate)) fluents.insert(candidate.fluent);
  }
  return fluents;
}

void AlignmentRunner::waitForAnswer(GoalTicket& ticket, const session::Snapshot& now) {
  const session::QuestionView& view = *kept_.session->question();
  // A new world may give an old question a new reason.
  const bool same = open_.question_id != 0 && bridge_.openId() == open_.question_id &&
                    open_view_.fluents == view.fluents &&
                    ros_common::toMessage(open_view_, kept_.phrases).why ==
                        ros_common::toMessage(view, kept_.phrases).why;
  const auto began = Clock::now();
  if (same) {
    open_view_ = view;
    refreshQuestion(ticket, now);
    if (!shows_open_) report(ticket, now, open_.text);
  } else if (!openQuestion(ticket, now)) {
    return;
  }
  const QuestionBridge::Wake wake = waitForEvent();
  const std::chrono::duration<double> waited = Clock::now() - began;
  kept_.waiting_time += waited.count();
  if (wake == QuestionBridge::Wake::TimedOut) onAnswerTimeout();
  // Dialogue nodes leave the question at once, not only when the next one is known.
  if (open_.question_id != 0 && bridge_.openId() != open_.question_id) closeQuestion();
}

// As bridge_.wait() does; new facts are news.
QuestionBridge::Wake AlignmentRunner::waitForEvent() {
  while (true) {
    const QuestionBridge::Wake wake = bridge_.wait(std::min(open_until_, nextLook()));
    if (wake != QuestionBridge::Wake::TimedOut || Clock::now() >= open_until_) return wake;
    if (factsHaveChanged()) return QuestionBridge::Wake::News;
  }
}

// A question put again has a new id, so that a dialogue node leaves the old call. Until then it can
// still be answered under its old one.
void AlignmentRunner::onAnswerTimeout() {
  const auto tries = static_cast<unsigned>(kept_.options.ask_retries) + 1;
  if (++kept_.silences < tries) {
    announcer_.tell(kept_.phrases.say("event_again", {std::to_string(open_.question_id)}));
    hideQuestion();
    return;
  }
  const std::string timeout = fmt::format("{}", kept_.options.ask_timeout);
  std::string reason =
      tries == 1 ? kept_.phrases.say("nobody_answered", {timeout})
                 : kept_.phrases.say("nobody_answered_times", {std::to_string(tries), timeout});
  const std::string refusals = bridge_.refusals();
  if (!refusals.empty()) {
    const std::string refused = kept_.phrases.say("answers_refused", {refusals});
    reason += "; " + refused;
    announcer_.warn(fmt::format("question {}: {}", open_.question_id, refused));
  }
  kept_.session->answerTimedOut(reason);
}

// False: an answer came in meanwhile, which counts first.
bool AlignmentRunner::openQuestion(GoalTicket& ticket, const session::Snapshot& now) {
  hideQuestion();  // one that new facts have replaced
  const session::QuestionView& view = *kept_.session->question();
  const std::uint32_t id = bridge_.open(view.fluents);
  if (id == 0) return false;
  open_ = ros_common::toMessage(stillAsked(view, now), kept_.phrases);
  open_view_ = view;
  open_.session_id = kept_.id;
  open_.person = kept_.person;
  open_.question_id = id;
  beginPatience();
  // First of all the result that a cancel would take: it may come as soon as the question is seen.
  report(ticket, now, open_.text);
  putQuestion(ticket, now);
  return true;
}

// Also after an answer in part: who answers is there.
void AlignmentRunner::beginPatience() {
  open_until_ = Clock::time_point::max();
  if (kept_.options.ask_timeout > 0) {
    const std::chrono::duration<double> timeout(kept_.options.ask_timeout);
    // People live in wall time, also where the robot's clock is a simulated one.
    const ros::WallTime expires = ros::WallTime::now() + ros::WallDuration(timeout.count());
    open_.expires = {expires.sec, expires.nsec};
    open_until_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(timeout);
  }
}

void AlignmentRunner::putQuestion(GoalTicket& ticket, const session::Snapshot& now) {
  open_ = announcer_.publish(open_);
  announcer_.tell(kept_.phrases.say("event_question",
                                    {std::to_string(open_.question_id),
                                     open_.text + (open_.why.empty() ? "" : " ") + open_.why}));
  report(ticket, now, open_.text);
  ask_human_.ask(open_);
}

// What of a group was answered is shown no longer, and what else was answered may have changed the
// reason and how many questions may follow. It stays the same question, with the same id.
void AlignmentRunner::refreshQuestion(GoalTicket& ticket, const session::Snapshot& now) {
  const session::QuestionView rest = stillAsked(open_view_, now);
  if (rest.fluents.empty()) return report(ticket, now, open_.text);
  Question shown = open_;
  const Question fresh = ros_common::toMessage(rest, kept_.phrases);
  shown.fluents = fresh.fluents;
  shown.text = fresh.text;
  shown.why = fresh.why;
  shown.conflict = fresh.conflict;
  shown.probabilities = fresh.probabilities;
  shown.max_remaining = fresh.max_remaining;
  shown.bound_is_provisional = fresh.bound_is_provisional;
  const bool is_narrower = shown.fluents.size() < open_.fluents.size();
  const bool is_new = shown != open_;
  open_ = std::move(shown);
  if (is_narrower) {
    beginPatience();
    return putQuestion(ticket, now);
  }
  if (is_new) open_ = announcer_.publish(open_);
  report(ticket, now, open_.text);  // what was volunteered has to be seen, too
}

void AlignmentRunner::closeQuestion() {
  bridge_.close();
  hideQuestion();
}

void AlignmentRunner::hideQuestion() {
  if (open_.question_id == 0) return;
  open_ = Question{};
  open_view_ = {};
  ask_human_.withdraw();
  announcer_.publishNoQuestion();
}

}  // namespace goal_alignment::aligner
