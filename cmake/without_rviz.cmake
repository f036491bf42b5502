# SPDX-License-Identifier: BSD-3-Clause
# What is installed without the panel: a package.xml that exports no plugin and needs no rviz. It is
# installed after the one that catkin_package() installs, and so replaces it.
file(READ ${PROJECT_SOURCE_DIR}/package.xml manifest)
set(panel_line " *<[^>]*_depend condition=\"\\$GOAL_ALIGNMENT_RVIZ != OFF\">[^\n]*\n")
string(REGEX REPLACE "${panel_line}" "" manifest "${manifest}")
string(REGEX REPLACE " *<!-- The panel, [^\n]*\n" "" manifest "${manifest}")
string(REGEX REPLACE " *<rviz plugin=[^\n]*\n" "" manifest "${manifest}")
file(WRITE ${PROJECT_BINARY_DIR}/without_rviz/package.xml "${manifest}")
install(FILES ${PROJECT_BINARY_DIR}/without_rviz/package.xml
  DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
