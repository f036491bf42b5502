// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/advertise_service_options.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/service_server.h>
#include <ros/spinner.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace goal_alignment::aligner {

/// Services that share a callback queue: that of the node, or one with threads of its own, so that
/// nothing else waits behind what takes long.
class ServiceGroup {
 public:
  /// On the callback queue of the node.
  explicit ServiceGroup(const ros::NodeHandle& node);
  /// On a queue of its own, which so many threads serve after start().
  ServiceGroup(const ros::NodeHandle& node, std::uint32_t threads);

  /// The handler gets the request and fills the response; the call always succeeds.
  template <typename Service, typename Handler>
  void add(const std::string& name, Handler handler) {
    using Request = typename Service::Request;
    using Response = typename Service::Response;
    ros::AdvertiseServiceOptions options;
    options.init<Request, Response>(name, [handler](Request& request, Response& response) {
      handler(request, response);
      return true;
    });
    servers_.push_back(node_.advertiseService(options));
  }

  void start();

 private:
  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  std::vector<ros::ServiceServer> servers_;
  std::optional<ros::AsyncSpinner> spinner_;  // none: the node's queue is used
};

}  // namespace goal_alignment::aligner
