// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <fstream>
#include <stdexcept>

#include "goal_alignment/common/yaml_reader.h"
#include "goal_alignment/dialogues/line_reader.h"
#include "goal_alignment/dialogues/question_watch.h"
#include "goal_alignment/dialogues/scripted_dialogue.h"

namespace goal_alignment::dialogues {
namespace {

using Response = AskHuman::Response;

Question questionOf(const std::vector<std::string>& names) {
  Question question;
  question.question_id = 7;
  for (const std::string& name : names) {
    Fluent fluent;
    fluent.name = name;
    question.fluents.push_back(fluent);
  }
  return question;
}

class Lines : public testing::Test {
 protected:
  Lines() {
    EXPECT_EQ(pipe(input_.data()), 0);
    EXPECT_EQ(pipe(wake_.data()), 0);
  }
  ~Lines() override {
    for (const int end : {input_[0], wake_[0], wake_[1]})
      close(end);
    if (open_) close(input_[1]);
  }
  void write(const std::string& text) const {
    EXPECT_EQ(::write(input_[1], text.data(), text.size()), static_cast<ssize_t>(text.size()));
  }
  void end() {
    close(input_[1]);
    open_ = false;
  }

  std::array<int, 2> input_{};
  std::array<int, 2> wake_{};
  bool open_ = true;
};

TEST_F(Lines, areCutAndTheEndIsSeenAfterTheLast) {
  LineReader lines(input_[0], wake_[0]);
  write("one\ntw");
  lines.wait(std::chrono::milliseconds(1000));
  EXPECT_EQ(lines.nextLine(), "one");
  EXPECT_EQ(lines.nextLine(), std::nullopt);
  write("o\nthree");
  end();
  lines.wait(std::chrono::milliseconds(1000));
  EXPECT_FALSE(lines.atEnd());
  EXPECT_EQ(lines.nextLine(), "two");
  lines.wait(std::chrono::milliseconds(1000));
  EXPECT_EQ(lines.nextLine(), "three") << "a last line without its end";
  EXPECT_TRUE(lines.atEnd());
}

TEST_F(Lines, areNotWaitedForWhenSomethingElseWakes) {
  LineReader lines(input_[0], wake_[0]);
  EXPECT_EQ(::write(wake_[1], "x", 1), 1);
  lines.wait(std::chrono::hours(1));
  EXPECT_EQ(lines.nextLine(), std::nullopt);
  EXPECT_FALSE(lines.atEnd());
}

TEST(Scripted, wantsWhatItsListHolds) {
  const TrueGoal goal = {Literal::parse("(a)")};
  EXPECT_EQ(int{answerFor(questionOf({"A"}), goal).answer}, Response::YES);
  EXPECT_EQ(int{answerFor(questionOf({"b"}), goal).answer}, Response::NO);
  const Response group = answerFor(questionOf({"a", "b"}), goal);
  EXPECT_EQ(int{group.answer}, Response::YES);
  EXPECT_EQ(group.fluents, std::vector<std::string>{"(a)"});
  EXPECT_EQ(group.question_id, 7U);
}

TEST(Scripted, readsListsAndFiles) {
  XmlRpc::XmlRpcValue list;
  list[0] = "(on A b)";
  EXPECT_EQ(readTrueGoal(list).count(Literal::parse("(on a b)")), 1U);
  list[1] = 3;
  EXPECT_THROW(readTrueGoal(list), std::invalid_argument);
  EXPECT_THROW(readTrueGoal(XmlRpc::XmlRpcValue(5)), std::invalid_argument);

  const std::string name = testing::TempDir() + "true_goal." + std::to_string(getpid());
  const auto readAs = [&](const std::string& ending, const std::string& text) {
    std::ofstream(name + ending) << text;
    const TrueGoal goal = readTrueGoal(XmlRpc::XmlRpcValue(name + ending));
    std::remove((name + ending).c_str());
    return goal;
  };
  EXPECT_EQ(readAs(".txt", "(a) ; comment\n(not (b))\n").size(), 2U);
  EXPECT_EQ(readAs(".yaml", "true_goal: [(a), \"(b c)\"]").size(), 2U);
  EXPECT_EQ(readAs(".yml", "- (a)\n").size(), 1U);
  EXPECT_EQ(readAs(".yaml", "# nobody wants anything\n").size(), 0U);
  EXPECT_THROW(readAs(".yaml", "true_goal: {a: b}"), YamlError);
  EXPECT_THROW(readAs(".yaml", "true_goal:"), YamlError);
  EXPECT_THROW(readAs(".yaml", "something: else"), YamlError);
  EXPECT_THROW(readAs(".yaml", "[(a), \"((\"]"), YamlError);
  EXPECT_THROW(readTrueGoal(XmlRpc::XmlRpcValue("/nowhere/at/all.txt")), std::runtime_error);
}

TEST(QuestionWatch, onlyWhatCameLaterEndsAQuestion) {
  Question asked = questionOf({"a"});
  asked.header.stamp = ros::Time(10, 0);
  Question shown = asked;
  EXPECT_FALSE(endsQuestion(shown, 7, asked));
  shown.question_id = 8;
  EXPECT_TRUE(endsQuestion(shown, 8, asked));
  shown.question_id = 6;
  EXPECT_FALSE(endsQuestion(shown, 6, asked));
}

TEST(QuestionWatch, noneIsOpenEndsAQuestionThatWasShownOrIsOlder) {
  Question asked = questionOf({"a"});
  asked.header.stamp = ros::Time(10, 0);
  Question none;
  none.header.stamp = ros::Time(10, 0);
  EXPECT_FALSE(endsQuestion(none, 6, asked)) << "shown before it was asked";
  EXPECT_TRUE(endsQuestion(none, 7, asked)) << "though the clock stands still";
  none.header.stamp = ros::Time(10, 1);
  EXPECT_TRUE(endsQuestion(none, 0, asked)) << "the node came late and never saw it";
}

}  // namespace
}  // namespace goal_alignment::dialogues
