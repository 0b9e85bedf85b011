// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/init.h>

#include <algorithm>
#include <string>
#include <vector>

namespace adaptive_localization {

/// The arguments of a node's program that are not ROS's own, its name not among them. Needs no
/// ros::init and no master.
inline std::vector<std::string> ownArguments(int argc, char** argv) {
  std::vector<std::string> arguments;
  ros::removeROSArgs(argc, argv, arguments);
  arguments.erase(arguments.begin());
  return arguments;
}

/// Whether one of them asks for the usage.
inline bool wantsHelp(const std::vector<std::string>& arguments) {
  return std::any_of(arguments.begin(), arguments.end(), [](const std::string& argument) {
    return argument == "--help" || argument == "-h";
  });
}

}  // namespace adaptive_localization
