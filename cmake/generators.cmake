# SPDX-License-Identifier: BSD-3-Clause
# Generated tasks and alignments (measured by the benchmarks, checked by the unit tests, played by the
# scenarios), and what measures them.
file(GLOB generator_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/benchmark/generators/*.cpp)
add_library(goal_alignment_generators STATIC EXCLUDE_FROM_ALL ${generator_sources})
target_include_directories(goal_alignment_generators PUBLIC ${PROJECT_SOURCE_DIR}/benchmark)
target_compile_definitions(goal_alignment_generators PRIVATE
  GOAL_ALIGNMENT_DOMAINS="${PROJECT_SOURCE_DIR}/config/domains")
target_compile_options(goal_alignment_generators PRIVATE -Wall -Wextra -Wpedantic -Wshadow)
target_link_libraries(goal_alignment_generators PUBLIC goal_alignment_cli)

file(GLOB measure_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/benchmark/measure/*.cpp)
add_library(goal_alignment_measuring STATIC EXCLUDE_FROM_ALL ${measure_sources})
target_compile_options(goal_alignment_measuring PRIVATE -Wall -Wextra -Wpedantic -Wshadow)
target_link_libraries(goal_alignment_measuring PUBLIC goal_alignment_generators PRIVATE fmt::fmt)
