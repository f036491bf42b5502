# SPDX-License-Identifier: BSD-3-Clause
# Measurements of the core; nothing depends on their results.
find_package(benchmark REQUIRED)

file(GLOB benchmark_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/benchmark/*.cpp)
add_executable(goal_alignment_benchmarks EXCLUDE_FROM_ALL ${benchmark_sources})
target_link_libraries(goal_alignment_benchmarks PRIVATE
  goal_alignment_generators benchmark::benchmark nlohmann_json::nlohmann_json)

add_executable(goal_alignment_measure EXCLUDE_FROM_ALL benchmark/programs/measure.cpp)
target_link_libraries(goal_alignment_measure PRIVATE goal_alignment_measuring)
add_executable(goal_alignment_generate EXCLUDE_FROM_ALL benchmark/programs/generate.cpp)
target_link_libraries(goal_alignment_generate PRIVATE goal_alignment_generators)

target_compile_definitions(goal_alignment_benchmarks PRIVATE
  GOAL_ALIGNMENT_SOURCE_ROOT="${PROJECT_SOURCE_DIR}")

foreach(target benchmarks measure generate)
  target_compile_options(goal_alignment_${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow)
endforeach()
