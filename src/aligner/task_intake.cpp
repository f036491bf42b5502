// SPDX-License-Identifier: BSD-3-Clause
#include "task_intake.h"

#include <fmt/format.h>
#include <ros/console.h>
#include <ros/param.h>
#include <ros/this_node.h>

#include <algorithm>
#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/nil_generator.hpp>
#include <boost/uuid/uuid_io.hpp>
#include <cstdint>
#include <utility>
#include <vector>

#include "goal_alignment/ros_common/names.h"
#include "goal_alignment/ros_common/outside_text.h"

namespace goal_alignment::aligner {
namespace {

constexpr std::uint32_t kTaskQueueSize = 10;
constexpr std::size_t kMaxConnections = 1000;  // a flood of publishers must not fill the memory

// One file for each robot that shares the folder.
std::string fileIn(const std::string& folder) {
  std::string name = ros::this_node::getName();
  std::replace(name.begin(), name.end(), '/', '.');
  return folder + "/latched_tasks" + name;
}

bool isLatched(const ros::M_string& connection) {
  const auto latching = connection.find("latching");
  return latching != connection.end() && latching->second == "1";
}

// Who published it in this run of the ROS master, and what; rospy counts anew what it shows again.
std::string keyOf(const ros::MessageEvent<HumanTask const>& event) {
  HumanTask task = *event.getConstMessage();
  task.header.seq = 0;
  std::vector<std::uint8_t> bytes(ros::serialization::serializationLength(task));
  ros::serialization::OStream out(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(out, task);
  std::string run_id;
  ros::param::get("/run_id", run_id);
  std::string all = run_id + '\n' + event.getPublisherName() + '\n';
  all.append(bytes.begin(), bytes.end());
  return boost::uuids::to_string(boost::uuids::name_generator_sha1(boost::uuids::nil_uuid())(all));
}

}  // namespace

TaskIntake::TaskIntake(ros::NodeHandle node, const std::string& folder, AlignServer& align,
                       Announcer& announcer, ToGoal to_goal)
    : align_(align),
      announcer_(announcer),
      to_goal_(std::move(to_goal)),
      taken_(fileIn(folder), [](const std::string& line) { ROS_WARN("%s", line.c_str()); }),
      tasks_(node.subscribe<HumanTask, const Event&>(
          ros_common::kHumanTaskTopic, kTaskQueueSize,
          boost::function<void(const Event&)>([this](const Event& event) { take(event); }))) {}

void TaskIntake::take(const Event& event) {
  HumanTask task = *event.getConstMessage();
  task.person = ros_common::outsideName(task.person);
  task.task_id = ros_common::outsideName(task.task_id);
  const AlignGoal goal = to_goal_(task);
  const bool shown_again = isShownAgain(event);
  const auto verdict =
      repeats_.judge(event.getPublisherName(), identityOf(goal),
                     shown_again || align_.isUnderWay(goal), TaskRepeats::Clock::now());
  if (verdict == TaskRepeats::Verdict::Wanted)
    return align_.submit(goal, ros_common::kHumanTaskTopic);
  if (verdict == TaskRepeats::Verdict::Repeated) return;
  leaveOut(task, shown_again
                     ? fmt::format("is only latched, by {}, and was taken up before; publish it "
                                   "anew to have it done again",
                                   event.getPublisherName())
                     : fmt::format("comes again from {}; it is one task (rostopic pub needs -1)",
                                   event.getPublisherName()));
}

// A latched message that its publisher sends to whoever connects.
bool TaskIntake::isShownAgain(const Event& event) {
  const bool first = beginsConnection(event);
  if (!isLatched(event.getConnectionHeader())) return false;
  const std::string key = keyOf(event);
  const bool shown_again = first && taken_.knows(key);
  taken_.add(key);
  return shown_again;
}

bool TaskIntake::beginsConnection(const Event& event) {
  const auto& connection = event.getConnectionHeaderPtr();
  if (connections_.size() >= kMaxConnections) connections_.clear();
  auto& known = connections_[event.getPublisherName()];
  return std::exchange(known, connection) != connection;
}

void TaskIntake::leaveOut(const HumanTask& task, const std::string& why) {
  announcer_.warn(
      fmt::format("the task {}{}", task.task_id.empty() ? "" : task.task_id + " ", why));
}

}  // namespace goal_alignment::aligner
