// SPDX-License-Identifier: BSD-3-Clause
#include "session_answers.h"

#include <fmt/format.h>
#include <ros/console.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

#include "align_goal_reader.h"

namespace goal_alignment::aligner {
namespace {

using session::AnswerKind;
using session::CandidateState;
using session::CandidateView;

const char* phraseFor(AnswerKind kind) {
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

}  // namespace

SessionAnswers::SessionAnswers(SessionRecord& current, Journal& journal, Tell tell)
    : current_(current), journal_(journal), tell_(std::move(tell)) {}

std::vector<Literal> SessionAnswers::candidatesOf(const std::vector<Fluent>& fluents,
                                                  const std::string& field) const {
  std::vector<Literal> literals;
  try {
    literals = ros_common::toLiterals(fluents, field);
  } catch (const std::invalid_argument& error) {
    throw GoalError(error.what());
  }
  const session::Snapshot snapshot = current_.session->snapshot();
  for (const Literal& literal : literals) {
    if (snapshot.candidateOf(literal) == nullptr) {
      throw GoalError(
          fmt::format("{}: {} is not a candidate of this session", field, literal.text()));
    }
  }
  return literals;
}

void SessionAnswers::restoreFromJournal() {
  const bool ends_when_unsure = current_.session->unsurePolicy() == session::UnsurePolicy::Abort;
  const std::set<Literal> before = answered();
  std::vector<Literal> restored;
  for (const JournalAnswer& answer : std::exchange(current_.journaled, {})) {
    // Under this policy "don't know" would end the dialogue before it begins.
    const bool useless = answer.kind == AnswerKind::Unsure && ends_when_unsure;
    if (useless || before.count(answer.fluent) > 0) continue;
    const auto receipt = current_.session->answer({answer.fluent}, answer.kind, answer.answered_by);
    if (!receipt.accepted) {
      ROS_WARN("an answer of the journal is left out: %s", receipt.message.c_str());
      continue;
    }
    current_.answer_times[answer.fluent] = answer.at;
    restored.push_back(answer.fluent);
  }
  if (restored.empty()) return;
  tell_(current_.phrases.say("event_answered_before", {current_.clausesOf(restored)}));
}

void SessionAnswers::apply(const AcceptedAnswer& answer) {
  const session::SubmitResult receipt = applyToSession(answer);
  if (!receipt.accepted) {
    // The bridge checks everything that the session does, so this is a bug.
    ROS_ERROR("an accepted answer was refused by the session: %s", receipt.message.c_str());
    return;
  }
  for (const Literal& fluent : answer.fluents)
    current_.answer_times[fluent] = answer.at;
  current_.timeouts = 0;
  const std::vector<JournalAnswer> answers = journalAnswers();
  if (!answers.empty()) journal_.write(answers);
  const phrasing::Phrases& phrases = current_.phrases;
  std::string said = phrases.say(phraseFor(answer.kind));
  if (!answer.fluents.empty()) said += ": " + current_.clausesOf(answer.fluents);
  tell_(answer.answered_by.empty() ? phrases.say("event_answer", {said})
                                   : phrases.say("event_answer_from", {said, answer.answered_by}));
}

// The session distinguishes a first answer from one that revises another.
session::SubmitResult SessionAnswers::applyToSession(const AcceptedAnswer& answer) {
  const std::set<Literal> before = answered();
  std::vector<Literal> first;
  std::vector<Literal> again;
  for (const Literal& fluent : answer.fluents)
    (before.count(fluent) > 0 ? again : first).push_back(fluent);
  session::SubmitResult receipt{true, ""};
  if (!first.empty() || answer.kind == AnswerKind::Decline) {
    receipt = current_.session->answer(first, answer.kind, answer.answered_by);
  }
  if (receipt.accepted && !again.empty()) {
    receipt = current_.session->revise(again, answer.kind, answer.answered_by);
  }
  return receipt;
}

std::vector<JournalAnswer> SessionAnswers::journalAnswers() const {
  std::vector<JournalAnswer> answers;
  for (const CandidateView& candidate : current_.session->snapshot().candidates) {
    const std::optional<AnswerKind> kind = answerOf(candidate);
    if (!kind) continue;
    const auto time = current_.answer_times.find(candidate.fluent);
    answers.push_back({candidate.fluent, *kind, candidate.answered_by,
                       time == current_.answer_times.end() ? ros::Time() : time->second});
  }
  return answers;
}

void SessionAnswers::forgetUnsureAnswers() {
  std::vector<JournalAnswer> answers = journalAnswers();
  const auto is_unsure = [](const JournalAnswer& answer) {
    return answer.kind == AnswerKind::Unsure;
  };
  answers.erase(std::remove_if(answers.begin(), answers.end(), is_unsure), answers.end());
  journal_.write(answers);
}

std::set<Literal> SessionAnswers::answered() const {
  std::set<Literal> fluents;
  for (const CandidateView& candidate : current_.session->snapshot().candidates) {
    if (answerOf(candidate)) fluents.insert(candidate.fluent);
  }
  return fluents;
}

}  // namespace goal_alignment::aligner
