// SPDX-License-Identifier: BSD-3-Clause
#include "point_markers.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <vector>

#include "marker.hpp"

namespace adaptive_localization {
namespace {

using visualization_msgs::Marker;

constexpr std::size_t kLookedAt = 5;  // poses for each point

/// Light blue at -1, green at 0, red at 1: a background for all else. Opaque, so that rviz draws it
/// first.
std_msgs::ColorRGBA colourOf(double deviation) {
  constexpr float kPale = 0.6F;
  const auto share = static_cast<float>(std::clamp(deviation, -1.0, 1.0));
  return colour(kPale + (1.0F - kPale) * std::max(0.0F, share), 1.0F - 0.25F * std::abs(share),
                kPale + (1.0F - kPale) * std::max(0.0F, -share));
}

/// None yet, squares of this size in m.
Marker points(const std_msgs::Header& header, const char* name, double size) {
  Marker marker = makeMarker(header, name, 0, Marker::POINTS);
  marker.scale.x = marker.scale.y = size;
  return marker;
}

void add(Marker& marker, const Eigen::Vector2d& at, const std_msgs::ColorRGBA& painted) {
  geometry_msgs::Point point;
  point.x = at.x();
  point.y = at.y();
  marker.points.push_back(point);
  marker.colors.push_back(painted);
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
  Marker marker =
      points(header, "ser", grid.ranges().lattice().resolution() * grid.ranges().spacing());
  const auto energy = grid.energyOf(scan);
  const auto region = energy ? grid.similarTo(*energy) : EnergyGrid::Region{};
  if (region.isEmpty()) {
    marker.action = Marker::DELETE;
    return marker;
  }
  const Poses poses = nearestInCells(grid, region, energy->value, kLookedAt * most);
  const std::size_t step = (poses.size() + most - 1) / most;
  for (std::size_t k = 0; k < poses.size(); k += step) {
    const Pose2 pose = grid.pose(poses[k]);
    add(marker, {pose.x, pose.y},
        colourOf((grid.energy(poses[k]) - energy->value) / energy->delta));
  }
  return marker;
}

Marker matchMarker(const std_msgs::Header& header, const Match* match, const Scan& scan) {
  constexpr double kSize = 0.05;   // m
  constexpr double kHeight = 0.5;  // m, above the laser's own points
  Marker marker = points(header, "match", kSize);
  marker.pose.position.z = kHeight;
  const auto hits = static_cast<std::size_t>(scan.hits());
  if (!match || hits == 0 || match->fits.size() != hits) {
    marker.action = Marker::DELETE;
    return marker;
  }
  const auto fitting = colour(isRefusal(match->fault) ? kRefusedMatch : kFittingHit);
  const auto other = colour(kOtherHit);
  for (Eigen::Index i = 0; i < scan.hits(); ++i) {
    const Eigen::Vector2d hit = match->T_map_base * Eigen::Vector2d(scan.x[i], scan.y[i]);
    add(marker, hit, match->fits[static_cast<std::size_t>(i)] ? fitting : other);
  }
  return marker;
}

}  // namespace adaptive_localization
