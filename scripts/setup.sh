# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=bash
# What demo, test and hagl share: packages and builds. Sourced, never run.
#
#     build/core    the core library and hagl, without ROS
#     build/ros     the catkin package and all tests; its devel space is build/devel
#     build/ros-asan build/ros-tsan build/fuzz    for scripts/test --all
#     build/logs    what the tools said

root=$(cd "${BASH_SOURCE[0]%/*}/.." && pwd)
build=$root/build
logs=$build/logs
jobs=$(nproc)
mkdir -p "$logs"

# A python3 of pyenv or conda that stands first on PATH knows nothing of ROS.
export PATH=/usr/bin:$PATH

say() { printf '%s\n' "$*"; }
complain() { printf '%s\n' "$*" >&2; }

# quietly LOG COMMAND…: what it says goes to build/logs/LOG.log, and is shown when it fails.
quietly() {
  local log=$logs/$1.log
  shift
  if "$@" >"$log" 2>&1 </dev/null; then return 0; fi
  complain "failed: $*"
  tail -n 40 "$log" >&2
  complain "all of it stands in $log"
  return 1
}

# missingPackages GROUP…: those of scripts/packages.txt that are not installed, on one line.
missingPackages() {
  local wanted installed groups
  groups=$(IFS='|' && printf '%s' "$*")
  wanted=$(sed -nE "s/^($groups) ([^ ]+)$/\2/p" "$root/scripts/packages.txt" | sort -u)
  # shellcheck disable=SC2016,SC2086  # dpkg-query fills ${…} in; the names are to be split
  installed=$(dpkg-query -W -f '${Package} ${db:Status-Status}\n' $wanted 2>/dev/null |
    sed -n 's/ installed$//p' | sort -u)
  comm -23 <(printf '%s\n' "$wanted") <(printf '%s\n' "$installed") | paste -sd ' '
}

# installPackages GROUP…: installs what is missing, as root or with sudo; returns 1 where it may not.
installPackages() {
  local missing as_root=() line
  if ! command -v dpkg-query apt-get >/dev/null; then
    complain "This is no Debian. Install what package.xml names and build in a catkin workspace."
    return 1
  fi
  missing=$(missingPackages "$@")
  [ -n "$missing" ] || return 0
  line="apt-get install -y --no-install-recommends $missing"
  if [ "$(id -u)" -ne 0 ]; then
    # Without a terminal sudo can't ask for a password.
    if ! command -v sudo >/dev/null || { ! sudo -n true 2>/dev/null && [ ! -t 0 ]; }; then
      complain "Packages are missing, and only root can install them. Please run as root:"
      complain "apt-get update && $line"
      return 1
    fi
    as_root=(sudo)
    sudo -v || return 1
  fi
  say "Installing what is missing (a few minutes; output in $logs/apt.log):"
  say "${as_root[*]:+${as_root[*]} }apt-get update && ${as_root[*]:+${as_root[*]} }$line"
  # shellcheck disable=SC2086  # the line is to be split
  quietly apt-update "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get update &&
    quietly apt "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive $line
}

# configure TREE OPTION…: the CMake build tree build/TREE.
configure() {
  local tree=$build/$1 launcher=()
  shift
  # A tree that stood somewhere else before can't be used again.
  if ! grep -qsxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$tree/CMakeCache.txt"; then
    rm -rf "$tree"
  fi
  if command -v ccache >/dev/null; then launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi
  quietly "configure-${tree##*/}" cmake -S "$root" -B "$tree" "${launcher[@]}" \
    -DPYTHON_EXECUTABLE=/usr/bin/python3 -DPython3_EXECUTABLE=/usr/bin/python3 "$@"
}

# testsOf TREE: ON where an earlier scripts/test configured it with tests, so that demo and hagl leave
# that as it is.
testsOf() {
  if grep -qsx 'GOAL_ALIGNMENT_TESTS:BOOL=ON' "$build/$1/CMakeCache.txt"; then
    printf ON
  else
    printf OFF
  fi
}

# rvizWanted: ON where the panel for rviz was built before, or can be, so that demo and hagl leave that
# as it is.
rvizWanted() {
  if [ -z "$(missingPackages rviz)" ]; then printf ON; else printf OFF; fi
}

# compile TREE [TARGET]…
compile() {
  local tree=$1
  shift
  quietly "build-$tree" cmake --build "$build/$tree" -j "$jobs" ${1+--target "$@"}
}

# The package without ROS; compile core … follows.
configureCore() { configure core -DGOAL_ALIGNMENT_ROS=OFF -DCMAKE_BUILD_TYPE=Release "$@"; }

# The catkin package; compile ros … follows.
configureRos() {
  configure ros -DCATKIN_DEVEL_PREFIX="$build/devel" -DCMAKE_INSTALL_PREFIX="$build/install" \
    -DCMAKE_BUILD_TYPE=Release "$@"
}

# useRos [SPACE]: the shell becomes one of the package's own ROS environment, by default that of the
# devel space.
useRos() {
  local space=${1-$build/devel}
  # No plugin of an rviz for ROS 2 may be found, and names resolve without a network.
  unset AMENT_PREFIX_PATH
  export ROS_HOSTNAME=${ROS_HOSTNAME:-localhost} ROS_HOME=${ROS_HOME:-$build/ros_home}
  set +u # catkin's own scripts read unset variables
  # shellcheck disable=SC1091  # made by the build
  . "$space/setup.bash"
  set -u
}
