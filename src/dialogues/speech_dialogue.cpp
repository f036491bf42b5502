// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/dialogues/speech_dialogue.h"

#include <fmt/format.h>
#include <ros/console.h>
#include <ros/init.h>

#include <algorithm>
#include <stdexcept>
#include <system_error>
#include <utility>
#include <vector>

#include "goal_alignment/AlignResult.h"
#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/phrasing/outcomes.h"
#include "goal_alignment/phrasing/spoken_choice.h"
#include "goal_alignment/ros_common/message_conversion.h"
#include "goal_alignment/ros_common/names.h"

namespace goal_alignment::dialogues {
namespace {

constexpr std::uint32_t kQueueSize = 10;
constexpr std::chrono::milliseconds kTick{20};  // for what tells nobody: shutdown, a process's end
constexpr std::chrono::milliseconds kIdleTick{100};
constexpr double kPlanPatience = 2;  // seconds between an end and its plan

std::vector<std::string> clausesOf(const Question& question) {
  std::vector<std::string> clauses;
  for (const Fluent& fluent : question.fluents)
    clauses.push_back(fluent.text);
  return clauses;
}

// Where nobody has put a fluent in words, its PDDL is said.
Question withTexts(Question question, const std::vector<Literal>& fluents) {
  for (std::size_t i = 0; i < fluents.size(); ++i) {
    std::string& text = question.fluents[i].text;
    if (text.empty()) text = fluents[i].text();
  }
  return question;
}

std::chrono::steady_clock::time_point after(double seconds) {
  using Clock = std::chrono::steady_clock;
  return Clock::now() +
         std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

}  // namespace

SpeechDialogue::SpeechDialogue(ros::NodeHandle node, ros::NodeHandle private_node)
    : options_(SpeechOptions::read(private_node)),
      vocabulary_(vocabularyOf(options_.vocabulary)),
      said_(private_node.advertise<std_msgs::String>(ros_common::kSaidTopic, kQueueSize)),
      watch_(node, [this] { changed_.notify_all(); }),
      diagnostics_(node, private_node),
      ends_(node, [this] { changed_.notify_all(); }),
      listener_(1, &recognitions_) {
  for (const std::string& warning : options_.warnings)
    ROS_WARN("%s", warning.c_str());
  service_ = node.advertiseService(ros_common::kAskHumanService, &SpeechDialogue::ask, this);
  node.setCallbackQueue(&recognitions_);
  recognised_ =
      node.subscribe(ros_common::kRecognisedSpeechTopic, kQueueSize, &SpeechDialogue::hear, this);
  listener_.start();
}

bool SpeechDialogue::ask(AskHuman::Request& request, AskHuman::Response& response) {
  const DialogueDiagnostics::Turn turn(diagnostics_, request, response);
  response.answer = AskHuman::Response::NONE;
  if (request.question.question_id == 0) return true;  // no question: there is nothing to wait for
  std::vector<Literal> fluents;
  try {
    fluents = ros_common::toLiterals(request.question.fluents, "question.fluents");
  } catch (const std::invalid_argument& error) {
    ROS_WARN("question %u is left unanswered: %s", request.question.question_id, error.what());
    response = responseTo(request.question, fluents, std::nullopt);
    return true;
  }
  const std::lock_guard<std::mutex> one_at_a_time(asking_);
  std::unique_lock<std::mutex> lock(mutex_);
  question_ = withTexts(request.question, fluents);
  reply_.reset();
  finished_ = false;
  changed_.notify_all();
  while (!finished_ && !ended_ && ros::ok())
    changed_.wait_for(lock, kTick);
  question_.reset();
  response = responseTo(request.question, fluents, reply_);
  return true;
}

// Without a reply the question is left as it is.
AskHuman::Response SpeechDialogue::responseTo(const Question& question,
                                              const std::vector<Literal>& fluents,
                                              const std::optional<phrasing::Reply>& reply) const {
  AskHuman::Response response;
  response.answer =
      reply ? static_cast<std::int8_t>(reply->kind) : std::int8_t{AskHuman::Response::NONE};
  response.question_id = question.question_id;
  response.answered_by = question.person.empty() ? options_.person : question.person;
  if (!reply) return response;
  for (const std::size_t index : reply->chosen)
    response.fluents.push_back(fluents.at(index).text());
  return response;
}

void SpeechDialogue::hear(const std_msgs::String::ConstPtr& text) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!listening_) {
      ROS_DEBUG("not listening: %s", text->data.c_str());
      return;
    }
    heard_.push_back(text->data);
  }
  changed_.notify_all();
}

void SpeechDialogue::run() {
  try {
    while (ros::ok()) {
      const auto question = awaitQuestion();
      if (question) {
        finish(converse(*question));
      } else if (const auto end = ends_.takeEnd()) {
        tellEnd(*end);
      }
    }
  } catch (...) {
    endSpeaking();  // or the threads of the callbacks could not be joined
    throw;
  }
  speech_.stop();
}

std::optional<Question> SpeechDialogue::awaitQuestion() {
  std::unique_lock<std::mutex> lock(mutex_);
  if (!question_ || finished_) changed_.wait_for(lock, kIdleTick);
  return finished_ ? std::nullopt : question_;
}

// Nothing where the question is over, or the node ends.
std::optional<phrasing::Reply> SpeechDialogue::converse(const Question& question) {
  phrasing::SpokenQuestion spoken(vocabulary_, question.text, question.why, clausesOf(question),
                                  options_.retries);
  const IsOver is_over = [&] { return !ros::ok() || watch_.isGone(question); };
  std::string next = spoken.asked();
  while (say(next, is_over)) {
    next.clear();
    const auto words = awaitWords(after(options_.reply_timeout), is_over);
    if (!words) {
      next = spoken.silence();
      continue;
    }
    auto turn = spoken.hear(*words);
    if (turn.reply) return turn.reply;
    next = turn.say;
  }
  return std::nullopt;
}

// Until the next question comes, or the next task.
void SpeechDialogue::tellEnd(const AlignmentState& end) {
  const IsOver is_over = [&] { return !ros::ok() || isQuestionWaiting() || ends_.isGone(end); };
  if (!end.alternatives.empty() && vocabulary_.atEnd() != nullptr) {
    offerAlternatives(end, is_over);
  } else if (speak(end.message, is_over) && end.outcome == AlignResult::SUCCESS) {
    tellPlan(end, is_over);
  }
  deafen();
}

void SpeechDialogue::tellPlan(const AlignmentState& end, const IsOver& is_over) {
  if (vocabulary_.atEnd() == nullptr) return;
  const auto last = after(kPlanPatience);
  std::optional<Plan> plan = ends_.takePlan(end);
  while (!plan && !is_over() && Clock::now() < last) {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait_for(lock, kTick);
    lock.unlock();
    plan = ends_.takePlan(end);
  }
  const std::string steps =
      plan ? phrasing::spokenPlan(*vocabulary_.atEnd(), plan->step_texts) : std::string();
  if (!steps.empty()) speak(steps, is_over);
}

void SpeechDialogue::offerAlternatives(const AlignmentState& end, const IsOver& is_over) {
  std::vector<std::string> offered;
  for (const AlternativeGoal& alternative : end.alternatives)
    offered.push_back(leftOutBy(alternative));
  // The message ends with the first ones.
  phrasing::SpokenChoice spoken(vocabulary_, end.message, phrasing::kSpokenAlternatives, offered,
                                options_.retries);
  phrasing::SpokenChoice::Turn turn{false, std::nullopt, spoken.asked()};
  while (say(turn.say, is_over)) {
    const auto words = awaitWords(after(options_.reply_timeout), is_over);
    if (is_over()) return;
    turn = words ? spoken.hear(*words) : spoken.silence();
    if (!turn.ended) continue;
    const std::string person = end.person.empty() ? options_.person : end.person;
    if (turn.chosen && !ends_.takeUp(end, end.alternatives.at(*turn.chosen), person)) {
      ROS_WARN("the chosen alternative was not taken up");
      return;
    }
    if (!turn.say.empty()) speak(turn.say, [] { return !ros::ok(); });
    return;
  }
}

// Speaks to the end, then listens; an empty text goes on listening. False where it is over.
bool SpeechDialogue::say(const std::string& text, const IsOver& is_over) {
  if (text.empty()) return !is_over();
  const bool goes_on = speak(text, is_over);
  listen();
  return goes_on;
}

// Deaf, and stays so.
bool SpeechDialogue::speak(const std::string& text, const IsOver& is_over) {
  deafen();
  const bool aloud = startSpeaking(text);
  const auto cut_off = after(options_.say_timeout);
  while (speech_.isRunning()) {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait_for(lock, kTick);
    lock.unlock();
    if (is_over()) break;
    if (Clock::now() < cut_off) continue;
    ROS_WARN("cut off after %g s: %s", options_.say_timeout, text.c_str());
    break;
  }
  if (aloud && !speech_.isRunning() && speech_.lastStatus() != 0)
    warnOnce(
        fmt::format("{} ended with status {}", options_.say_command.front(), speech_.lastStatus()));
  speech_.stop();
  if (aloud) awaitWords(after(options_.echo_time), is_over);  // deaf, it hears nothing
  return !is_over();
}

// False where nothing will be heard.
bool SpeechDialogue::startSpeaking(const std::string& text) {
  std_msgs::String message;
  message.data = text;
  said_.publish(message);
  const std::vector<std::string> command = options_.commandFor(text);
  if (command.empty()) return false;
  std::string fault;
  try {
    if (speech_.start(command)) return true;
    fault = "there is no program " + command.front();
  } catch (const std::system_error& error) {
    fault = error.what();
  }
  warnOnce(fault);
  return false;
}

void SpeechDialogue::warnOnce(const std::string& fault) {
  if (warned_) return;
  warned_ = true;
  ROS_WARN("nothing is said aloud: %s; the text is published on %s", fault.c_str(),
           said_.getTopic().c_str());
}

// What was recognised, or nothing when the time is up or it is over.
std::optional<std::string> SpeechDialogue::awaitWords(Clock::time_point until,
                                                      const IsOver& is_over) {
  while (!is_over()) {
    std::unique_lock<std::mutex> lock(mutex_);
    if (!heard_.empty()) {
      std::string words = std::move(heard_.front());
      heard_.pop_front();
      return words;
    }
    const auto now = Clock::now();
    if (now >= until) break;
    changed_.wait_until(lock, std::min(until, now + Clock::duration(kTick)));
  }
  return std::nullopt;
}

bool SpeechDialogue::isQuestionWaiting() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return question_ && !finished_;
}

void SpeechDialogue::deafen() {
  const std::lock_guard<std::mutex> lock(mutex_);
  listening_ = false;
  heard_.clear();
}

void SpeechDialogue::listen() {
  const std::lock_guard<std::mutex> lock(mutex_);
  listening_ = true;
}

void SpeechDialogue::finish(const std::optional<phrasing::Reply>& reply) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    listening_ = false;
    heard_.clear();
    reply_ = reply;
    finished_ = true;
  }
  changed_.notify_all();
}

void SpeechDialogue::endSpeaking() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ended_ = true;
  }
  changed_.notify_all();
}

}  // namespace goal_alignment::dialogues
