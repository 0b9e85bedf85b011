// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <std_msgs/Header.h>
#include <visualization_msgs/Marker.h>

#include <string>

#include "adaptive_localization/core/pose2.hpp"
#include "conversions.hpp"
#include "palette.hpp"

namespace adaptive_localization {

/// A colour of rviz, each part in [0, 1]; opaque unless told otherwise.
inline std_msgs::ColorRGBA colour(float red, float green, float blue, float alpha = 1.0F) {
  std_msgs::ColorRGBA result;
  result.r = red;
  result.g = green;
  result.b = blue;
  result.a = alpha;
  return result;
}

inline std_msgs::ColorRGBA colour(const Rgb& rgb) {
  return colour(rgb.red, rgb.green, rgb.blue);
}

/// A marker for rviz without a size or a colour yet; `name` is its namespace.
inline visualization_msgs::Marker makeMarker(const std_msgs::Header& header,
                                             const std::string& name, int id, int type,
                                             const Pose2& pose = {}) {
  visualization_msgs::Marker marker;
  marker.header = header;
  marker.ns = name;
  marker.id = id;
  marker.type = type;
  marker.pose = toPoseMessage(pose);
  return marker;
}

}  // namespace adaptive_localization
