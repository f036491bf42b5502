// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/dialogues/prompted_terminal.h"

namespace goal_alignment::dialogues {

void PromptedTerminal::open(const std::string& prompt) {
  const std::lock_guard<std::mutex> lock(mutex_);
  prompt_ = prompt;
  out_ << '\n' << prompt_ << std::flush;
}

void PromptedTerminal::showAgain() {
  const std::lock_guard<std::mutex> lock(mutex_);
  out_ << prompt_ << std::flush;
}

void PromptedTerminal::hint(const std::string& text) {
  const std::lock_guard<std::mutex> lock(mutex_);
  out_ << text << std::flush;
}

void PromptedTerminal::close(const std::string& last_words) {
  const std::lock_guard<std::mutex> lock(mutex_);
  prompt_.clear();
  out_ << last_words << std::flush;
}

// The cursor stands behind the prompt, perhaps behind a part of an answer.
void PromptedTerminal::write(const std::string& text) {
  if (text.empty()) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  if (prompt_.empty()) {
    out_ << text << std::flush;
  } else {
    out_ << '\n' << text << '\n' << prompt_ << std::flush;
  }
}

int TerminalStream::Buffer::sync() {
  terminal_.write(str());
  str("");
  return 0;
}

}  // namespace goal_alignment::dialogues
