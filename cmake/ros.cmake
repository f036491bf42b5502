# SPDX-License-Identifier: BSD-3-Clause
# Floors 8 to 10: messages, libraries and programs of the ROS graph. catkin is looked for here alone.

# catkin notes now in which environment run_tests will run, and leaves out folders that are not there yet;
# without this one no Python tool of a first build's tests would know our messages.
if(NOT CATKIN_DEVEL_PREFIX)
  set(CATKIN_DEVEL_PREFIX ${CMAKE_CURRENT_BINARY_DIR}/devel)
endif()
file(MAKE_DIRECTORY ${CATKIN_DEVEL_PREFIX}/lib/python3/dist-packages)

find_package(catkin REQUIRED COMPONENTS
  actionlib actionlib_msgs diagnostic_msgs diagnostic_updater geometry_msgs message_generation roscpp
  roslib std_msgs std_srvs tf2 tf2_ros topic_tools visualization_msgs)

add_message_files(DIRECTORY msg FILES
  ActionDispatch.msg ActionFeedback.msg AlignmentState.msg AlternativeGoal.msg Candidate.msg
  Conflict.msg Fluent.msg HumanTask.msg Plan.msg PlanStep.msg Question.msg WaitingTask.msg)
add_service_files(DIRECTORY srv FILES
  Answer.srv AskHuman.srv Explain.srv GetFacts.srv GetState.srv SetFacts.srv Validate.srv)
add_action_files(DIRECTORY action FILES Align.action ExecutePlan.action)
generate_messages(DEPENDENCIES actionlib_msgs diagnostic_msgs std_msgs)

catkin_package(
  INCLUDE_DIRS include
  LIBRARIES goal_alignment_core
  CATKIN_DEPENDS actionlib actionlib_msgs diagnostic_msgs diagnostic_updater geometry_msgs
    message_runtime roscpp roslib std_msgs std_srvs tf2 tf2_ros topic_tools visualization_msgs
  DEPENDS Boost)

# The core and hagl were declared before catkin said where libraries and programs go.
set_target_properties(goal_alignment_core PROPERTIES
  ARCHIVE_OUTPUT_DIRECTORY ${CATKIN_DEVEL_PREFIX}/${CATKIN_PACKAGE_LIB_DESTINATION}
  LIBRARY_OUTPUT_DIRECTORY ${CATKIN_DEVEL_PREFIX}/${CATKIN_PACKAGE_LIB_DESTINATION})
set_target_properties(hagl PROPERTIES
  RUNTIME_OUTPUT_DIRECTORY ${CATKIN_DEVEL_PREFIX}/${CATKIN_PACKAGE_BIN_DESTINATION})

function(goal_alignment_ros_target target)
  target_include_directories(${target} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:include>)
  target_include_directories(${target} SYSTEM PUBLIC ${catkin_INCLUDE_DIRS})
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wshadow)
  add_dependencies(${target} ${${PROJECT_NAME}_EXPORTED_TARGETS} ${catkin_EXPORTED_TARGETS})
endfunction()

# Floors 8 and 9: a library for each room.
function(goal_alignment_room room)
  file(GLOB room_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${room}/*.cpp)
  add_library(goal_alignment_${room} STATIC ${room_sources})
  goal_alignment_ros_target(goal_alignment_${room})
  target_link_libraries(goal_alignment_${room} PUBLIC goal_alignment_core ${catkin_LIBRARIES}
    PRIVATE fmt::fmt)
endfunction()
foreach(room IN ITEMS ros_common any_message aligner dialogues execution)
  goal_alignment_room(${room})
endforeach()
target_link_libraries(goal_alignment_any_message PUBLIC yaml-cpp)
target_link_libraries(goal_alignment_aligner PUBLIC goal_alignment_ros_common
  PRIVATE nlohmann_json::nlohmann_json yaml-cpp)
target_link_libraries(goal_alignment_dialogues PUBLIC goal_alignment_ros_common PRIVATE yaml-cpp)
target_link_libraries(goal_alignment_execution PUBLIC
  goal_alignment_any_message goal_alignment_ros_common yaml-cpp)

# Floor 10: one small main a program; what narrates the demo is a library for its unit tests.
add_library(goal_alignment_demo STATIC src/nodes/demo_narrator.cpp src/nodes/task_file.cpp)
goal_alignment_ros_target(goal_alignment_demo)
target_link_libraries(goal_alignment_demo PUBLIC goal_alignment_ros_common PRIVATE fmt::fmt yaml-cpp)

set(goal_alignment_nodes
  goal_alignment_node console_dialogue scripted_dialogue speech_dialogue plan_executor simulated_executor
  demo_task)
foreach(node IN LISTS goal_alignment_nodes)
  add_executable(${node} src/nodes/${node}.cpp)
  goal_alignment_ros_target(${node})
  target_link_libraries(${node} PRIVATE goal_alignment_aligner goal_alignment_dialogues
    goal_alignment_execution fmt::fmt)
endforeach()
target_link_libraries(demo_task PRIVATE goal_alignment_demo)

install(TARGETS goal_alignment_core
  ARCHIVE DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION}
  LIBRARY DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION})
install(TARGETS hagl ${goal_alignment_nodes} RUNTIME DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
# The headers of what is exported, the core; yaml_reader.h is for sources that link yaml-cpp.
foreach(floor IN LISTS GOAL_ALIGNMENT_CORE_FLOORS)
  install(DIRECTORY include/${PROJECT_NAME}/${floor}
    DESTINATION ${CATKIN_PACKAGE_INCLUDE_DESTINATION} PATTERN yaml_reader.h EXCLUDE)
endforeach()
catkin_install_python(PROGRAMS examples/align_and_execute.py examples/fake_robot.py
  DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
install(DIRECTORY launch config DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})

if(CATKIN_ENABLE_TESTING AND GOAL_ALIGNMENT_TESTS)
  include(cmake/ros_tests.cmake)
endif()
