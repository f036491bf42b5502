// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/service_server.h>
#include <ros/spinner.h>
#include <ros/subscriber.h>
#include <std_msgs/String.h>

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "goal_alignment/AskHuman.h"
#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/dialogues/dialogue_diagnostics.h"
#include "goal_alignment/dialogues/outcome_watch.h"
#include "goal_alignment/dialogues/question_watch.h"
#include "goal_alignment/dialogues/speech_options.h"
#include "goal_alignment/dialogues/speech_process.h"
#include "goal_alignment/phrasing/reply.h"
#include "goal_alignment/phrasing/spoken_question.h"
#include "goal_alignment/phrasing/vocabulary.h"

namespace goal_alignment::dialogues {

/// Answers `ask_human` by speech: says the question, and takes what a speech recogniser heard from
/// `recognised_speech`. What comes while it speaks itself, shortly after, or without a question
/// counts for nothing. Leaves a question at once when `~question` shows that it is over. It says
/// how a task ended, and takes up the alternative that the person names. All that it says stands on
/// `~said`, also where nothing can say it aloud. It listens on a thread of its own, however many
/// calls wait.
class SpeechDialogue {
 public:
  /// Throws ParameterError, YamlError, or what pddl::readFile() throws.
  SpeechDialogue(ros::NodeHandle node, ros::NodeHandle private_node);

  /// Speaks and listens until the node shuts down, on the calling thread; callbacks must run in
  /// others. With an exception it leaves, all calls that wait end without an answer.
  void run();

 private:
  using Clock = std::chrono::steady_clock;

  bool ask(AskHuman::Request& request, AskHuman::Response& response);
  void hear(const std_msgs::String::ConstPtr& text);
  AskHuman::Response responseTo(const Question& question, const std::vector<Literal>& fluents,
                                const std::optional<phrasing::Reply>& reply) const;

  // Of the speaking thread.
  using IsOver = std::function<bool()>;
  std::optional<Question> awaitQuestion();
  std::optional<phrasing::Reply> converse(const Question& question);
  void tellEnd(const AlignmentState& end);
  void tellPlan(const AlignmentState& end, const IsOver& is_over);
  void offerAlternatives(const AlignmentState& end, const IsOver& is_over);
  bool say(const std::string& text, const IsOver& is_over);
  bool speak(const std::string& text, const IsOver& is_over);
  bool startSpeaking(const std::string& text);
  void warnOnce(const std::string& fault);
  std::optional<std::string> awaitWords(Clock::time_point until, const IsOver& is_over);
  bool isQuestionWaiting();
  void deafen();
  void listen();
  void finish(const std::optional<phrasing::Reply>& reply);
  void endSpeaking();

  SpeechOptions options_;
  phrasing::Vocabulary vocabulary_;
  SpeechProcess speech_;
  bool warned_ = false;  // that nothing can be said aloud

  std::mutex asking_;         // one question at a time, whoever asks
  mutable std::mutex mutex_;  // guards the six below
  std::condition_variable changed_;
  std::optional<Question> question_;
  bool finished_ = false;  // the question was answered, or left without a reply
  bool ended_ = false;     // nobody speaks any more
  std::optional<phrasing::Reply> reply_;
  bool listening_ = false;
  std::deque<std::string> heard_;  // while it listened

  ros::Publisher said_;
  ros::CallbackQueue recognitions_;
  ros::Subscriber recognised_;
  QuestionWatch watch_;
  DialogueDiagnostics diagnostics_;
  OutcomeWatch ends_;
  ros::ServiceServer service_;
  ros::AsyncSpinner listener_;
};

}  // namespace goal_alignment::dialogues
