// SPDX-License-Identifier: BSD-3-Clause
#include "ser_marker.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <vector>

namespace adaptive_localization {
namespace {

using visualization_msgs::Marker;

constexpr std::size_t kLookedAt = 5;  // poses for each point

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

using Poses = std::vector<std::size_t>;

/// Of the poses of a region those that differ least from the energy in their cells, in the order of
/// energies: headings would hide one another. Of very many poses only some are looked at.
Poses nearestInCells(const EnergyGrid& grid, const EnergyGrid::Region& region, double energy,
                     std::size_t most) {
  const Lattice& lattice = grid.ranges().lattice();
  const auto deviation = [&](std::size_t i) { return std::abs(grid.energy(i) - energy); };
  std::unordered_map<std::size_t, std::size_t> nearest;
  const std::size_t step = region.size() / most + 1;
  for (std::size_t i = region.begin; i < region.end; i += step) {
    const Pose2 pose = grid.pose(i);
    const Cell cell = lattice.cellAt({pose.x, pose.y});
    const auto [place, is_new] = nearest.try_emplace(lattice.index(cell), i);
    if (!is_new && deviation(i) < deviation(place->second)) place->second = i;
  }
  Poses poses;
  for (const auto& entry : nearest) poses.push_back(entry.second);
  std::sort(poses.begin(), poses.end());
  return poses;
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
  const Poses poses = nearestInCells(grid, region, energy->value, kLookedAt * most);
  const std::size_t step = (poses.size() + most - 1) / most;
  for (std::size_t k = 0; k < poses.size(); k += step) {
    marker.points.push_back(pointAt(grid.pose(poses[k])));
    marker.colors.push_back(colourOf((grid.energy(poses[k]) - energy->value) / energy->delta));
  }
  return marker;
}

}  // namespace adaptive_localization
