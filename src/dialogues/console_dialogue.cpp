// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/dialogues/console_dialogue.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <ros/init.h>
#include <unistd.h>

#include <utility>

#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/common/quote.h"
#include "goal_alignment/dialogues/outcome_watch.h"
#include "goal_alignment/ros_common/descriptor.h"
#include "goal_alignment/ros_common/names.h"

namespace goal_alignment::dialogues {
namespace {

constexpr std::chrono::milliseconds kShutdownCheck{50};
constexpr std::size_t kLongestEcho = 40;  // bytes

std::string wordingOf(const Question& question, const phrasing::Phrases& phrases) {
  std::string text =
      phrasing::questionLine({question.asked + 1, question.person, question.max_remaining,
                              question.bound_is_provisional != 0, question.text},
                             phrases) +
      "\n";
  for (std::size_t i = 0; question.fluents.size() > 1 && i < question.fluents.size(); ++i) {
    text += fmt::format("  {}: {}\n", i + 1, question.fluents[i].text);
  }
  if (!question.why.empty()) text += "  " + phrases.say("ask_why", {question.why}) + "\n";
  return text + "  " + phrasing::replyKeys(question.fluents.size(), phrases.frames()) + "\n> ";
}

std::vector<std::string> clausesOf(const Question& question) {
  std::vector<std::string> clauses;
  for (const Fluent& fluent : question.fluents)
    clauses.push_back(fluent.text);
  return clauses;
}

std::string keysOf(const std::vector<std::string>& alternatives, const phrasing::Phrases& phrases) {
  return phrases.say(alternatives.size() == 1 ? "ask_go_on_keys" : "ask_go_on_several_keys");
}

std::string wordingOf(const std::vector<std::string>& alternatives,
                      const phrasing::Phrases& phrases) {
  const std::string keys = "  " + keysOf(alternatives, phrases) + "\n> ";
  if (alternatives.size() == 1)
    return phrases.say("ask_go_on", {alternatives.front()}) + "\n" + keys;
  std::string text = phrases.say("ask_go_on_several") + "\n";
  for (std::size_t i = 0; i < alternatives.size(); ++i)
    text += fmt::format("  {}: {}\n", i + 1, alternatives[i]);
  return text + keys;
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
  if (pipe2(ends.data(), O_NONBLOCK | O_CLOEXEC) != 0) ros_common::failWithErrno("pipe");
}

ConsoleDialogue::WakePipe::~WakePipe() {
  close(ends[0]);
  close(ends[1]);
}

ConsoleDialogue::ConsoleDialogue(ros::NodeHandle node, int input, PromptedTerminal& terminal,
                                 phrasing::Vocabulary vocabulary, phrasing::Phrases phrases)
    : terminal_(terminal),
      vocabulary_(std::move(vocabulary)),
      phrases_(std::move(phrases)),
      lines_(input, wake_pipe_.ends[0]),
      watch_(node, [this] { wake(); }),
      diagnostics_(node, ros::NodeHandle("~")),
      service_(node.advertiseService(ros_common::kAskHumanService, &ConsoleDialogue::ask, this)) {}

void ConsoleDialogue::wake() const {
  const char byte = 0;
  (void)!write(wake_pipe_.ends[1], &byte, 1);  // a full pipe wakes as well
}

bool ConsoleDialogue::ask(AskHuman::Request& request, AskHuman::Response& response) {
  const DialogueDiagnostics::Turn turn(diagnostics_, request, response);
  response.answer = AskHuman::Response::NONE;
  const Question& question = request.question;
  if (question.question_id == 0) return true;  // no question: there is nothing to wait for
  std::optional<phrasing::Reply> reply;
  const std::vector<std::string> clauses = clausesOf(question);
  Prompt prompt;
  prompt.text = wordingOf(question, phrases_);
  prompt.keys = phrasing::replyKeys(clauses.size(), phrases_.frames());
  prompt.why = question.why.empty() ? vocabulary_.noReason() : question.why;
  prompt.is_gone = [&] { return watch_.isGone(question); };
  prompt.take = [&](const std::string& line) {
    reply = phrasing::parseReply(line, clauses.size(), phrases_.frames());
    if (reply) return Prompt::Taken::Answer;
    const auto heard = vocabulary_.understand(line, clauses);
    if (!heard) return Prompt::Taken::Nothing;
    if (heard->kind == phrasing::Heard::Kind::Reply) reply = heard->reply;
    return reply                                       ? Prompt::Taken::Answer
           : heard->kind == phrasing::Heard::Kind::Why ? Prompt::Taken::Why
                                                       : Prompt::Taken::Again;
  };
  put(prompt);
  response = responseTo(question, reply);
  return true;
}

std::optional<std::size_t> ConsoleDialogue::choose(const std::vector<AlternativeGoal>& alternatives,
                                                   const std::function<bool()>& is_gone) {
  std::optional<std::size_t> chosen;
  std::vector<std::string> offered;
  for (const AlternativeGoal& alternative : alternatives)
    offered.push_back(leftOutBy(alternative));
  Prompt prompt;
  prompt.text = wordingOf(offered, phrases_);
  prompt.keys = keysOf(offered, phrases_);
  prompt.is_gone = is_gone;
  prompt.take = [&](const std::string& line) {
    using Kind = phrasing::Reply::Kind;
    const auto typed = phrasing::parseReply(line, offered.size(), phrases_.frames());
    if (typed && typed->kind == Kind::No) return Prompt::Taken::Answer;
    if (typed && typed->kind == Kind::Yes && offered.size() == 1) {
      chosen = 0;
      return Prompt::Taken::Answer;
    }
    const auto choice = vocabulary_.choose(line, offered);
    if (!choice) return Prompt::Taken::Nothing;
    if (choice->kind == phrasing::Choice::Kind::Repeat) return Prompt::Taken::Again;
    if (choice->kind == phrasing::Choice::Kind::One) chosen = choice->index;
    return Prompt::Taken::Answer;
  };
  put(prompt);
  return chosen;
}

void ConsoleDialogue::put(const Prompt& prompt) {
  const std::lock_guard<std::mutex> one_at_a_time(asking_);
  std::unique_lock<std::mutex> lock(mutex_);
  prompt_ = prompt;
  ++number_;
  finished_ = false;
  wake();
  while (!finished_ && !ended_ && ros::ok())
    answered_.wait_for(lock, kShutdownCheck);
  prompt_.reset();
}

bool ConsoleDialogue::hasEnded() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return ended_;
}

void ConsoleDialogue::run() {
  while (ros::ok() && !lines_.atEnd()) {
    showNewPrompt();
    leavePromptIfGone();
    lines_.wait(kShutdownCheck);
    // Prepared answers of a pipe wait for their question; what is typed without one is dropped.
    while (shown_ != 0 || lines_.isTerminal()) {
      const auto line = lines_.nextLine();
      if (!line) break;
      treatLine(*line);
    }
  }
  sayGoodbye();
}

void ConsoleDialogue::showNewPrompt() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!prompt_ || finished_ || number_ == shown_) return;
  shown_ = number_;
  shown_at_ = Clock::now();
  terminal_.open(prompt_->text);
}

void ConsoleDialogue::leavePromptIfGone() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (shown_ == 0 || !prompt_ || !prompt_->is_gone()) return;
  terminal_.close("\n" + phrases_.say("ask_gone") + "\n");
  finish();
  replaced_another_ = true;
}

void ConsoleDialogue::treatLine(const std::string& line) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const std::string words(trimmed(line));
  if (shown_ == 0) {
    if (!words.empty()) terminal_.hint(phrases_.say("ask_nothing") + "\n");
    return;
  }
  if (!prompt_) return finish();  // the node ends
  if (words.empty()) return terminal_.showAgain();
  if (cameTooEarly()) return terminal_.hint(phrases_.say("ask_replaced") + "\n> ");
  switch (prompt_->take(line)) {
    case Prompt::Taken::Answer:
      terminal_.close();
      finish();
      replaced_another_ = false;
      return;
    case Prompt::Taken::Again:
      return terminal_.showAgain();
    case Prompt::Taken::Why:
      return terminal_.hint(fmt::format("{}\n> ", prompt_->why));
    case Prompt::Taken::Nothing:
      return terminal_.hint(
          phrases_.say("ask_again", {shortened(words, kLongestEcho), prompt_->keys}) + "\n> ");
  }
}

// A line that was typed for the question before must not answer this one.
bool ConsoleDialogue::cameTooEarly() const {
  const std::chrono::duration<double> since = Clock::now() - shown_at_;
  return lines_.isTerminal() && replaced_another_ &&
         since.count() < ros_common::kAnswerGraceSeconds;
}

// Under mutex_.
void ConsoleDialogue::finish() {
  shown_ = 0;
  finished_ = true;
  answered_.notify_all();
}

void ConsoleDialogue::sayGoodbye() {
  if (lines_.atEnd()) {
    terminal_.close("\n" + phrases_.say("ask_end_of_input") + "\n");
  }
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ended_ = true;
  }
  answered_.notify_all();
  service_.shutdown();
}

}  // namespace goal_alignment::dialogues
