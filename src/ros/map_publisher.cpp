// SPDX-License-Identifier: BSD-3-Clause
#include "map_publisher.hpp"

#include "adaptive_localization/map/map_io.hpp"
#include "callbacks.hpp"
#include "conversions.hpp"

namespace adaptive_localization {
namespace {

using nav_msgs::LoadMap;

LoadMap::Response::_result_type resultOf(MapFileError::Reason reason) {
  switch (reason) {
    case MapFileError::Reason::kMissing:
      return LoadMap::Response::RESULT_MAP_DOES_NOT_EXIST;
    case MapFileError::Reason::kImage:
      return LoadMap::Response::RESULT_INVALID_MAP_DATA;
    case MapFileError::Reason::kMetadata:
      return LoadMap::Response::RESULT_INVALID_MAP_METADATA;
  }
  return LoadMap::Response::RESULT_UNDEFINED_FAILURE;
}

std::string pathOf(const std::string& url) {
  const std::string scheme = "file://";
  return url.rfind(scheme, 0) == 0 ? url.substr(scheme.size()) : url;
}

}  // namespace

MapPublisher::MapPublisher(ros::NodeHandle node, ros::NodeHandle private_node,
                           const std::string& yaml_file)
    : frame_(private_node.param<std::string>("frame_id", "map")),
      map_publisher_(node.advertise<nav_msgs::OccupancyGrid>("map", 1, true)),
      metadata_publisher_(node.advertise<nav_msgs::MapMetaData>("map_metadata", 1, true)) {
  load(yaml_file);
  static_map_ = serve<nav_msgs::GetMap>(node, "static_map", [this](auto&, auto& response) {
    response.map = map_;
    return true;
  });
  change_map_ = serve<nav_msgs::LoadMap>(node, "change_map", [this](auto& request, auto& response) {
    return onChangeMap(request, response);
  });
}

void MapPublisher::load(const std::string& yaml_file) {
  map_ = toMessage(loadMap(yaml_file));
  map_.header.frame_id = frame_;
  map_.header.stamp = ros::Time::now();
  map_.info.map_load_time = map_.header.stamp;
  ROS_INFO("Map '%s': %u x %u cells of %.3f m", yaml_file.c_str(), map_.info.width,
           map_.info.height, static_cast<double>(map_.info.resolution));
  map_publisher_.publish(map_);
  metadata_publisher_.publish(map_.info);
}

bool MapPublisher::onChangeMap(LoadMap::Request& request, LoadMap::Response& response) {
  try {
    load(pathOf(request.map_url));
    response.map = map_;
    response.result = LoadMap::Response::RESULT_SUCCESS;
  } catch (const MapFileError& error) {
    ROS_ERROR("Map not changed: %s", error.what());
    response.result = resultOf(error.reason());
  }
  return true;
}

}  // namespace adaptive_localization
