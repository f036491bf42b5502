// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include "explainer.h"
#include "service_group.h"

namespace goal_alignment::aligner {

/// ~validate and ~explain, each on threads of its own.
class QueryServices {
 public:
  /// The explainer outlives the services.
  QueryServices(const ros::NodeHandle& private_node, Explainer& explainer);

  void start();

 private:
  ServiceGroup validate_;
  ServiceGroup explain_;
};

}  // namespace goal_alignment::aligner
