// SPDX-License-Identifier: BSD-3-Clause
#include "ser_marker.hpp"

#include <algorithm>
#include <cmath>

namespace adaptive_localization {
namespace {

using visualization_msgs::Marker;

/// Light blue at -1, green at 0, red at 1: a background for all else. Opaque, so that rviz draws it
/// first.
std_msgs::ColorRGBA colourOf(double deviation) {
  constexpr float kPale = 0.6F;
  const auto share = static_cast<float>(std::clamp(deviation, -1.0, 1.0));
  std_msgs::ColorRGBA colour;
  colour.r = kPale + (1.0F - kPale) * std::max(0.0F, share);
  colour.g = 1.0F - 0.25F * std::abs(share);
  colour.b = kPale + (1.0F - kPale) * std::max(0.0F, -share);
  colour.a = 1.0F;
  return colour;
}

geometry_msgs::Point pointAt(const Pose2& pose) {
  geometry_msgs::Point point;
  point.x = pose.x;
  point.y = pose.y;
  return point;
}

}  // namespace

Marker serMarker(const std_msgs::Header& header, const EnergyGrid& grid, const Scan& scan,
                 std::size_t most) {
  Marker marker;
  marker.header = header;
  marker.ns = "ser";
  marker.type = Marker::POINTS;
  marker.pose.orientation.w = 1.0;
  marker.scale.x = marker.scale.y =
      grid.ranges().lattice().resolution() * grid.ranges().spacing();  // m
  const auto energy = grid.energyOf(scan);
  const auto region = energy ? grid.similarTo(*energy) : EnergyGrid::Region{};
  if (region.isEmpty()) {
    marker.action = Marker::DELETE;
    return marker;
  }
  const std::size_t step = (region.size() + most - 1) / most;
  for (std::size_t i = region.begin; i < region.end; i += step) {
    marker.points.push_back(pointAt(grid.pose(i)));
    marker.colors.push_back(colourOf((grid.energy(i) - energy->value) / energy->delta));
  }
  return marker;
}

}  // namespace adaptive_localization
