// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map_msgs/OccupancyGridUpdate.h>
#include <nav_msgs/OccupancyGrid.h>
#include <ros/ros.h>

#include <functional>
#include <string>

namespace adaptive_localization {

/// Where the map comes from: each one on topic 'map', and what changes of it on 'map_updates', or
/// one from service 'static_map', asked for until it answers with a map that can be used, without
/// holding up anything else.
class MapSource {
 public:
  /// Is given the message, which may be large, to take apart; says whether it can be used.
  using Callback = std::function<bool(nav_msgs::OccupancyGrid&&)>;

  using UpdateCallback = std::function<void(const map_msgs::OccupancyGridUpdate&)>;

  MapSource(ros::NodeHandle node, bool use_topic, bool first_only, Callback callback,
            UpdateCallback on_update);

  /// The topic or service it asks.
  const std::string& name() const { return name_; }

  /// There is a map from elsewhere: asking for one waits for the master, and takes that one away.
  void stopAsking() { timer_.stop(); }

 private:
  void onTopic(nav_msgs::OccupancyGrid& map);
  void ask();

  Callback callback_;
  bool first_only_;
  std::string name_;
  ros::Subscriber subscriber_;
  ros::Subscriber updates_;
  ros::ServiceClient service_;
  ros::WallTimer timer_;
};

}  // namespace adaptive_localization
