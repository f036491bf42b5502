// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/wall_timer.h>
#include <tf2_ros/buffer.h>

#include <map>
#include <string>

#include "announcer.h"
#include "markers.h"

namespace goal_alignment::aligner {

/// ~markers: looks now and then at what was announced and at tf, and shows it where it has changed.
class MarkerPublisher {
 public:
  /// Both are looked at as long as this lives. `frames` need not know anything yet.
  MarkerPublisher(ros::NodeHandle private_node, const Announcer& announcer,
                  const tf2_ros::Buffer& frames);

 private:
  void look();
  void readOptions(const std::string& session_id);
  Whereabouts whereabouts() const;

  ros::NodeHandle private_node_;
  const Announcer& announcer_;
  const tf2_ros::Buffer& frames_;
  ros::Publisher markers_;

  // Of the timer alone.
  std::string session_;
  bool wanted_ = true;
  std::map<std::string, std::string> frame_of_;
  visualization_msgs::MarkerArray shown_;
  ros::WallTimer timer_;
};

}  // namespace goal_alignment::aligner
