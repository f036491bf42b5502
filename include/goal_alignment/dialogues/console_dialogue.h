// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/service_server.h>

#include <array>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "goal_alignment/AlternativeGoal.h"
#include "goal_alignment/AskHuman.h"
#include "goal_alignment/dialogues/dialogue_diagnostics.h"
#include "goal_alignment/dialogues/line_reader.h"
#include "goal_alignment/dialogues/prompted_terminal.h"
#include "goal_alignment/dialogues/question_watch.h"
#include "goal_alignment/phrasing/reply.h"
#include "goal_alignment/phrasing/vocabulary.h"

namespace goal_alignment::dialogues {

/// Answers `ask_human` by asking a person in a terminal, who may type keys or what one says. Leaves
/// a question at once when `~question` shows that it is over; ends at the end of input and at
/// shutdown, even while it waits for a line.
class ConsoleDialogue {
 public:
  /// `terminal` outlives this. It speaks the language of `phrases`.
  ConsoleDialogue(ros::NodeHandle node, int input, PromptedTerminal& terminal,
                  phrasing::Vocabulary vocabulary, phrasing::Phrases phrases = {});

  /// Talks to the person until the input ends or the node shuts down. The calling thread alone
  /// reads the terminal; callbacks must run in others.
  void run();

  /// Asks which of the alternatives to go on with, and waits for it in another thread than run().
  /// Nothing where the person wants none of them, nobody is left to ask, or `is_gone`.
  std::optional<std::size_t> choose(const std::vector<AlternativeGoal>& alternatives,
                                    const std::function<bool()>& is_gone);

  /// Whether nobody is asked any more.
  bool hasEnded();

 private:
  using Clock = std::chrono::steady_clock;

  // Wakes the terminal's thread from others.
  struct WakePipe {
    WakePipe();
    ~WakePipe();
    WakePipe(const WakePipe&) = delete;
    WakePipe& operator=(const WakePipe&) = delete;
    std::array<int, 2> ends{};
  };

  // What the person is asked. Its functions are called by the terminal's thread, under mutex_,
  // while put() waits.
  struct Prompt {
    std::string text;
    std::string keys;  // how one may answer
    enum class Taken { Answer, Again, Why, Nothing };
    std::function<Taken(const std::string& line)> take;
    std::string why;  // said to who asks for it
    std::function<bool()> is_gone;
  };

  bool ask(AskHuman::Request& request, AskHuman::Response& response);
  void put(const Prompt& prompt);
  void wake() const;
  void showNewPrompt();
  void leavePromptIfGone();
  void treatLine(const std::string& line);
  void finish();
  void sayGoodbye();
  bool cameTooEarly() const;

  PromptedTerminal& terminal_;
  phrasing::Vocabulary vocabulary_;
  const phrasing::Phrases phrases_;
  WakePipe wake_pipe_;
  LineReader lines_;

  std::mutex asking_;  // one prompt at a time, whoever asks
  std::mutex mutex_;   // guards the four below
  std::condition_variable answered_;
  std::optional<Prompt> prompt_;
  std::uint64_t number_ = 0;  // of the prompt
  bool finished_ = false;     // it was answered, or left
  bool ended_ = false;

  // Of the terminal's thread alone.
  std::uint64_t shown_ = 0;        // the prompt's number; 0: none
  bool replaced_another_ = false;  // the one before this vanished under the person's hands
  Clock::time_point shown_at_;

  QuestionWatch watch_;
  DialogueDiagnostics diagnostics_;
  ros::ServiceServer service_;
};

}  // namespace goal_alignment::dialogues
