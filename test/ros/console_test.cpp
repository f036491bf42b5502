// SPDX-License-Identifier: BSD-3-Clause
// console_dialogue in a pseudo-terminal, as a person sits before it.
#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <string>

#include "aligner_calls.h"

namespace goal_alignment::test {
namespace {

using Clock = std::chrono::steady_clock;

// A program in a terminal of its own.
class Terminal {
 public:
  explicit Terminal(const std::string& program) {
    pid_ = forkpty(&terminal_, nullptr, nullptr, nullptr);
    if (pid_ == 0) {
      execl(program.c_str(), program.c_str(), static_cast<char*>(nullptr));
      _exit(127);
    }
  }

  ~Terminal() {
    if (pid_ > 0) kill(pid_, SIGKILL), waitpid(pid_, nullptr, 0);
    close(terminal_);
  }

  void type(const std::string& text) const {
    ASSERT_EQ(write(terminal_, text.data(), text.size()), static_cast<ssize_t>(text.size()));
  }

  // Reads on until the text has been shown; what was shown before it is used up.
  bool shows(const std::string& text) {
    const auto end = Clock::now() + std::chrono::duration<double>(kPatience);
    while (shown_.find(text) == std::string::npos) {
      if (Clock::now() > end || !readMore()) return false;
    }
    shown_.erase(0, shown_.find(text) + text.size());
    return true;
  }

  const std::string& shown() const { return shown_; }

  // The exit status, or -1 when it does not end in time.
  int exitStatus(double seconds) {
    int status = 0;
    const bool ended = eventually(
        [&] {
          readMore(0);  // a full terminal would block it
          return waitpid(pid_, &status, WNOHANG) == pid_;
        },
        seconds);
    if (!ended) return -1;
    pid_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }

 private:
  bool readMore(int milliseconds = 100) {
    pollfd descriptor{terminal_, POLLIN, 0};
    if (poll(&descriptor, 1, milliseconds) <= 0) return true;
    char buffer[512];
    const ssize_t count = read(terminal_, buffer, sizeof buffer);
    if (count <= 0) return false;
    shown_.append(buffer, static_cast<std::size_t>(count));
    return true;
  }

  pid_t pid_ = -1;
  int terminal_ = -1;
  std::string shown_;
};

class Console : public Scenario {
 protected:
  Console() : terminal_(NODE_FOLDER "/console_dialogue") {}
  Terminal terminal_;
};

TEST_F(Console, takesNoAndRepromptsOnRubbish) {
  sendAndAwaitQuestion(sweepHall());
  ASSERT_TRUE(terminal_.shows("for Ann")) << terminal_.shown();
  ASSERT_TRUE(terminal_.shows("Why I ask:")) << terminal_.shown();
  ASSERT_TRUE(terminal_.shows("> "));
  terminal_.type("bananas\n");
  ASSERT_TRUE(terminal_.shows("did not understand 'bananas'")) << terminal_.shown();
  terminal_.type("\n");
  ASSERT_TRUE(terminal_.shows("Question 1")) << "Enter shows it again" << terminal_.shown();
  ASSERT_TRUE(terminal_.shows("> "));
  terminal_.type("No\n");
  const AlignResult result = awaitResult();
  EXPECT_EQ(result.outcome, AlignResult::SUCCESS) << result.message;
}

TEST_F(Console, takesYesDontKnowAndDecline) {
  const std::vector<std::pair<std::string, int>> replies = {
      {"y\n", AlignResult::EXPECTATION_UNACHIEVABLE},
      {"?\n", AlignResult::UNSURE_BLOCKS},
      {"don't know\n", AlignResult::UNSURE_BLOCKS},
      {"decline\n", AlignResult::DECLINED}};
  for (const auto& [reply, outcome] : replies) {
    sendAndAwaitQuestion(sweepHall());
    ASSERT_TRUE(terminal_.shows("> ")) << terminal_.shown();
    terminal_.type(reply);
    const AlignResult result = awaitResult();
    EXPECT_EQ(result.outcome, outcome) << reply;
    if (result.alternatives.empty()) continue;
    ASSERT_TRUE(terminal_.shows("Go on without")) << terminal_.shown();
    ASSERT_TRUE(terminal_.shows("> ")) << terminal_.shown();
    terminal_.type("none\n");
    ASSERT_TRUE(terminal_.shows("So it is left")) << terminal_.shown();
  }
}

TEST_F(Console, takesWhatOneSays) {
  for (const char* reply : {"no, it does not matter\n", "I don't care\n", "of course not\n"}) {
    sendAndAwaitQuestion(sweepHall());
    ASSERT_TRUE(terminal_.shows("Question 1")) << terminal_.shown();
    ASSERT_TRUE(terminal_.shows("> ")) << terminal_.shown();
    terminal_.type(reply);
    EXPECT_EQ(awaitResult().outcome, AlignResult::SUCCESS) << reply;
  }
}

TEST_F(Console, goesOnWithTheAlternativeThatIsChosen) {
  sendAndAwaitQuestion(sweepHall());
  ASSERT_TRUE(terminal_.shows("> ")) << terminal_.shown();
  terminal_.type("yes\n");
  EXPECT_EQ(awaitResult().outcome, AlignResult::EXPECTATION_UNACHIEVABLE);
  ASSERT_TRUE(terminal_.shows("Go on without this")) << terminal_.shown();
  ASSERT_TRUE(terminal_.shows("> ")) << terminal_.shown();
  terminal_.type("yes please\n");
  EXPECT_TRUE(states_.waitFor([](const AlignmentState& state) {
    return state.phase == AlignmentState::DONE && state.outcome == AlignResult::SUCCESS;
  }));
}

TEST_F(Console, takesTheNumbersOfThoseOfAGroupThatMatter) {
  const Parameter groups("max_group_size", 2);
  const Question group = sendAndAwaitQuestion(lightLamps());
  ASSERT_TRUE(terminal_.shows("hich of these matter to you")) << terminal_.shown();
  ASSERT_TRUE(terminal_.shows("  2: " + group.fluents.at(1).text)) << terminal_.shown();
  ASSERT_TRUE(terminal_.shows("the numbers of those that matter, such as 1 2, n = none"))
      << terminal_.shown();
  ASSERT_TRUE(terminal_.shows("> "));
  terminal_.type("3\n");
  ASSERT_TRUE(terminal_.shows("did not understand '3'. the numbers")) << terminal_.shown();
  terminal_.type("2\n");
  ASSERT_TRUE(terminal_.shows("Question 2 for Ann")) << terminal_.shown();
  ASSERT_TRUE(terminal_.shows("oes it matter to you")) << terminal_.shown();
  ASSERT_TRUE(terminal_.shows("> "));
  terminal_.type("n\n");
  const AlignResult result = awaitResult();
  EXPECT_EQ(result.outcome, AlignResult::SUCCESS) << result.message;
  const auto guaranteed = textsOf(result.plan.guaranteed);
  EXPECT_EQ(guaranteed, (std::vector<std::string>{"(checked)", textOf(group.fluents[1])}));
}

TEST_F(Console, leavesTheQuestionWhenAnotherAnswererWasFaster) {
  const Question question = sendAndAwaitQuestion(sweepHall());
  ASSERT_TRUE(terminal_.shows("> "));
  EXPECT_TRUE(answer(Answer::Request::NO, question.question_id).accepted);
  EXPECT_TRUE(terminal_.shows("no longer open")) << terminal_.shown();
  EXPECT_EQ(awaitResult().outcome, AlignResult::SUCCESS);
  terminal_.type("y\n");
  EXPECT_TRUE(terminal_.shows("There is no question open")) << terminal_.shown();
}

TEST_F(Console, endsAtOnceOnCtrlCWhileItWaitsForALine) {
  const Question question = sendAndAwaitQuestion(sweepHall());
  ASSERT_TRUE(terminal_.shows("> "));
  terminal_.type("\x03");
  EXPECT_EQ(terminal_.exitStatus(kPatience), 0);
  EXPECT_TRUE(answer(Answer::Request::NO, question.question_id).accepted) << "others may answer";
  EXPECT_EQ(awaitResult().outcome, AlignResult::SUCCESS);
}

TEST_F(Console, endsCleanlyAtTheEndOfInputAndAnswersNothing) {
  const Question question = sendAndAwaitQuestion(sweepHall());
  ASSERT_TRUE(terminal_.shows("> "));
  terminal_.type("\x04");
  EXPECT_TRUE(terminal_.shows("End of input")) << terminal_.shown();
  EXPECT_EQ(terminal_.exitStatus(kPatience), 0);
  EXPECT_TRUE(answer(Answer::Request::NO, question.question_id).accepted) << "it is still open";
  EXPECT_EQ(awaitResult().outcome, AlignResult::SUCCESS);
}

TEST_F(Console, endsOnCtrlCWithoutAQuestion) {
  ASSERT_TRUE(isOffered("/ask_human"));
  terminal_.type("\x03");
  EXPECT_EQ(terminal_.exitStatus(kPatience), 0);
}

}  // namespace
}  // namespace goal_alignment::test
