// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>
#include <mutex>
#include <ostream>
#include <sstream>
#include <string>

namespace goal_alignment::dialogues {

/// A terminal in which a person is asked something while others write to it: what they write does
/// not hide the prompt, which is put again below. Thread-safe.
class PromptedTerminal {
 public:
  explicit PromptedTerminal(std::ostream& out) : out_(out) {}

  /// From now on this is open: shown now, and again after all that others write.
  void open(const std::string& prompt);
  void showAgain();
  /// Of whoever asks; ends in a prompt.
  void hint(const std::string& text);
  /// Nothing is open any more; `last_words` are shown.
  void close(const std::string& last_words = "");
  /// Of others.
  void write(const std::string& text);

 private:
  std::mutex mutex_;
  std::ostream& out_;
  std::string prompt_;  // empty: nothing is open
};

/// A stream into such a terminal: what is written comes out when it is flushed, all at once.
class TerminalStream : public std::ostream {
 public:
  explicit TerminalStream(PromptedTerminal& terminal) : std::ostream(nullptr), buffer_(terminal) {
    rdbuf(&buffer_);
  }

 private:
  class Buffer : public std::stringbuf {
   public:
    explicit Buffer(PromptedTerminal& terminal) : terminal_(terminal) {}

   private:
    int sync() override;

    PromptedTerminal& terminal_;
  };

  Buffer buffer_;
};

}  // namespace goal_alignment::dialogues
