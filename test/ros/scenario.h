// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>
#include <ros/ros.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "action_client.h"
#include "goal_alignment/AlignAction.h"
#include "goal_alignment/AlignmentState.h"
#include "goal_alignment/Answer.h"
#include "goal_alignment/HumanTask.h"
#include "goal_alignment/Plan.h"
#include "goal_alignment/Question.h"

/// What the scenarios share: a person's view of a running aligner named /goal_alignment.
namespace goal_alignment::test {

constexpr double kPatience = 20;  // seconds; far more than anything here takes

/// Remembers all messages of a topic.
template <typename Message>
class Topic {
 public:
  Topic(ros::NodeHandle node, const std::string& name)
      : subscriber_(node.subscribe(name, 1000, &Topic::hear, this)) {}

  /// The first message that fits, from the beginning on, or nothing within the time.
  std::optional<Message> waitFor(const std::function<bool(const Message&)>& fits,
                                 double seconds = kPatience) {
    std::unique_lock<std::mutex> lock(mutex_);
    std::size_t seen = 0;
    std::optional<Message> found;
    changed_.wait_for(lock, std::chrono::duration<double>(seconds), [&] {
      for (; seen < messages_.size() && !found; ++seen) {
        if (fits(messages_[seen])) found = messages_[seen];
      }
      return found.has_value();
    });
    return found;
  }

  std::vector<Message> all() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return messages_;
  }

  bool isHeard() const { return subscriber_.getNumPublishers() > 0; }

  std::optional<Message> last() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return messages_.empty() ? std::nullopt : std::make_optional(messages_.back());
  }

 private:
  void hear(const boost::shared_ptr<Message const>& message) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      messages_.push_back(*message);
    }
    changed_.notify_all();
  }

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Message> messages_;
  ros::Subscriber subscriber_;
};

/// Polls in wall time.
inline bool eventually(const std::function<bool()>& holds, double seconds = kPatience) {
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(seconds);
  while (!holds()) {
    if (ros::WallTime::now() > end) return false;
    ros::WallDuration(0.005).sleep();
  }
  return true;
}

/// One call, over a connection that the server leaves open: of other calls roscpp's client loses
/// some in ten thousand, on a busy machine some in a thousand, since the server closes theirs just
/// as it reads (ros_comm, issue 1976).
template <typename Service>
bool callService(const std::string& name, Service& service) {
  return ros::NodeHandle().serviceClient<Service>(name, true).call(service);
}

/// Not ros::service::waitForService(), which sleeps on a clock that may stand still.
inline bool isOffered(const std::string& service) {
  return eventually([&] { return ros::service::exists(service, false); });
}

using AlignClient = ActionClient<AlignAction>;

inline bool waitForEnd(AlignClient& client, double seconds = kPatience) {
  return eventually([&] { return client.getState().isDone(); }, seconds);
}

/// Not before the client has heard of its goal: a status from before the goal's arrival that it
/// reads after the cancel makes actionlib's client take the goal for lost.
template <typename Client>
void cancelKnownGoal(Client& client) {
  EXPECT_TRUE(eventually([&] {
    return client.getState().isDone() ||
           client.getState() == actionlib::SimpleClientGoalState::ACTIVE;
  }));
  client.cancelGoal();
}

PlanStep step(const std::string& name, const std::vector<std::string>& args);
Fluent fluent(const std::string& name, const std::vector<std::string>& args);

/// A file of test/ros/models.
std::string model(const std::string& file);

/// Sweep the hall, which the person believes to be silent; the robot asks whether (quiet hall)
/// matters.
AlignGoal sweepHall();
/// The same with two rooms and two questions.
AlignGoal sweepBothRooms();
/// Robot and person agree: nothing to ask.
AlignGoal sweepSilently();

/// Two pairs of lamps, of which the robot can't light both of a pair: (lit a1), (lit a2) and (lit
/// b1), (lit b2).
AlignGoal lightLamps();

/// A graph with an aligner; every scenario begins with it idle.
class Scenario : public testing::Test {
 protected:
  Scenario();
  void SetUp() override;
  void TearDown() override;

  /// Sends the goal and waits for the question it leads to; fails the test where none comes.
  Question sendAndAwaitQuestion(const AlignGoal& goal);
  Question awaitQuestionAfter(std::uint32_t id);
  AlignResult awaitResult();
  Answer::Response answer(int value, std::uint32_t id = 0,
                          const std::vector<std::string>& fluents = {});
  bool questionIsClosed();

  ros::NodeHandle node_;
  Topic<Question> questions_;
  Topic<AlignmentState> states_;
  Topic<Plan> plans_;
  AlignClient align_;
};

}  // namespace goal_alignment::test
