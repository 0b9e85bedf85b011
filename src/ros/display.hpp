// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>

#include "adaptive_localization/localizer.hpp"
#include "node_options.hpp"

namespace adaptive_localization {

/// What is only for eyes: ~ser, where scans would have the energy of the newest one, and
/// ~status_text. Made while somebody looks, and a few times a second at the most.
class Display {
 public:
  Display(ros::NodeHandle private_node, const NodeOptions& options);

  /// May start the building of an energy grid.
  void show(const Localization& answer, const Scan& scan, Places& places, const ros::Time& stamp);

 private:
  const NodeOptions& options_;  // the node's, which may change
  ros::Publisher ser_;
  ros::Publisher text_;
  ros::WallTime shown_;
};

}  // namespace adaptive_localization
