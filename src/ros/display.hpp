// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>

#include "adaptive_localization/localizer/localizer.hpp"
#include "map/landmark_map.hpp"
#include "node_options.hpp"

namespace adaptive_localization {

/// What is only for eyes: ~ser, where scans would have the energy of the newest one, ~match, which
/// of its points fit the map, ~status_text, and ~landmarks, where landmarks are and were sighted.
/// Made while somebody looks; all but landmarks a few times a second at the most.
class Display {
 public:
  Display(ros::NodeHandle private_node, const NodeOptions& options);

  /// May start the building of an energy grid. The match, if there is one, is that of the last
  /// update.
  void show(const Localization& answer, const Scan& scan, const Match* match, Places& places,
            const ros::Time& stamp);

  void showLandmarks(const LandmarkMap& known, const Pose2& T_map_base,
                     const std::vector<Sighting>& sightings, const ros::Time& stamp);

 private:
  void showMatch(const Scan& scan, const Match* match, const std_msgs::Header& header);

  const NodeOptions& options_;  // the node's, which may change
  ros::Publisher ser_;
  ros::Publisher match_;
  ros::Publisher text_;
  ros::Publisher landmarks_;
  ros::WallTime shown_, match_shown_;
};

}  // namespace adaptive_localization
