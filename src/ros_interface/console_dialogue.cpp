// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/ros_interface/console_dialogue.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <ros/init.h>
#include <unistd.h>

#include <ostream>
#include <utility>

#include "descriptor.h"
#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/common/quote.h"
#include "goal_alignment/ros_interface/node_constants.h"

namespace goal_alignment::ros_interface {
namespace {

constexpr std::chrono::milliseconds kShutdownCheck{50};
constexpr std::size_t kLongestEcho = 40;  // bytes

std::string wordingOf(const Question& question, const phrasing::Phrases& phrases) {
  std::string text =
      "\n" +
      phrasing::questionLine({question.asked + 1, question.person, question.max_remaining,
                              question.bound_is_provisional != 0, question.text},
                             phrases) +
      "\n";
  for (std::size_t i = 0; question.fluents.size() > 1 && i < question.fluents.size(); ++i) {
    text += fmt::format("  {}: {}\n", i + 1, question.fluents[i].text);
  }
  if (!question.why.empty()) text += "  " + phrases.say("ask_why", {question.why}) + "\n";
  return text + "  " + phrasing::replyKeys(question.fluents.size(), phrases.frames()) + "\n";
}

// Without a reply the question is left as it is.
AskHuman::Response responseTo(const Question& question,
                              const std::optional<phrasing::Reply>& reply) {
  AskHuman::Response response;
  response.answer =
      reply ? static_cast<std::int8_t>(reply->kind) : std::int8_t{AskHuman::Response::NONE};
  response.question_id = question.question_id;
  response.answered_by = question.person.empty() ? "console" : question.person;
  if (!reply) return response;
  for (const std::size_t index : reply->chosen) {
    const Fluent& fluent = question.fluents.at(index);
    response.fluents.push_back(
        Literal{GroundName{fluent.name, fluent.args}, fluent.negated != 0}.text());
  }
  return response;
}

}  // namespace

ConsoleDialogue::WakePipe::WakePipe() {
  if (pipe2(ends.data(), O_NONBLOCK | O_CLOEXEC) != 0) failWithErrno("pipe");
}

ConsoleDialogue::WakePipe::~WakePipe() {
  close(ends[0]);
  close(ends[1]);
}

ConsoleDialogue::ConsoleDialogue(ros::NodeHandle node, int input, std::ostream& out,
                                 phrasing::Phrases phrases)
    : out_(out),
      phrases_(std::move(phrases)),
      lines_(input, wake_pipe_.ends[0]),
      watch_(node, [this] { wake(); }),
      service_(node.advertiseService(kAskHumanService, &ConsoleDialogue::ask, this)) {}

void ConsoleDialogue::wake() const {
  const char byte = 0;
  (void)!write(wake_pipe_.ends[1], &byte, 1);  // a full pipe wakes as well
}

bool ConsoleDialogue::ask(AskHuman::Request& request, AskHuman::Response& response) {
  if (request.question.question_id == 0) {  // no question: there is nothing to wait for
    response.answer = AskHuman::Response::NONE;
    return true;
  }
  const std::lock_guard<std::mutex> one_at_a_time(asking_);
  std::unique_lock<std::mutex> lock(mutex_);
  question_ = request.question;
  reply_.reset();
  finished_ = false;
  wake();
  while (!finished_ && !ended_ && ros::ok())
    answered_.wait_for(lock, kShutdownCheck);

  question_.reset();
  response = responseTo(request.question, reply_);
  return true;
}

void ConsoleDialogue::run() {
  while (ros::ok() && !lines_.atEnd()) {
    showNewQuestion();
    leaveQuestionIfGone();
    lines_.wait(kShutdownCheck);
    // Prepared answers of a pipe wait for their question; what is typed without one is dropped.
    while (shown_id_ != 0 || lines_.isTerminal()) {
      const auto line = lines_.nextLine();
      if (!line) break;
      treatLine(*line);
    }
  }
  sayGoodbye();
}

void ConsoleDialogue::showNewQuestion() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!question_ || finished_ || question_->question_id == shown_id_) return;
  shown_id_ = question_->question_id;
  shown_at_ = Clock::now();
  out_ << wordingOf(*question_, phrases_) << "> " << std::flush;
}

void ConsoleDialogue::leaveQuestionIfGone() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (shown_id_ == 0 || !question_ || !watch_.isGone(*question_)) return;
  }
  out_ << '\n' << phrases_.say("ask_gone") << std::endl;
  finish(std::nullopt);
  replaced_another_ = true;
}

void ConsoleDialogue::treatLine(const std::string& line) {
  if (shown_id_ == 0) {
    if (!trimmed(line).empty()) out_ << phrases_.say("ask_nothing") << std::endl;
    return;
  }
  std::size_t fluents = 0;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    fluents = question_ ? question_->fluents.size() : 0;
  }
  const auto reply = phrasing::parseReply(line, fluents, phrases_.frames());
  if (!reply) {
    const std::string keys = phrasing::replyKeys(fluents, phrases_.frames());
    out_ << phrases_.say("ask_again", {shortened(trimmed(line), kLongestEcho), keys}) << "\n> "
         << std::flush;
  } else if (cameTooEarly()) {
    out_ << phrases_.say("ask_replaced") << "\n> " << std::flush;
  } else {
    finish(reply);
    replaced_another_ = false;
  }
}

// A line that was typed for the question before must not answer this one.
bool ConsoleDialogue::cameTooEarly() const {
  const std::chrono::duration<double> since = Clock::now() - shown_at_;
  return lines_.isTerminal() && replaced_another_ && since.count() < kAnswerGraceSeconds;
}

void ConsoleDialogue::finish(const std::optional<phrasing::Reply>& reply) {
  shown_id_ = 0;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    reply_ = reply;
    finished_ = true;
  }
  answered_.notify_all();
}

void ConsoleDialogue::sayGoodbye() {
  if (lines_.atEnd()) {
    out_ << '\n' << phrases_.say("ask_end_of_input") << std::endl;
  }
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ended_ = true;
  }
  answered_.notify_all();
  service_.shutdown();
}

}  // namespace goal_alignment::ros_interface
