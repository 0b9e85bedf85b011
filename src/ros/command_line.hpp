// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include "core/error_text.hpp"

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

/// Calls a node's main, after ros::init; says what it throws. Returns the program's exit code.
template <class Main>
int runNode(const Main& main) {
  const ros::NodeHandle node;  // outlives the try, else there is no log to say the error in
  try {
    main(node);
  } catch (...) {
    ROS_FATAL("%s", errorText().c_str());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}

}  // namespace adaptive_localization
