// SPDX-License-Identifier: BSD-3-Clause
#include "service_group.h"

namespace goal_alignment::aligner {

ServiceGroup::ServiceGroup(const ros::NodeHandle& node) : node_(node) {}

ServiceGroup::ServiceGroup(const ros::NodeHandle& node, std::uint32_t threads) : node_(node) {
  node_.setCallbackQueue(&queue_);
  spinner_.emplace(threads, &queue_);
}

void ServiceGroup::start() {
  if (spinner_) spinner_->start();
}

}  // namespace goal_alignment::aligner
