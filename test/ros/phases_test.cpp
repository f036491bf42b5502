// SPDX-License-Identifier: BSD-3-Clause
// Cancels and newer goals, at every moment of an alignment.
#include <set>
#include <thread>

#include "generated_tasks.h"
#include "goals_by_hand.h"

namespace goal_alignment::test {
namespace {

using actionlib_msgs::GoalStatus;

// A moment at which the work on a goal stays for long.
struct Moment {
  const char* name;
  AlignGoal (*goal)();
  std::uint8_t phase;
  float progress;  // at least
};

void PrintTo(const Moment& moment, std::ostream* out) {
  *out << moment.name;
}

class Phases : public GoalsByHand, public testing::WithParamInterface<Moment> {
 protected:
  void SetUp() override {
    ros::param::set("/goal_alignment/plan", "optimal");
    GoalsByHand::SetUp();
  }

  void TearDown() override {
    if (!last_.empty()) cancel(last_);
    GoalsByHand::TearDown();
    ros::param::del("/goal_alignment/plan");
  }

  // Sends the moment's goal and waits until it has come.
  std::string sendAndAwaitMoment() {
    const Moment& moment = GetParam();
    std::set<std::string> sessions;
    for (const AlignmentState& state : states_.all())
      sessions.insert(state.session_id);
    last_ = send(moment.goal());
    EXPECT_TRUE(states_.waitFor([&](const AlignmentState& state) {
      return sessions.count(state.session_id) == 0 && state.phase == moment.phase &&
             state.progress >= moment.progress;
    })) << "the moment did not come";
    return last_;
  }

  void expectServed() {
    const std::string id = send(sweepSilently());
    EXPECT_EQ(int{resultOf(id).status.status}, GoalStatus::SUCCEEDED);
  }

  std::string last_;
};

TEST_P(Phases, aCancelEndsTheGoalOnceAndTheNextOneIsServed) {
  const std::string id = sendAndAwaitMoment();
  cancel(id);
  cancel(id);
  expectCanceled(resultOf(id), GoalStatus::PREEMPTED);
  EXPECT_FALSE(resultOf(id).result.session_id.empty());
  expectServed();
  EXPECT_EQ(resultsOf(id), 1U);
}

TEST_P(Phases, aNewerGoalDisplacesTheGoalAndIsServed) {
  const std::string id = sendAndAwaitMoment();
  expectServed();
  const AlignActionResult displaced = resultOf(id);
  expectCanceled(displaced, GoalStatus::PREEMPTED);
  EXPECT_EQ(displaced.result.message, "displaced by a newer goal");
  EXPECT_EQ(resultsOf(id), 1U);
}

// The session counts six pieces of work: to read, to ground, to try for all that is expected (and
// then to plan), to estimate beliefs, to find all conflicts, to decide.
INSTANTIATE_TEST_SUITE_P(
    While, Phases,
    testing::Values(Moment{"Reading", [] { return longToRead(800'000); }, AlignmentState::ANALYSING,
                           0.0F},
                    Moment{"Grounding", longToGround, AlignmentState::ANALYSING, 0.9F / 6},
                    Moment{"Analysing", longToAnalyse, AlignmentState::ANALYSING, 1.9F / 6},
                    Moment{"Planning", longToPlan, AlignmentState::ANALYSING, 1.9F / 6},
                    Moment{"Asking", sweepHall, AlignmentState::AWAITING_ANSWER, 0.0F}),
    [](const auto& moment) { return std::string(moment.param.name); });

class Storm : public GoalsByHand {};

TEST_F(Storm, ofGoalsBringsEachExactlyOneFilledResult) {
  constexpr int kGoals = 100;
  const auto sendAll = [](ros::Publisher publisher, const std::string& name) {
    for (int i = 0; i < kGoals; ++i) {
      AlignActionGoal message;
      message.goal_id.id = name + std::to_string(i);
      message.goal_id.stamp = ros::Time::now();
      message.goal = i % 3 == 0 ? sweepSilently() : i % 3 == 1 ? sweepHall() : sweepBothRooms();
      publisher.publish(message);
    }
  };
  std::thread other(sendAll, goals_, "other-");
  sendAll(goals_, "one-");
  other.join();
  // Whichever goal comes last is displaced by this one.
  const std::string last = send(sweepSilently());
  EXPECT_EQ(int{resultOf(last).status.status}, GoalStatus::SUCCEEDED);
  EXPECT_TRUE(eventually([this] { return results_.all().size() >= 2U * kGoals + 1; }));
  std::map<std::string, int> ends;
  for (const AlignActionResult& result : results_.all()) {
    ++ends[result.status.goal_id.id];
    EXPECT_FALSE(result.result.message.empty());
    if (result.result.outcome == AlignResult::SUCCESS) {
      EXPECT_EQ(int{result.status.status}, GoalStatus::SUCCEEDED);
    } else {
      const bool canceled = result.status.status == GoalStatus::PREEMPTED ||
                            result.status.status == GoalStatus::RECALLED;
      EXPECT_TRUE(canceled) << int{result.status.status};
      expectCanceled(result, result.status.status);
    }
  }
  EXPECT_EQ(ends.size(), 2U * kGoals + 1);
  for (const auto& [id, count] : ends)
    EXPECT_EQ(count, 1) << id;
}

}  // namespace
}  // namespace goal_alignment::test
