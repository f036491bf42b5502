# SPDX-License-Identifier: BSD-3-Clause
# Measurements of the core; nothing depends on their results.
find_package(benchmark REQUIRED)

file(GLOB benchmark_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/benchmark/*.cpp)
add_executable(goal_alignment_benchmarks EXCLUDE_FROM_ALL ${benchmark_sources})
target_compile_options(goal_alignment_benchmarks PRIVATE -Wall -Wextra -Wshadow)
target_link_libraries(goal_alignment_benchmarks PRIVATE goal_alignment_core benchmark::benchmark)
