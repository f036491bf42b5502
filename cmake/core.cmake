# SPDX-License-Identifier: BSD-3-Clause
# What the core and hagl use besides the standard library.
find_package(fmt REQUIRED)
find_package(yaml-cpp REQUIRED)
find_package(Boost REQUIRED)
find_package(Threads REQUIRED)
# It brings no package configuration; Debian's library is static, with position-independent code.
find_path(CADICAL_INCLUDE_DIR cadical.hpp)
find_library(CADICAL_LIBRARY cadical)
if(NOT CADICAL_INCLUDE_DIR OR NOT CADICAL_LIBRARY)
  message(FATAL_ERROR "CaDiCaL is missing: install libcadical-dev, or build it with "
    "./configure -fPIC && make and give CADICAL_INCLUDE_DIR and CADICAL_LIBRARY")
endif()
find_package(nlohmann_json REQUIRED)

# The folders of floors 0 to 7, of which the core is made.
set(GOAL_ALIGNMENT_CORE_FLOORS
  common pddl task validation grounding heuristics spatial_facts search achievability alignment questions
  session phrasing)
