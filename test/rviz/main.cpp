// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <ros/init.h>

#include <QApplication>

#include "program.h"

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "panel_scenarios", ros::init_options::NoSigintHandler);
  const goal_alignment::test::TemporaryFolder home;  // rviz remembers things there
  qputenv("HOME", home.path().c_str());
  const QApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
