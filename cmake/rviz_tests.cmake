# SPDX-License-Identifier: BSD-3-Clause
# The panel: its parts without ROS and without a display, and all of it inside of rviz on a display of its
# own (Xvfb), driven by real clicks.
find_package(Qt5 REQUIRED COMPONENTS Test)

file(GLOB panel_unit_tests CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/test/unit/rviz_panel/*_test.cpp)
catkin_add_gtest(goal_alignment_panel_unit_tests ${panel_unit_tests})
goal_alignment_ros_target(goal_alignment_panel_unit_tests)
target_include_directories(goal_alignment_panel_unit_tests PRIVATE ${PROJECT_SOURCE_DIR}/src)
target_link_libraries(goal_alignment_panel_unit_tests goal_alignment_panel_parts Qt5::Test GTest::gtest)

file(GLOB panel_scenarios CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/test/rviz/*.cpp)
add_executable(goal_alignment_panel_scenarios EXCLUDE_FROM_ALL ${panel_scenarios}
  ${PROJECT_SOURCE_DIR}/test/ros/graph.cpp ${PROJECT_SOURCE_DIR}/test/ros/program.cpp ${PROJECT_SOURCE_DIR}/test/ros/scenario.cpp)
goal_alignment_ros_target(goal_alignment_panel_scenarios)
target_include_directories(goal_alignment_panel_scenarios PRIVATE ${PROJECT_SOURCE_DIR}/test/ros)
target_include_directories(goal_alignment_panel_scenarios SYSTEM PRIVATE ${rviz_INCLUDE_DIRS})
target_compile_definitions(goal_alignment_panel_scenarios PRIVATE
  NODE_FOLDER="${CATKIN_DEVEL_PREFIX}/${CATKIN_PACKAGE_BIN_DESTINATION}")
target_link_libraries(goal_alignment_panel_scenarios ${rviz_LIBRARIES} ${catkin_LIBRARIES}
  Qt5::Widgets GTest::gtest)
add_dependencies(tests goal_alignment_panel_scenarios)

file(GLOB panel_rostests CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/test/rviz/*.test)
foreach(scenario IN LISTS panel_rostests)
  add_rostest(${scenario}
    DEPENDENCIES goal_alignment_panel_scenarios goal_alignment_rviz ${goal_alignment_nodes})
endforeach()
