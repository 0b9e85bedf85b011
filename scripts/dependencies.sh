# SPDX-License-Identifier: BSD-3-Clause
# Sourced by setup and package: what is installed with apt. `libraries` and `ros` are built against,
# `panel` by the panel of rviz alone, `commands` are for tests, pictures and pages.
libraries="build-essential cmake libeigen3-dev libopencv-dev libopencv-contrib-dev qtbase5-dev libyaml-cpp-dev libboost-dev
  libboost-iostreams-dev libboost-program-options-dev nlohmann-json3-dev libxxhash-dev liburdfdom-dev libtinyxml-dev"
python="python3-pandas python3-scipy python3-matplotlib python3-yaml"
commands="clang libclang-rt-14-dev liburdfdom-tools libgtest-dev libgmock-dev libbenchmark-dev doxygen xvfb xauth imagemagick parallel strace
  g++-aarch64-linux-gnu qemu-user"

ros="catkin libroscpp-dev librosbag-storage-dev libtopic-tools-dev libmessage-filters-dev libtf2-dev
  libtf2-ros-dev libtf2-geometry-msgs-dev libstd-msgs-dev libstd-srvs-dev libnav-msgs-dev libmap-msgs-dev
  libsensor-msgs-dev libgeometry-msgs-dev libdiagnostic-msgs-dev libvisualization-msgs-dev
  libros-rosgraph-msgs-dev libtf2-msgs-dev libdynamic-reconfigure-config-init-mutex-dev"
panel="librviz-dev"
ros_tests="librostest-dev python3-dynamic-reconfigure python3-rospy python3-rostest python3-rosbag
  python3-rosservice python3-tf2-ros python3-std-srvs python3-map-msgs tf2-tools"
ros_run="python3-roslaunch rosbash python3-rostopic python3-std-msgs python3-nav-msgs python3-sensor-msgs
  python3-geometry-msgs python3-diagnostic-msgs python3-visualization-msgs ros-robot-state-publisher rviz"

noetic="catkin roscpp rosbag-storage topic-tools rosbag rostest roslaunch rospy rosservice rostopic rosbash
  message-filters tf2 tf2-ros tf2-geometry-msgs tf2-msgs std-msgs std-srvs nav-msgs map-msgs sensor-msgs geometry-msgs
  diagnostic-msgs dynamic-reconfigure visualization-msgs rosgraph-msgs robot-state-publisher rviz"
noetic=$(printf 'ros-noetic-%s ' $noetic)

# What this machine installs: Debian's ROS, or Ubuntu's Noetic.
if [ -d /opt/ros/noetic ] || apt-cache show ros-noetic-roscpp > /dev/null 2>&1; then
  ros=$noetic ros_tests="" ros_run=$noetic panel=""
  commands=${commands/libclang-rt-14-dev/}  # part of clang there
elif grep -q '^ID=ubuntu' /etc/os-release; then
  echo "no ros-noetic packages; set up their source first: http://wiki.ros.org/noetic" >&2
  exit 1
fi
