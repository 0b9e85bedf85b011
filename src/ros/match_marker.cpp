// SPDX-License-Identifier: BSD-3-Clause
#include "match_marker.hpp"

namespace adaptive_localization {
namespace {

using visualization_msgs::Marker;

std_msgs::ColorRGBA colour(float red, float green, float blue) {
  std_msgs::ColorRGBA result;
  result.r = red;
  result.g = green;
  result.b = blue;
  result.a = 1.0F;
  return result;
}

}  // namespace

Marker matchMarker(const std_msgs::Header& header, const Match* match, const Scan& scan) {
  constexpr double kSize = 0.05;   // m
  constexpr double kHeight = 0.5;  // m, above the laser's own points
  Marker marker;
  marker.header = header;
  marker.ns = "match";
  marker.type = Marker::POINTS;
  marker.pose.orientation.w = 1.0;
  marker.pose.position.z = kHeight;
  marker.scale.x = marker.scale.y = kSize;
  const auto hits = static_cast<std::size_t>(scan.hits());
  if (!match || hits == 0 || match->fits.size() != hits) {
    marker.action = Marker::DELETE;
    return marker;
  }
  const auto fitting = match->isGood() ? colour(0.0F, 0.6F, 0.0F) : colour(0.9F, 0.7F, 0.0F);
  const auto other = colour(0.9F, 0.0F, 0.7F);
  for (Eigen::Index i = 0; i < scan.hits(); ++i) {
    const Eigen::Vector2d hit = match->T_map_base * Eigen::Vector2d(scan.x[i], scan.y[i]);
    geometry_msgs::Point point;
    point.x = hit.x();
    point.y = hit.y();
    marker.points.push_back(point);
    marker.colors.push_back(match->fits[static_cast<std::size_t>(i)] ? fitting : other);
  }
  return marker;
}

}  // namespace adaptive_localization
