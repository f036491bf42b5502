// SPDX-License-Identifier: BSD-3-Clause
// Tasks that come while a plan is being carried out: they wait, each on its own, or are refused.
#include <std_msgs/String.h>

#include "aligner_calls.h"
#include "fake_executor.h"
#include "goals_by_hand.h"

namespace goal_alignment::test {
namespace {

using actionlib_msgs::GoalStatus;

AlignGoal named(AlignGoal goal, const std::string& task_id) {
  goal.task.task_id = task_id;
  return goal;
}

class Busy : public GoalsByHand {
 protected:
  Busy() : events_(node_, "/goal_alignment/events"), executor_(node_) {}

  void SetUp() override {
    GoalsByHand::SetUp();
    ASSERT_TRUE(eventually([this] { return executor_.isHeard() && events_.isHeard(); }));
    beginAPlan();  // from now on the aligner knows the executor
    executor_.finish();
    const std::string probe = send(named(sweepHall(), "idle"));
    ASSERT_TRUE(asksFor("idle"));
    cancel(probe);
    resultOf(probe);
    ASSERT_TRUE(questionIsClosed());
  }

  void TearDown() override {
    for (const WaitingTask& task : currentState().waiting)
      cancel(task.goal_id);
    EXPECT_TRUE(eventually([] { return currentState().waiting.empty(); }));
    executor_.finish();
    GoalsByHand::TearDown();
  }

  static bool waits(const std::string& id) {
    const auto waiting = currentState().waiting;
    return std::any_of(waiting.begin(), waiting.end(),
                       [&](const WaitingTask& task) { return task.goal_id == id; });
  }

  /// A plan is carried out, and the aligner has heard of it: goals sent before that begin.
  void beginAPlan() {
    executor_.begin();
    EXPECT_TRUE(eventually([this] {
      const std::string probe = send(named(sweepHall(), "probe"));
      const bool known = eventually([&] { return waits(probe); }, 0.5);
      cancel(probe);
      resultOf(probe);
      return known;
    }));
    EXPECT_TRUE(questionIsClosed());
  }

  std::string sendToWait(const AlignGoal& goal) {
    const std::string id = send(goal);
    EXPECT_TRUE(eventually([&] { return waits(id); }));
    return id;
  }

  std::vector<std::string> waitingTasks() {
    std::vector<std::string> ids;
    for (const WaitingTask& task : currentState().waiting)
      ids.push_back(task.task_id);
    return ids;
  }

  bool asksFor(const std::string& task_id) {
    return eventually([&] {
      const AlignmentState state = currentState();
      return state.task_id == task_id && state.phase == AlignmentState::AWAITING_ANSWER;
    });
  }

  std::size_t toldOf(const std::string& part) {
    const auto all = events_.all();
    return static_cast<std::size_t>(std::count_if(all.begin(), all.end(), [&](const auto& line) {
      return line.data.find(part) != std::string::npos;
    }));
  }

  Topic<std_msgs::String> events_;
  FakeExecutor executor_;
};

TEST_F(Busy, tasksWaitInTheirOrderAndBeginWhenThePlanIsDone) {
  beginAPlan();
  std::vector<std::string> ids;
  for (const char* task : {"first", "second", "third", "fourth"})
    ids.push_back(sendToWait(named(sweepHall(), task)));
  const auto shown =
      states_.waitFor([](const AlignmentState& state) { return state.waiting.size() == 4; });
  ASSERT_TRUE(shown) << "~state is published when the queue changes";
  for (std::size_t i = 0; i < ids.size(); ++i)
    EXPECT_EQ(shown->waiting[i].goal_id, ids[i]);
  EXPECT_EQ(shown->waiting[2].task_id, "third");
  EXPECT_EQ(shown->waiting[2].person, "Ann");
  EXPECT_FALSE(shown->waiting[2].since.isZero());

  const AlignActionResult fifth = resultOf(send(named(sweepHall(), "fifth")));
  EXPECT_EQ(int{fifth.status.status}, int{GoalStatus::REJECTED});
  EXPECT_EQ(fifth.result.outcome, AlignResult::BUSY);
  EXPECT_NE(fifth.result.message.find("4 tasks wait"), std::string::npos) << fifth.result.message;

  executor_.finish();
  for (const char* task : {"first", "second", "third", "fourth"}) {
    EXPECT_TRUE(asksFor(task)) << task;
    const std::size_t left = waitingTasks().size();
    cancel(ids[3 - left]);
    expectCanceled(resultOf(ids[3 - left]), GoalStatus::PREEMPTED);
  }
  EXPECT_TRUE(waitingTasks().empty());
}

TEST_F(Busy, eachTaskThatWaitsIsCanceledOnItsOwn) {
  beginAPlan();
  const std::string first = sendToWait(named(sweepHall(), "first"));
  ros::Publisher tasks = node_.advertise<HumanTask>("/human_task", 1);
  ASSERT_TRUE(eventually([&] { return tasks.getNumSubscribers() > 0; }));
  HumanTask by_topic;
  by_topic.task_id = "by topic";
  tasks.publish(by_topic);
  ASSERT_TRUE(eventually([&] { return waitingTasks().size() == 2; }));
  const std::string third = sendToWait(named(sweepHall(), "third"));

  const std::string id = currentState().waiting.at(1).goal_id;
  cancel(id);
  expectCanceled(resultOf(id), GoalStatus::RECALLED);
  EXPECT_EQ(waitingTasks(), (std::vector<std::string>{"first", "third"}));
  cancel(first);
  expectCanceled(resultOf(first), GoalStatus::RECALLED);
  executor_.finish();
  EXPECT_TRUE(asksFor("third"));
  cancel(third);
  expectCanceled(resultOf(third), GoalStatus::PREEMPTED);
}

TEST_F(Busy, tasksAreRefusedWhereThePolicySaysSo) {
  const Parameter policy("busy_policy", "refuse");
  const std::string before = send(sweepSilently());
  const AlignResult plan = resultOf(before).result;
  ASSERT_EQ(plan.outcome, AlignResult::SUCCESS);
  // Which is not known to be carried out yet: this one is refused as soon as it is.
  executor_.begin();
  const AlignActionResult refused = resultOf(send(named(sweepHall(), "refused")));
  EXPECT_EQ(int{refused.status.status}, int{GoalStatus::REJECTED});
  EXPECT_EQ(refused.result.outcome, AlignResult::BUSY);
  EXPECT_EQ(refused.result.message,
            "plan " + std::to_string(plan.plan.plan_id) + " for Ann is being carried out");
  EXPECT_EQ(currentState().session_id, plan.session_id) << "~state stays that of the plan";
  EXPECT_TRUE(eventually([this] { return toldOf("task refused is refused (65)") == 1; }));
  executor_.finish();
}

TEST_F(Busy, whatGoesOnWithASessionNeverWaits) {
  const AlignResult plan = resultOf(send(sweepSilently())).result;
  ASSERT_EQ(plan.outcome, AlignResult::SUCCESS);
  executor_.begin();
  const std::string other = sendToWait(named(sweepHall(), "other"));
  AlignGoal goal;
  goal.continue_session = plan.session_id;
  goal.max_questions = -1;
  const AlignResult again = resultOf(send(goal)).result;
  EXPECT_EQ(again.outcome, AlignResult::SUCCESS) << again.message;
  EXPECT_EQ(again.session_id, plan.session_id);
  EXPECT_TRUE(waits(other));
}

TEST_F(Busy, betweenAPlanAndItsBeginningNobodySlipsIn) {
  ASSERT_EQ(resultOf(send(sweepSilently())).result.outcome, AlignResult::SUCCESS);
  const std::string second = sendToWait(named(sweepHall(), "second"));
  executor_.begin();
  EXPECT_EQ(waitingTasks(), std::vector<std::string>{"second"});
  executor_.finish();
  EXPECT_TRUE(asksFor("second"));
  cancel(second);
  resultOf(second);
}

TEST_F(Busy, aPlanThatNobodyCarriesOutHoldsNobodyUpForLong) {
  ASSERT_EQ(resultOf(send(sweepSilently())).result.outcome, AlignResult::SUCCESS);
  const std::string second = send(named(sweepHall(), "second"));
  EXPECT_TRUE(asksFor("second"));
  cancel(second);
  resultOf(second);
}

TEST_F(Busy, anExecutorThatFallsSilentIsAwaitedNoLonger) {
  beginAPlan();
  const std::string id = sendToWait(named(sweepHall(), "patient"));
  executor_.fallSilent();
  EXPECT_TRUE(asksFor("patient"));
  cancel(id);
  resultOf(id);
}

TEST_F(Busy, anEqualGoalWhosePlanIsCarriedOutIsRefused) {
  ASSERT_EQ(resultOf(send(sweepSilently())).result.outcome, AlignResult::SUCCESS);
  executor_.begin();
  const AlignActionResult again = resultOf(send(sweepSilently()));
  EXPECT_EQ(int{again.status.status}, int{GoalStatus::REJECTED});
  EXPECT_EQ(again.result.outcome, AlignResult::BUSY);
  executor_.finish();
  EXPECT_TRUE(eventually([this] {
    return resultOf(send(sweepSilently())).result.outcome == AlignResult::SUCCESS;
  })) << "it can be done again";
}

// Tasks by the topic; the models are the node's.
class OneTask : public Busy {
 protected:
  OneTask() : tasks_(node_.advertise<HumanTask>("/human_task", 100)) {
    task_.task_id = "sweep";
    task_.plan = {step("sweep", {"hall"}), step("sweep", {"kitchen"})};
  }

  void SetUp() override {
    Busy::SetUp();
    ASSERT_TRUE(eventually([this] { return tasks_.getNumSubscribers() > 0; }));
  }

  /// As `rostopic pub -r` does, with a new stamp each time.
  void publish(int copies = 1) {
    for (int i = 0; i < copies; ++i) {
      task_.header.stamp += ros::Duration(1);
      tasks_.publish(task_);
    }
  }

  void answerAll() {
    std::uint32_t newest = 0;
    for (int i = 0; i < 2; ++i) {
      ASSERT_TRUE(asksFor("sweep"));
      ASSERT_TRUE(eventually([&] {
        newest = questions_.last()->question_id;
        return newest != 0 && answer(Answer::Request::NO, newest).accepted;
      }));
    }
  }

  void cancelAll() {
    cancels_.publish(actionlib_msgs::GoalID{});
    EXPECT_TRUE(questionIsClosed());
  }

  std::size_t begun() { return toldOf("task sweep:"); }

  ros::Publisher tasks_;
  HumanTask task_;
};

TEST_F(OneTask, isBegunOnceHoweverOftenItIsPublished) {
  publish(20);
  ASSERT_TRUE(asksFor("sweep"));
  EXPECT_TRUE(eventually([this] { return toldOf("comes again") == 1; })) << "with a warning";
  publish(20);
  answerAll();
  ASSERT_TRUE(eventually([] { return currentState().outcome == AlignResult::SUCCESS; }));
  executor_.begin();
  publish(20);
  // What is heard after all of them waits alone.
  HumanTask other = task_;
  other.task_id = "other";
  tasks_.publish(other);
  ASSERT_TRUE(eventually([this] { return waitingTasks() == std::vector<std::string>{"other"}; }));
  EXPECT_EQ(begun(), 1U);
  EXPECT_EQ(toldOf("comes again"), 1U) << "not for each of them";

  cancel(currentState().waiting.at(0).goal_id);
  executor_.finish();
  EXPECT_TRUE(eventually([this] {
    publish();
    return eventually([this] { return begun() == 2; }, 2);
  })) << "who wants it again when it is done gets it";
  task_.person = "Ben";
  publish();
  EXPECT_TRUE(eventually([this] { return toldOf("task sweep from Ben:") == 1; }))
      << "a task of another person";
  EXPECT_TRUE(asksFor("sweep"));
  EXPECT_EQ(currentState().person, "Ben");
  cancelAll();
}

}  // namespace
}  // namespace goal_alignment::test
