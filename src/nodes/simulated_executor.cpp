// SPDX-License-Identifier: BSD-3-Clause
// Offers execute_plan without a robot.
#include "goal_alignment/execution/simulated_executor.h"

#include <ros/ros.h>

int main(int argc, char** argv) {
  ros::init(argc, argv, "simulated_executor");
  const goal_alignment::execution::SimulatedExecutor executor{ros::NodeHandle{},
                                                              ros::NodeHandle{"~"}};
  ros::AsyncSpinner spinner(2);  // a cancel is heard while a goal arrives
  spinner.start();
  ros::waitForShutdown();
}
