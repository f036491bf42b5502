# SPDX-License-Identifier: BSD-3-Clause
# Floors 0 to 7: one library that knows nothing of ROS.
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

set(core_floors
  common pddl task validation grounding heuristics spatial_facts search achievability alignment questions session
  phrasing)
set(core_sources)
foreach(floor IN LISTS core_floors)
  file(GLOB floor_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${floor}/*.cpp)
  list(APPEND core_sources ${floor_sources})
endforeach()

# The languages of config/phrases are part of the library.
file(GLOB language_files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/config/phrases/*.yaml)
set(SHIPPED_LANGUAGES "")
foreach(language_file IN LISTS language_files)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${language_file})
  get_filename_component(language ${language_file} NAME_WE)
  file(READ ${language_file} language_text)
  string(APPEND SHIPPED_LANGUAGES "      {\"${language}\", R\"yaml(${language_text})yaml\"},\n")
endforeach()
configure_file(${PROJECT_SOURCE_DIR}/src/phrasing/shipped_languages.cpp.in
  ${CMAKE_CURRENT_BINARY_DIR}/shipped_languages.cpp @ONLY)
list(APPEND core_sources ${CMAKE_CURRENT_BINARY_DIR}/shipped_languages.cpp)

# Named, since catkin would otherwise change the default between the first and the second configure;
# shared under catkin, so that other packages need not know what it links.
set(core_library_type STATIC)
if(GOAL_ALIGNMENT_ROS)
  set(core_library_type SHARED)
endif()
add_library(goal_alignment_core ${core_library_type} ${core_sources})
target_include_directories(goal_alignment_core PUBLIC
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:include>)
target_compile_options(goal_alignment_core PRIVATE -Wall -Wextra -Wpedantic -Wshadow)
target_link_libraries(goal_alignment_core PUBLIC Boost::boost Threads::Threads
  PRIVATE fmt::fmt yaml-cpp ${CADICAL_LIBRARY})
target_include_directories(goal_alignment_core SYSTEM PRIVATE ${CADICAL_INCLUDE_DIR})
