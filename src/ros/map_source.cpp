// SPDX-License-Identifier: BSD-3-Clause
#include "map_source.hpp"

#include <nav_msgs/GetMap.h>

#include <utility>

#include "callbacks.hpp"

namespace adaptive_localization {

MapSource::MapSource(ros::NodeHandle node, bool use_topic, bool first_only, Callback callback,
                     UpdateCallback on_update)
    : callback_(std::move(callback)), first_only_(first_only) {
  if (use_topic) {
    subscriber_ = subscribe<nav_msgs::OccupancyGrid, nav_msgs::OccupancyGrid::Ptr>(
        node, "map", 1, [this](const auto& map) { onTopic(*map); });
    if (!first_only) {
      updates_ = subscribe<map_msgs::OccupancyGridUpdate>(
          node, "map_updates", 100, [on_update](const auto& update) { on_update(*update); });
    }
    name_ = "topic " + subscriber_.getTopic();
    ROS_INFO("Waiting for a map on %s", name_.c_str());
    return;
  }
  service_ = node.serviceClient<nav_msgs::GetMap>("static_map");
  timer_ = every(node, ros::WallDuration(0.5), "Asking for a map", [this] { ask(); });
  name_ = "service " + service_.getService();
  ROS_INFO("Waiting for a map from %s", name_.c_str());
}

void MapSource::onTopic(nav_msgs::OccupancyGrid& map) {
  if (callback_(std::move(map)) && first_only_) subscriber_.shutdown();
}

void MapSource::ask() {
  nav_msgs::GetMap request;
  if (!service_.exists() || !service_.call(request)) return;  // the node says what it waits for
  if (callback_(std::move(request.response.map))) timer_.stop();
}

}  // namespace adaptive_localization
