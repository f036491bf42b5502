// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/execution/dispatch_listeners.h"

#include <ros/single_subscriber_publisher.h>

#include "goal_alignment/ActionDispatch.h"
#include "goal_alignment/execution/names.h"

namespace goal_alignment::execution {
namespace {

constexpr std::uint32_t kQueueSize = 100;
constexpr std::chrono::seconds kRelinking{1};

}  // namespace

ros::Publisher DispatchListeners::advertise(ros::NodeHandle node) {
  const auto count = [this](int more) {
    return [this, more](const ros::SingleSubscriberPublisher& listener) {
      const std::lock_guard<std::mutex> lock(mutex_);
      Links& links = links_[listener.getSubscriberName()];
      links.count += more;
      if (more < 0) links.last_cut = any_message::Clock::now();
    };
  };
  return node.advertise<ActionDispatch>(kActionDispatchTopic, kQueueSize, count(1), count(-1));
}

bool DispatchListeners::hasLeft(const std::string& node) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = links_.find(node);
  return found != links_.end() && found->second.count <= 0 &&
         any_message::Clock::now() > found->second.last_cut + kRelinking;
}

}  // namespace goal_alignment::execution
