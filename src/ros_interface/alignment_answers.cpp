// SPDX-License-Identifier: BSD-3-Clause
// How the runner puts questions, and what becomes of the answers.
#include <fmt/format.h>
#include <ros/console.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "goal_alignment/ros_interface/alignment_runner.h"
#include "goal_alignment/ros_interface/model_source.h"
#include "goal_alignment/ros_interface/stamp.h"

namespace goal_alignment::ros_interface {
namespace {

using session::AnswerKind;
using session::CandidateState;
using session::CandidateView;

const char* wordFor(AnswerKind kind) {
  switch (kind) {
    case AnswerKind::No:
      return "no";
    case AnswerKind::Yes:
      return "yes";
    case AnswerKind::Unsure:
      return "don't know";
    case AnswerKind::Decline:
      return "no more questions, please";
  }
  return "";
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

// Without what of the group was answered. The prospects are those of the whole, so that then
// nothing can be said of them.
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
  if (rest.fluents.size() == view.fluents.size()) return view;
  rest.if_yes = {};
  rest.if_yes.ending = questions::Prospect::Ending::Plan;
  rest.if_no = {};
  return rest;
}

}  // namespace

std::vector<Literal> AlignmentRunner::candidatesOf(const std::vector<Fluent>& fluents,
                                                   const std::string& field) const {
  std::vector<Literal> literals;
  try {
    literals = toLiterals(fluents, field);
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
  const std::set<Literal> before = answered();
  std::vector<Literal> known;
  for (const JournalAnswer& answer : std::exchange(kept_.journaled, {})) {
    // Under this policy "don't know" would end the dialogue before it begins.
    const bool useless = answer.kind == AnswerKind::Unsure && kept_.ends_when_unsure;
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
  announcer_.tell(fmt::format("answered before this dialogue was broken off: {}", spoken(known)));
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
  if (!answers.empty() && kept_.session->state() != State::AwaitingAnswer) closeQuestion();
}

void AlignmentRunner::apply(const AcceptedAnswer& answer) {
  const session::Receipt receipt = handOver(answer);
  if (!receipt.accepted) {
    // The bridge knows all of the session's reasons, so this is a fault of ours.
    ROS_ERROR("an accepted answer was refused by the session: %s", receipt.message.c_str());
    return;
  }
  for (const Literal& fluent : answer.fluents)
    kept_.times[fluent] = answer.at;
  kept_.silences = 0;
  writeJournal();
  announcer_.tell(fmt::format(
      "answer{}: {}{}", answer.answered_by.empty() ? "" : " from " + answer.answered_by,
      wordFor(answer.kind), answer.fluents.empty() ? "" : ": " + spoken(answer.fluents)));
}

// To the session, which tells a first answer from one that revises another.
session::Receipt AlignmentRunner::handOver(const AcceptedAnswer& answer) {
  const std::set<Literal> before = answered();
  std::vector<Literal> first;
  std::vector<Literal> again;
  for (const Literal& fluent : answer.fluents)
    (before.count(fluent) > 0 ? again : first).push_back(fluent);
  session::Receipt receipt{true, ""};
  if (!first.empty() || answer.kind == AnswerKind::Decline) {
    receipt = kept_.session->answer(first, answer.kind, answer.answered_by);
  }
  if (receipt.accepted && !again.empty()) {
    receipt = kept_.session->revise(again, answer.kind, answer.answered_by);
  }
  return receipt;
}

void AlignmentRunner::writeJournal() const {
  std::vector<JournalAnswer> answers;
  for (const CandidateView& candidate : kept_.session->snapshot().candidates) {
    const std::optional<AnswerKind> kind = answerOf(candidate);
    if (!kind) continue;
    const auto time = kept_.times.find(candidate.fluent);
    answers.push_back({candidate.fluent, *kind, candidate.answered_by,
                       time == kept_.times.end() ? ros::Time() : time->second});
  }
  if (!answers.empty()) journal_.write(answers);
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
                    toMessage(open_view_, kept_.phrases).why == toMessage(view, kept_.phrases).why;
  const auto began = Clock::now();
  if (same) {
    narrowQuestion(ticket, now);
    if (!shows_open_) report(ticket, now, open_.text);
  } else if (!openQuestion(ticket, now)) {
    return;
  }
  const QuestionBridge::Wake wake = awaitNews();
  const std::chrono::duration<double> waited = Clock::now() - began;
  kept_.waiting_time += waited.count();
  if (wake == QuestionBridge::Wake::TimedOut) treatSilence();
  // Dialogue nodes leave the question at once, not only when the next one is known.
  if (bridge_.openId() != open_.question_id) closeQuestion();
}

// As bridge_.wait() does; new facts are news.
QuestionBridge::Wake AlignmentRunner::awaitNews() {
  while (true) {
    const QuestionBridge::Wake wake = bridge_.wait(std::min(open_until_, nextLook()));
    if (wake != QuestionBridge::Wake::TimedOut || Clock::now() >= open_until_) return wake;
    if (factsHaveChanged()) return QuestionBridge::Wake::News;
  }
}

// A question put again has a new id, so that a dialogue node leaves the old call.
void AlignmentRunner::treatSilence() {
  const auto tries = static_cast<unsigned>(kept_.options.ask_retries) + 1;
  if (++kept_.silences < tries) {
    announcer_.tell(fmt::format("no answer to question {}; it is put again", open_.question_id));
    closeQuestion();
    return;
  }
  const double timeout = kept_.options.ask_timeout;
  kept_.session->giveUpWaiting(
      tries == 1 ? fmt::format("nobody answered within {} s", timeout)
                 : fmt::format("nobody answered {} times within {} s", tries, timeout));
}

// False: an answer came in meanwhile, which counts first.
bool AlignmentRunner::openQuestion(GoalTicket& ticket, const session::Snapshot& now) {
  closeQuestion();  // one that new facts have replaced
  const session::QuestionView& view = *kept_.session->question();
  const std::uint32_t id = bridge_.open(view.fluents);
  if (id == 0) return false;
  open_ = toMessage(stillAsked(view, now), kept_.phrases);
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
  announcer_.tell(fmt::format("question {}: {}{}{}", open_.question_id, open_.text,
                              open_.why.empty() ? "" : " ", open_.why));
  report(ticket, now, open_.text);
  ask_human_.ask(open_);
}

// What of a group was answered is shown no longer. It stays the same question, with the same id.
void AlignmentRunner::narrowQuestion(GoalTicket& ticket, const session::Snapshot& now) {
  const session::QuestionView rest = stillAsked(open_view_, now);
  if (rest.fluents.empty() || rest.fluents.size() == open_.fluents.size()) {
    return report(ticket, now, open_.text);  // what was volunteered has to be seen, too
  }
  const Question shown = toMessage(rest, kept_.phrases);
  open_.fluents = shown.fluents;
  open_.text = shown.text;
  open_.why = shown.why;
  open_.conflict = shown.conflict;
  open_.probabilities = shown.probabilities;
  beginPatience();
  putQuestion(ticket, now);
}

void AlignmentRunner::closeQuestion() {
  bridge_.close();
  if (open_.question_id == 0) return;
  open_ = Question{};
  open_view_ = {};
  ask_human_.withdraw();
  announcer_.publishNoQuestion();
}

}  // namespace goal_alignment::ros_interface
