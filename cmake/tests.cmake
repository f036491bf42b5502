# SPDX-License-Identifier: BSD-3-Clause
# Unit tests of the core and of the command line; those that need messages stand in ros_tests.cmake.
find_package(GTest REQUIRED)
enable_testing()

file(GLOB unit_tests CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/test/unit/*/*_test.cpp
  ${PROJECT_SOURCE_DIR}/test/oracles/*.cpp
  ${PROJECT_SOURCE_DIR}/test/fuzz/*_fuzzer.cpp ${PROJECT_SOURCE_DIR}/test/fuzz/*_test.cpp)
list(FILTER unit_tests EXCLUDE REGEX "/test/unit/(ros_common|any_message|aligner|dialogues|execution|nodes|rviz_panel)/")
add_executable(goal_alignment_unit_tests EXCLUDE_FROM_ALL ${unit_tests})
# src, for the few classes that have no public header.
target_include_directories(goal_alignment_unit_tests PRIVATE
  ${PROJECT_SOURCE_DIR}/test ${PROJECT_SOURCE_DIR}/src)
# -O1: to compile the tests takes longer than to run them.
target_compile_options(goal_alignment_unit_tests PRIVATE -Wall -Wextra -Wshadow -O1)
target_link_libraries(goal_alignment_unit_tests PRIVATE goal_alignment_measuring fmt::fmt yaml-cpp
  nlohmann_json::nlohmann_json rapidcheck GTest::gtest GTest::gtest_main)

target_precompile_headers(goal_alignment_unit_tests PRIVATE <gtest/gtest.h> <rapidcheck/gtest.h>)

# The command line is tested as what it is, a program.
add_dependencies(goal_alignment_unit_tests hagl)
target_compile_definitions(goal_alignment_unit_tests PRIVATE
  HAGL_PROGRAM="$<TARGET_FILE:hagl>" GOAL_ALIGNMENT_SOURCE_ROOT="${PROJECT_SOURCE_DIR}")
