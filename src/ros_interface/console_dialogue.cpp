// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/ros_interface/console_dialogue.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <ros/init.h>
#include <unistd.h>

#include <algorithm>
#include <ostream>
#include <sstream>
#include <utility>

#include "descriptor.h"
#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/ros_interface/node_constants.h"

namespace goal_alignment::ros_interface {
namespace {

constexpr std::chrono::milliseconds kShutdownCheck{50};
constexpr const char* kKeys = "y = yes, n = no, ? = don't know, d = no more questions";

std::string trimmed(const std::string& line) {
  constexpr const char* kBlanks = " \t\r";
  const std::size_t begin = line.find_first_not_of(kBlanks);
  if (begin == std::string::npos) return {};
  return line.substr(begin, line.find_last_not_of(kBlanks) - begin + 1);
}

bool isOneOf(const std::string& word, std::initializer_list<const char*> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

// "1 3" or "1,3"; nothing where there is anything else, or a number out of range.
std::optional<std::vector<std::size_t>> parseNumbers(std::string text, std::size_t count) {
  std::replace(text.begin(), text.end(), ',', ' ');
  std::istringstream in(text);
  std::vector<std::size_t> indices;
  for (std::size_t number = 0; in >> number;) {
    if (number < 1 || number > count) return std::nullopt;
    indices.push_back(number - 1);
  }
  if (!in.eof() || indices.empty()) return std::nullopt;
  return indices;
}

std::string wordingOf(const Question& question) {
  std::string text =
      fmt::format("\nQuestion {}{} (at most {} left{}): {}\n", question.asked + 1,
                  question.person.empty() ? "" : " for " + question.person, question.max_remaining,
                  question.bound_is_provisional ? ", as far as is known" : "", question.text);
  for (std::size_t i = 0; question.fluents.size() > 1 && i < question.fluents.size(); ++i) {
    text += fmt::format("  {}: {}\n", i + 1, question.fluents[i].text);
  }
  if (!question.why.empty()) text += fmt::format("  Why I ask: {}\n", question.why);
  text += fmt::format("  {}{}\n", kKeys,
                      question.fluents.size() > 1 ? ", or the numbers of those that matter" : "");
  return text;
}

}  // namespace

std::optional<Reply> parseReply(const std::string& line, std::size_t fluents) {
  const std::string word = toLower(trimmed(line));
  using Response = AskHuman::Response;
  if (isOneOf(word, {"y", "yes"})) return Reply{Response::YES, {}};
  if (isOneOf(word, {"n", "no"})) return Reply{Response::NO, {}};
  if (isOneOf(word, {"?", "u", "unsure", "don't know", "dont know", "i don't know"})) {
    return Reply{Response::UNSURE, {}};
  }
  if (isOneOf(word, {"d", "decline"})) return Reply{Response::DECLINE, {}};
  if (fluents > 1) {
    if (auto numbers = parseNumbers(word, fluents)) return Reply{Response::YES, *numbers};
  }
  return std::nullopt;
}

ConsoleDialogue::WakePipe::WakePipe() {
  if (pipe2(ends.data(), O_NONBLOCK | O_CLOEXEC) != 0) failWithErrno("pipe");
}

ConsoleDialogue::WakePipe::~WakePipe() {
  close(ends[0]);
  close(ends[1]);
}

ConsoleDialogue::ConsoleDialogue(ros::NodeHandle node, int input, std::ostream& out)
    : out_(out),
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
  wake();
  while (!reply_ && !ended_ && ros::ok())
    answered_.wait_for(lock, kShutdownCheck);

  const Reply reply = reply_.value_or(Reply{});
  question_.reset();
  response.answer = reply.answer;
  response.question_id = request.question.question_id;
  response.answered_by = request.question.person.empty() ? "console" : request.question.person;
  for (const std::size_t index : reply.chosen) {
    const Fluent& fluent = request.question.fluents.at(index);
    response.fluents.push_back(
        Literal{GroundName{fluent.name, fluent.args}, fluent.negated != 0}.text());
  }
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
  if (!question_ || reply_ || question_->question_id == shown_id_) return;
  shown_id_ = question_->question_id;
  shown_at_ = Clock::now();
  out_ << wordingOf(*question_) << "> " << std::flush;
}

void ConsoleDialogue::leaveQuestionIfGone() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (shown_id_ == 0 || !question_ || !watch_.isGone(*question_)) return;
  }
  out_ << "\nThis question is no longer open." << std::endl;
  finish(Reply{});
  replaced_another_ = true;
}

void ConsoleDialogue::treatLine(const std::string& line) {
  if (shown_id_ == 0) {
    if (!trimmed(line).empty()) out_ << "There is no question open." << std::endl;
    return;
  }
  std::size_t fluents = 0;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    fluents = question_ ? question_->fluents.size() : 0;
  }
  const auto reply = parseReply(line, fluents);
  if (!reply) {
    out_ << fmt::format("I did not understand '{:.40}'. {}\n> ", trimmed(line), kKeys)
         << std::flush;
  } else if (cameTooEarly()) {
    out_ << "This question has just replaced the one before; please read it.\n> " << std::flush;
  } else {
    finish(*reply);
    replaced_another_ = false;
  }
}

// A line that was typed for the question before must not answer this one.
bool ConsoleDialogue::cameTooEarly() const {
  const std::chrono::duration<double> since = Clock::now() - shown_at_;
  return lines_.isTerminal() && replaced_another_ && since.count() < kAnswerGraceSeconds;
}

void ConsoleDialogue::finish(const Reply& reply) {
  shown_id_ = 0;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    reply_ = reply;
  }
  answered_.notify_all();
}

void ConsoleDialogue::sayGoodbye() {
  if (lines_.atEnd()) {
    out_ << "\nEnd of input: no more questions are answered here. Another dialogue node or the "
            "service ~answer may answer them."
         << std::endl;
  }
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ended_ = true;
  }
  answered_.notify_all();
  service_.shutdown();
}

}  // namespace goal_alignment::ros_interface
