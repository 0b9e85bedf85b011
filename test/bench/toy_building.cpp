// SPDX-License-Identifier: BSD-3-Clause
#include "toy_building.hpp"

#include <stdexcept>

#include "adaptive_localization/core/rng.hpp"
#include "map/ray_caster.hpp"
#include "particle/pose_sampler.hpp"

namespace adaptive_localization {
namespace {

constexpr double kResolution = 0.05;  // m
constexpr int kRoom = 160;            // cells from wall to wall
constexpr int kWall = 2;
constexpr int kDoor = 20;
constexpr int kBoxesPerRoom = 4;

/// Cells with x and y exchanged for walls along y.
class Drawing {
 public:
  explicit Drawing(int side)
      : side_(side),
        cells_(static_cast<std::size_t>(side) * static_cast<std::size_t>(side),
               OccupancyGrid::kFree) {}

  void fill(int x, int y, int width, int height, std::int8_t value = OccupancyGrid::kOccupied) {
    for (int row = std::max(0, y); row < std::min(side_, y + height); ++row) {
      for (int column = std::max(0, x); column < std::min(side_, x + width); ++column) {
        cells_[static_cast<std::size_t>(row) * static_cast<std::size_t>(side_) +
               static_cast<std::size_t>(column)] = value;
      }
    }
  }
  std::vector<std::int8_t> take() { return std::move(cells_); }

 private:
  int side_;
  std::vector<std::int8_t> cells_;
};

}  // namespace

std::shared_ptr<const OccupancyGrid> toyBuilding(int side) {
  Drawing drawing(side);
  Rng rng(1);
  for (int wall = kRoom; wall < side; wall += kRoom) {
    drawing.fill(wall, 0, kWall, side);
    drawing.fill(0, wall, side, kWall);
  }
  for (int y = 0; y < side; y += kRoom) {
    for (int x = 0; x < side; x += kRoom) {
      const int door = 20 + static_cast<int>(rng.below(kRoom - 60));
      drawing.fill(x + kRoom, y + door, kWall, kDoor, OccupancyGrid::kFree);
      drawing.fill(x + door, y + kRoom, kDoor, kWall, OccupancyGrid::kFree);
      for (int box = 0; box < kBoxesPerRoom; ++box) {  // in the half away from the truth
        drawing.fill(x + 10 + static_cast<int>(rng.below(60)),
                     y + 10 + static_cast<int>(rng.below(130)), 12, 8);
      }
    }
  }
  for (const int edge : {0, side - kWall}) {
    drawing.fill(edge, 0, kWall, side);
    drawing.fill(0, edge, side, kWall);
  }
  return std::make_shared<const OccupancyGrid>(Lattice(side, side, kResolution, {}),
                                               drawing.take());
}

Observations observe(const std::shared_ptr<const OccupancyGrid>& map, const Pose2& T_map_base,
                     int beams) {
  const RayCaster caster(map);
  Rng rng(2);
  LaserScan message;
  message.angle_min = -kPi;
  message.angle_increment = 2.0 * kPi / beams;
  message.range_min = 0.05;
  message.range_max = 300.0;
  for (int i = 0; i < beams; ++i) {
    const double bearing = message.angle_min + i * message.angle_increment;
    const Pose2 ray{T_map_base.x, T_map_base.y, T_map_base.theta + bearing};
    message.ranges.push_back(
        static_cast<float>(caster.range(ray, message.range_max) + rng.normal(0.0, 0.01)));
  }
  ScanOptions options;
  options.laser_max_beams = beams;
  Observations observations;
  observations.scan = toScan(message, LaserMount{}, options);
  if (observations.scan.hits() != beams) throw std::logic_error("a beam left the toy building");
  return observations;
}

Particles spread(Spread kind, Eigen::Index count, const std::shared_ptr<const OccupancyGrid>& map) {
  Rng rng(3);
  FreeSpaceSampler free_space(map);
  Particles particles(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    particles.setPose(i, kind == Spread::kGlobal
                             ? free_space.draw(rng)
                             : Pose2{rng.normal(kTruth.x, 0.2), rng.normal(kTruth.y, 0.2),
                                     wrapAngle(rng.normal(kTruth.theta, 0.1))});
  }
  return particles;
}

}  // namespace adaptive_localization
