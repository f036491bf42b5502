// SPDX-License-Identifier: BSD-3-Clause
#include <rosgraph_msgs/Clock.h>

#include "scenario.h"

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "scenario");
  ros::AsyncSpinner spinner(4);
  spinner.start();
  // Where the clock is simulated it stands still, once it has begun: actionlib's clients wait for
  // that.
  ros::Publisher clock;
  if (ros::param::param("/use_sim_time", false)) {
    clock = ros::NodeHandle().advertise<rosgraph_msgs::Clock>("/clock", 1, true);
    rosgraph_msgs::Clock message;
    message.clock = ros::Time(1000);
    clock.publish(message);
  }
  return RUN_ALL_TESTS();
}
