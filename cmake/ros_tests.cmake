# SPDX-License-Identifier: BSD-3-Clause
# Unit tests that need messages, scenarios in a ROS graph, launch files.
find_package(rostest REQUIRED)
find_package(roslaunch REQUIRED)

set(ros_unit_tests)
foreach(room IN ITEMS ros_common any_message aligner dialogues execution nodes)
  file(GLOB room_tests CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/test/unit/${room}/*_test.cpp)
  list(APPEND ros_unit_tests ${room_tests})
endforeach()
catkin_add_gtest(goal_alignment_ros_unit_tests ${ros_unit_tests})
goal_alignment_ros_target(goal_alignment_ros_unit_tests)
# -O1, here and below: to compile the tests takes longer than to run them.
target_compile_options(goal_alignment_ros_unit_tests PRIVATE -O1)
target_include_directories(goal_alignment_ros_unit_tests PRIVATE
  ${PROJECT_SOURCE_DIR}/test ${PROJECT_SOURCE_DIR}/src)
target_compile_definitions(goal_alignment_ros_unit_tests PRIVATE
  GOAL_ALIGNMENT_SOURCE_ROOT="${PROJECT_SOURCE_DIR}")
target_link_libraries(goal_alignment_ros_unit_tests goal_alignment_aligner goal_alignment_dialogues
  goal_alignment_execution goal_alignment_demo GTest::gtest_main)

# One program for all scenarios; each .test file starts its own graph and picks its own.
file(GLOB scenario_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/test/ros/*.cpp)
add_executable(goal_alignment_scenarios EXCLUDE_FROM_ALL ${scenario_sources})
goal_alignment_ros_target(goal_alignment_scenarios)
target_compile_options(goal_alignment_scenarios PRIVATE -O1)
target_compile_definitions(goal_alignment_scenarios PRIVATE
  NODE_FOLDER="${CATKIN_DEVEL_PREFIX}/${CATKIN_PACKAGE_BIN_DESTINATION}")
target_link_libraries(goal_alignment_scenarios goal_alignment_generators ${catkin_LIBRARIES} GTest::gtest util)
# Read once, not for every scenario: most of the build's time would go into ROS's headers.
target_precompile_headers(goal_alignment_scenarios PRIVATE ${PROJECT_SOURCE_DIR}/test/ros/scenario.h)
add_dependencies(tests goal_alignment_scenarios)

file(GLOB scenarios CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/test/ros/*.test)
foreach(scenario IN LISTS scenarios)
  add_rostest(${scenario} DEPENDENCIES goal_alignment_scenarios ${goal_alignment_nodes})
endforeach()

roslaunch_add_file_check(launch USE_TEST_DEPENDENCIES DEPENDENCIES ${goal_alignment_nodes})
