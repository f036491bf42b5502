// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/dialogues/prompted_terminal.h"

#include <gtest/gtest.h>

#include <sstream>

namespace goal_alignment::dialogues {
namespace {

class PromptedTerminalTest : public testing::Test {
 protected:
  // What has come out since the last call.
  std::string shown() {
    const std::string text = out_.str();
    out_.str("");
    return text;
  }

  std::ostringstream out_;
  PromptedTerminal terminal_{out_};
  TerminalStream others_{terminal_};
};

TEST_F(PromptedTerminalTest, putsThePromptAgainBelowWhatOthersWrite) {
  terminal_.open("Tea? > ");
  EXPECT_EQ(shown(), "\nTea? > ");
  others_ << "step 1 of " << 2 << "\n" << std::flush;
  EXPECT_EQ(shown(), "\nstep 1 of 2\n\nTea? > ");
  terminal_.close();
  others_ << "step 2 of 2\n" << std::flush;
  EXPECT_EQ(shown(), "step 2 of 2\n") << "nothing is open any more";
}

TEST_F(PromptedTerminalTest, keepsTogetherWhatIsFlushedTogether) {
  terminal_.open("> ");
  shown();
  others_ << "a";
  EXPECT_EQ(shown(), "");
  others_ << "b\n" << std::flush << std::flush;
  EXPECT_EQ(shown(), "\nab\n\n> ");
}

TEST_F(PromptedTerminalTest, showsThePromptOnDemand) {
  terminal_.open("Tea? > ");
  shown();
  terminal_.showAgain();
  EXPECT_EQ(shown(), "Tea? > ");
  terminal_.hint("Yes or no?\n> ");
  EXPECT_EQ(shown(), "Yes or no?\n> ");
  terminal_.close("It is over.\n");
  EXPECT_EQ(shown(), "It is over.\n");
}

}  // namespace
}  // namespace goal_alignment::dialogues
