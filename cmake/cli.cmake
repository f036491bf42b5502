# SPDX-License-Identifier: BSD-3-Clause
# The program `hagl`: the core on the command line, without ROS.
find_package(nlohmann_json REQUIRED)

file(GLOB cli_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/cli/*.cpp)
add_executable(hagl ${cli_sources})
target_compile_options(hagl PRIVATE -Wall -Wextra -Wpedantic -Wshadow)
target_link_libraries(hagl PRIVATE goal_alignment_core fmt::fmt nlohmann_json::nlohmann_json)
