// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nav_msgs/GetMap.h>
#include <nav_msgs/LoadMap.h>
#include <ros/ros.h>

#include <string>

namespace adaptive_localization {

/// Serves a map file as map_server does: latched topics map and map_metadata, services static_map
/// and change_map, parameter ~frame_id.
class MapPublisher {
 public:
  /// Throws MapFileError when the map cannot be read.
  MapPublisher(ros::NodeHandle node, ros::NodeHandle private_node, const std::string& yaml_file);

 private:
  void load(const std::string& yaml_file);
  bool onChangeMap(nav_msgs::LoadMap::Request& request, nav_msgs::LoadMap::Response& response);

  std::string frame_;
  nav_msgs::OccupancyGrid map_;
  ros::Publisher map_publisher_;
  ros::Publisher metadata_publisher_;
  ros::ServiceServer static_map_;
  ros::ServiceServer change_map_;
};

}  // namespace adaptive_localization
