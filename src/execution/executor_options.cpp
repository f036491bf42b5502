// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/execution/executor_options.h"

#include <ros/names.h>
#include <ros/param.h>

#include <limits>

#include "goal_alignment/ros_common/parameter_reader.h"

namespace goal_alignment::execution {
namespace {

constexpr double kLongest = 3600;         // seconds
constexpr double kShortestPeriod = 0.01;  // seconds
constexpr int kMaxReplans = 1000;
constexpr double kLowestRate = 1;     // Hz
constexpr double kHighestRate = 200;  // Hz

bool isNodeName(const std::string& name) {
  std::string why_not;
  return !name.empty() && name.front() != '~' && ros::names::validate(name, why_not);
}

}  // namespace

ExecutorOptions ExecutorOptions::read(const ros::NodeHandle& private_node) {
  XmlRpc::XmlRpcValue values;
  ros::param::get(private_node.getNamespace(), values);
  return read(values, private_node.getNamespace());
}

ExecutorOptions ExecutorOptions::read(const XmlRpc::XmlRpcValue& values, const std::string& ns) {
  ros_common::ParameterReader reader(values, ns);
  ExecutorOptions options;
  reader.read("mapping", options.mapping);
  reader.read("aligner", options.aligner);
  if (!isNodeName(options.aligner)) reader.refuse("aligner", "the name of the aligner's node");
  reader.read("auto_execute", options.auto_execute);
  reader.read("watch", options.watch);
  reader.read("robot_domain", options.robot_domain);
  reader.read("robot_problem", options.robot_problem);
  reader.renamed("facts_patience", "facts_timeout");
  reader.read("facts_timeout", options.facts_timeout, 0, kLongest);
  reader.read("max_replans", options.max_replans, 0, kMaxReplans);
  reader.renamed("cancel_patience", "cancel_timeout");
  reader.read("cancel_timeout", options.cancel_timeout, 0, kLongest);
  const std::size_t wall = static_cast<std::size_t>(any_message::ClockKind::Wall);
  options.clock =
      static_cast<any_message::ClockKind>(reader.readChoice("clock", {"wall", "ros"}, wall));
  // The library that keeps the period reads it itself.
  reader.read("diagnostic_period", options.diagnostic_period, kShortestPeriod, kLongest);
  reader.renamed("servers_patience", "servers_timeout");
  reader.read("servers_timeout", options.servers_timeout, 0, kLongest);
  reader.read("step_duration", options.step_duration, 0, kLongest);
  reader.read("failure_probability", options.failure_probability, 0, 1);
  reader.read("failing_step", options.failing_step, -1, std::numeric_limits<int>::max());
  reader.read("seed", options.seed, 0, std::numeric_limits<int>::max());
  reader.read("frame_rate", options.frame_rate, kLowestRate, kHighestRate);
  options.warnings = reader.warnings();
  return options;
}

ExecutorOptions ExecutorOptions::atTheStart(const ros::NodeHandle& private_node) {
  try {
    return read(private_node);
  } catch (const ros_common::ParameterError&) {
    ExecutorOptions options;
    std::string aligner;
    if (private_node.getParam("aligner", aligner) && isNodeName(aligner)) options.aligner = aligner;
    private_node.getParam("auto_execute", options.auto_execute);
    return options;
  }
}

}  // namespace goal_alignment::execution
