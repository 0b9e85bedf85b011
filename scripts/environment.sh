# SPDX-License-Identifier: BSD-3-Clause
# Sourced by the other scripts: where things are, and an environment in which ROS works.
set -euo pipefail
repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${ADAPTIVE_LOCALIZATION_BUILD:-$repository/build}
jobs=${JOBS:-$(nproc)}

if [ -f /opt/ros/noetic/setup.bash ]; then
  set +u
  source /opt/ros/noetic/setup.bash
  set -u
fi
# a python3 of pyenv or conda in front would hide ROS's modules
export PATH=/usr/sbin:/usr/bin:/sbin:/bin:$PATH
export ROS_HOSTNAME=localhost ROS_HOME=$build/ros ROS_LOG_DIR=$build/ros/log
