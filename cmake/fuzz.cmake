# SPDX-License-Identifier: BSD-3-Clause
# libFuzzer's programs, one a target of test/fuzz/targets.h; `fuzzers` builds them all.
if(NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  message(FATAL_ERROR "GOAL_ALIGNMENT_FUZZERS needs clang: -DCMAKE_CXX_COMPILER=clang++")
endif()

set(fuzz_flags -O1 -g1 -fno-omit-frame-pointer -fno-sanitize-recover=all -D_GLIBCXX_ASSERTIONS)

# The core, compiled once more with coverage.
add_library(goal_alignment_fuzzed STATIC EXCLUDE_FROM_ALL ${core_sources})
target_include_directories(goal_alignment_fuzzed PUBLIC ${PROJECT_SOURCE_DIR}/include)
target_compile_options(goal_alignment_fuzzed PUBLIC
  ${fuzz_flags} -fsanitize=fuzzer-no-link,address,undefined)
target_include_directories(goal_alignment_fuzzed SYSTEM PRIVATE ${CADICAL_INCLUDE_DIR})
target_link_libraries(goal_alignment_fuzzed PUBLIC
  Boost::boost Threads::Threads fmt::fmt yaml-cpp ${CADICAL_LIBRARY})

add_custom_target(fuzzers)
foreach(target pddl plan yaml)
  set(fuzzer goal_alignment_${target}_fuzzer)
  add_executable(${fuzzer} EXCLUDE_FROM_ALL
    test/fuzz/${target}_fuzzer.cpp test/fuzz/libfuzzer.cpp)
  target_include_directories(${fuzzer} PRIVATE ${PROJECT_SOURCE_DIR}/test)
  target_compile_definitions(${fuzzer} PRIVATE FUZZ_TARGET=${target})
  target_link_libraries(${fuzzer} PRIVATE goal_alignment_fuzzed -fsanitize=fuzzer,address,undefined)
  add_dependencies(fuzzers ${fuzzer})
endforeach()
