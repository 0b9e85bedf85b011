// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/PointCloud.h>

#include <Eigen/Core>
#include <string>
#include <vector>

namespace adaptive_localization {

/// A landmark in the frame of the sensor that sights it, m.
struct SightedPoint {
  float id{-1.0F};
  Eigen::Vector2f place{0.0F, 0.0F};
};

/// The message that tells of these, with standard deviations of 0.1 m and 0.05 rad.
inline sensor_msgs::PointCloud toMessage(double stamp, const std::string& frame,
                                         const std::vector<SightedPoint>& points) {
  sensor_msgs::PointCloud message;
  message.header.stamp = ros::Time(stamp);
  message.header.frame_id = frame;
  message.channels.resize(3);
  message.channels[0].name = "id";
  message.channels[1].name = "range_std";
  message.channels[2].name = "bearing_std";
  for (const SightedPoint& sighted : points) {
    geometry_msgs::Point32 point;
    point.x = sighted.place.x();
    point.y = sighted.place.y();
    message.points.push_back(point);
    message.channels[0].values.push_back(sighted.id);
    message.channels[1].values.push_back(0.1F);
    message.channels[2].values.push_back(0.05F);
  }
  return message;
}

}  // namespace adaptive_localization
