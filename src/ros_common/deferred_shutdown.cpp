// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/ros_common/deferred_shutdown.h"

#include <ros/console.h>
#include <ros/init.h>
#include <ros/poll_manager.h>
#include <ros/wall_timer.h>
#include <ros/xmlrpc_manager.h>

#include <atomic>
#include <csignal>

#include "goal_alignment/ros_common/utf8_log.h"

namespace goal_alignment::ros_common {
namespace {

constexpr double kPollPeriod = 0.02;       // seconds
constexpr double kLongestFlush = 5.0;      // seconds
constexpr int kRoundsOfThePollThread = 2;  // the first may have begun before the last message

std::atomic<bool> g_told_to_end{false};  // a signal handler reaches nothing but globals

void onSignal(int /*signal*/) {
  g_told_to_end = true;
}

void onShutdownRequest(XmlRpc::XmlRpcValue& request, XmlRpc::XmlRpcValue& response) {
  if (request.valid() && request.size() > 1) {
    ROS_INFO("shutdown requested: %s", static_cast<std::string&>(request[1]).c_str());
  }
  g_told_to_end = true;
  response = ros::xmlrpc::responseInt(1, "", 0);
}

}  // namespace

void initWithDeferredShutdown(int& argc, char** argv, const char* default_name) {
  logInUtf8();
  ros::init(argc, argv, default_name, ros::init_options::NoSigintHandler);
  // roscpp does not take a name that is bound already.
  ros::XMLRPCManager::instance()->bind("shutdown", onShutdownRequest);
  std::signal(SIGINT, onSignal);
  std::signal(SIGTERM, onSignal);
}

void waitForShutdownRequest() {
  while (ros::ok() && !g_told_to_end)
    ros::WallDuration(kPollPeriod).sleep();
}

void shutDownOnSigterm() {
  std::signal(SIGTERM, [](int /*signal*/) { ros::requestShutdown(); });
}

// roscpp's poll thread takes what was published to the sockets, once a round.
void flushPublished() {
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(kLongestFlush);
  const auto rounds = boost::make_shared<std::atomic<int>>(0);
  const auto listener =
      ros::PollManager::instance()->addPollThreadListener([rounds] { ++*rounds; });
  while (*rounds < kRoundsOfThePollThread && ros::WallTime::now() < end)
    ros::WallDuration(kPollPeriod).sleep();
  ros::PollManager::instance()->removePollThreadListener(listener);
}

}  // namespace goal_alignment::ros_common
