# SPDX-License-Identifier: BSD-3-Clause
# The panel for rviz: a plugin, and its parts as a library of their own for the tests. Not a component of
# the catkin package as a whole, since no node may come to link a graphics library.
find_package(pluginlib REQUIRED)
find_package(rviz REQUIRED)
find_package(Qt5 REQUIRED COMPONENTS Widgets)

file(GLOB panel_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/rviz_panel/*.cpp)
set(panel_plugin ${PROJECT_SOURCE_DIR}/src/rviz_panel/alignment_panel.cpp)
list(REMOVE_ITEM panel_sources ${panel_plugin})

add_library(goal_alignment_panel_parts STATIC ${panel_sources})
add_library(goal_alignment_rviz SHARED ${panel_plugin})
foreach(target IN ITEMS goal_alignment_panel_parts goal_alignment_rviz)
  goal_alignment_ros_target(${target})
  set_target_properties(${target} PROPERTIES AUTOMOC ON)
endforeach()
target_link_libraries(goal_alignment_panel_parts PUBLIC Qt5::Widgets ${catkin_LIBRARIES})
target_include_directories(goal_alignment_rviz SYSTEM PRIVATE ${rviz_INCLUDE_DIRS})
target_link_libraries(goal_alignment_rviz PRIVATE goal_alignment_panel_parts ${rviz_LIBRARIES})

install(TARGETS goal_alignment_rviz LIBRARY DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION})
install(FILES plugin_description.xml DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})

if(CATKIN_ENABLE_TESTING AND GOAL_ALIGNMENT_TESTS)
  include(cmake/rviz_tests.cmake)
endif()
