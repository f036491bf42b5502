// SPDX-License-Identifier: BSD-3-Clause
// A task that its publisher shows to whoever comes: it is taken up once, whatever happens to the
// aligner.
#include "own_aligner.h"

namespace goal_alignment::test {
namespace {

constexpr const char* kModels[][2] = {{"robot_domain", "robot_domain.pddl"},
                                      {"robot_problem", "two_rooms.pddl"},
                                      {"human_domain", "human_domain.pddl"},
                                      {"human_problem", "two_rooms.pddl"}};

class Latched : public OwnAligner {
 protected:
  Latched() : tasks_(node_.advertise<HumanTask>("/human_task", 1, true)) {
    task_.task_id = "sweep";
    task_.plan = {step("sweep", {"hall"}), step("sweep", {"kitchen"})};
  }

  void SetUp() override {
    for (const auto& [parameter, file] : kModels)
      ros::param::set(std::string("/goal_alignment/") + parameter, model(file));
    tasks_.publish(task_);
    ASSERT_NO_FATAL_FAILURE(startAligner());
  }

  void TearDown() override {
    OwnAligner::TearDown();
    for (const auto& [parameter, file] : kModels)
      ros::param::del(std::string("/goal_alignment/") + parameter);
  }

  bool isLeftOut() {
    return eventually([this] {
      return alignersOutput().find("task sweep is only latched") != std::string::npos;
    });
  }

  ros::Publisher tasks_;
  HumanTask task_;
};

TEST_F(Latched, taskFromBeforeTheFirstStartIsTakenUpAndNotAgainAfterARestart) {
  const Question first = awaitQuestionAfter(0);
  EXPECT_EQ(alignersOutput().find("only latched"), std::string::npos);
  killAligner();
  ASSERT_NO_FATAL_FAILURE(startAligner());
  EXPECT_TRUE(isLeftOut()) << "and the log says so";
  EXPECT_TRUE(questionIsClosed());
  EXPECT_TRUE(eventually([this] {
    return states_.last()->phase == AlignmentState::DONE &&
           states_.last()->outcome == AlignResult::CANCELED;
  })) << "it is told to be lost, and is not begun again";

  EXPECT_TRUE(eventually([&] {
    tasks_.publish(task_);  // not in one breath with what was left out: that would be a stream
    return questions_
        .waitFor([&](const Question& shown) { return shown.question_id > first.question_id; }, 2)
        .has_value();
  })) << "published anew it counts";
}

TEST_F(Latched, taskThatCameWhileNoAlignerWasThereIsTakenUp) {
  const Question first = awaitQuestionAfter(0);
  killAligner();
  task_.task_id = "another";
  tasks_.publish(task_);
  ASSERT_NO_FATAL_FAILURE(startAligner());
  awaitQuestionAfter(first.question_id);
  EXPECT_TRUE(eventually([this] { return states_.last()->task_id == "another"; }));
}

}  // namespace
}  // namespace goal_alignment::test
