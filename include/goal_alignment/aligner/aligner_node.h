// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <memory>

namespace goal_alignment::aligner {

/// goal_alignment_node: ~align, the topics and the services. No callback runs a solver; what takes
/// longer than a look-up has callback queues of its own, so that answers and cancels never wait
/// behind it.
class AlignerNode {
 public:
  AlignerNode(ros::NodeHandle node, ros::NodeHandle private_node);
  ~AlignerNode();
  AlignerNode(const AlignerNode&) = delete;
  AlignerNode& operator=(const AlignerNode&) = delete;

  /// Ends every goal with a result; to be called before the node shuts down.
  void endGoals();

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace goal_alignment::aligner
