# SPDX-License-Identifier: BSD-3-Clause
# The program `hagl`: the core on the command line, without ROS. What it is made of is a library, for
# the measurements read instances and draw as hagl does, and the unit tests look inside.
find_package(nlohmann_json REQUIRED)

file(GLOB cli_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/cli/*.cpp)
list(FILTER cli_sources EXCLUDE REGEX "/main\\.cpp$")
add_library(goal_alignment_cli STATIC EXCLUDE_FROM_ALL ${cli_sources})
add_executable(hagl ${PROJECT_SOURCE_DIR}/src/cli/main.cpp)
foreach(target goal_alignment_cli hagl)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow)
endforeach()
target_link_libraries(goal_alignment_cli PUBLIC goal_alignment_core nlohmann_json::nlohmann_json
  PRIVATE fmt::fmt)
target_link_libraries(hagl PRIVATE goal_alignment_cli)
