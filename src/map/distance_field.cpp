// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/map/distance_field.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/parallel.hpp"
#include "distance_kernel.hpp"
#include "occupied_depth.hpp"

namespace adaptive_localization {
namespace {

constexpr double kReach = 5.0;                      // m
constexpr int kLeastReach = 16, kMostReach = 1023;  // cells
constexpr int kBlock =
    512;  // cells, the side of what is made at once; a multiple of a tile's sides
static_assert(kBlock % SparseGrid::kTileColumns == 0 && kBlock % SparseGrid::kTileRows == 0);

int reachInCells(const Lattice& lattice) {
  return static_cast<int>(
      std::clamp<double>(std::ceil(kReach / lattice.resolution()), kLeastReach, kMostReach));
}

/// To whole tiles.
cv::Size roundedUp(const cv::Size& size) {
  constexpr int kColumns = SparseGrid::kTileColumns, kRows = SparseGrid::kTileRows;
  return {(size.width + kColumns - 1) / kColumns * kColumns,
          (size.height + kRows - 1) / kRows * kRows};
}

cv::Rect grown(const cv::Rect& box, int by) {
  return {box.x - by, box.y - by, box.width + 2 * by, box.height + 2 * by};
}

/// Those of the occupied cells that are so many cells deep or less. A deeper one is the middle of a
/// square of occupied cells that fits into the circle; most maps have none.
cv::Mat notDeeper(const cv::Mat& occupied, double most) {
  const auto reach = static_cast<int>(most / std::sqrt(2.0));
  if (cv::countNonZero(shrunk(occupied, cv::MORPH_RECT, reach)) == 0) return occupied;
  return occupied & (depthOf(occupied) <= most);
}

double wallDepthInCells(const Lattice& lattice) {
  return 1.0 + kWallDepth / lattice.resolution();
}

/// Cells, rounded up: whether one is of a wall depends on no cell that is farther from it.
int deepestWall(const Lattice& lattice) {
  return static_cast<int>(std::min(wallDepthInCells(lattice), 1e6)) + 1;
}

/// 255 in the cells of a box of the map that end beams, 0 elsewhere.
cv::Mat endsOfBeams(const OccupancyGrid& grid, const cv::Rect& box) {
  cv::Mat cells = occupiedCells(grid, box);
  if (!grid.hasSpeckle()) return cells;
  for (int y = 0; y < cells.rows; ++y) {
    auto* row = cells.ptr<std::uint8_t>(y);
    for (int x = 0; x < cells.cols; ++x) {
      if (row[x] != 0 && !grid.endsBeams({box.x + x, box.y + y})) row[x] = 0;
    }
  }
  return cells;
}

/// The cells of walls in a box of the map, 255, others 0; empty if there are none.
cv::Mat wallsIn(const OccupancyGrid& grid, const cv::Rect& box) {
  const double depth = wallDepthInCells(grid.lattice());
  const cv::Rect map(0, 0, grid.lattice().width(), grid.lattice().height());
  const cv::Rect around = grown(box, deepestWall(grid.lattice())) & map;
  const cv::Mat ends = endsOfBeams(grid, around);
  if (cv::countNonZero(ends) == 0) return {};
  const cv::Mat walls = notDeeper(ends, depth)(box - around.tl());
  return cv::countNonZero(walls) == 0 ? cv::Mat() : walls;
}

/// How many steps each cell of a box of the map is nearer to a wall than the reach; empty if none
/// is.
cv::Mat nearnessIn(const OccupancyGrid& grid, const cv::Rect& box, int reach, int steps_per_cell) {
  const cv::Rect map(0, 0, grid.lattice().width(), grid.lattice().height());
  const cv::Rect around = grown(box, reach) & map;
  const cv::Mat walls = wallsIn(grid, around);
  if (walls.empty()) return {};
  cv::Mat cells, steps;
  cv::distanceTransform(walls == 0, cells, cv::DIST_L2, cv::DIST_MASK_PRECISE, CV_32F);
  cells(box - around.tl()).convertTo(steps, CV_16U, steps_per_cell);
  return cv::Scalar(reach * steps_per_cell) - steps;  // not below 0
}

/// Writes those tiles of a block of the table, whose corner is given, in which something is not 0,
/// or was not.
void write(const cv::Mat& block, const cv::Point& corner, SparseGrid& table) {
  constexpr int kColumns = SparseGrid::kTileColumns, kRows = SparseGrid::kTileRows;
  for (int y = 0; y < block.rows; y += kRows) {
    for (int x = 0; x < block.cols; x += kColumns) {
      const cv::Mat cells = block(cv::Rect(x, y, kColumns, kRows));
      const std::size_t number = table.index(corner.x + x, corner.y + y) / SparseGrid::kTileSize;
      if (!table.isWritten(number) && cv::countNonZero(cells) == 0) continue;
      cv::transpose(cells, cv::Mat(kColumns, kRows, CV_16U, table.write(number)));
    }
  }
}

/// Makes the part of the table of nearnesses that is given, in blocks; its corner is one of tiles.
void fill(const OccupancyGrid& grid, const cv::Rect& part, int reach, int steps_per_cell,
          const StopToken& stop, SparseGrid& table) {
  const cv::Rect map(1, 1, grid.lattice().width(), grid.lattice().height());  // in the table
  const int across = (part.width - 1) / kBlock + 1, down = (part.height - 1) / kBlock + 1;
  const auto blocks = static_cast<std::size_t>(across) * static_cast<std::size_t>(down);
  parallelFor(blocks, 1, [&](const Chunk& chunk) {
    stop.check();
    const auto number = static_cast<int>(chunk.begin);
    const cv::Point corner =
        part.tl() + cv::Point(number % across * kBlock, number / across * kBlock);
    const cv::Rect block = cv::Rect(corner, cv::Size(kBlock, kBlock)) & part;
    const cv::Rect box = block & map;
    if (box.empty()) return;
    const cv::Mat nearness = nearnessIn(grid, box - map.tl(), reach, steps_per_cell);
    cv::Mat values(roundedUp(block.size()), CV_16U, cv::Scalar(0));
    if (!nearness.empty()) nearness.copyTo(values(box - corner));
    write(values, corner, table);
  });
}

/// The part of the table in which patches can have changed something, from one corner of tiles to
/// another.
cv::Rect changedBy(const std::vector<MapPatch>& patches, const Lattice& lattice, int reach) {
  cv::Rect changed;
  for (const MapPatch& patch : patches) {
    changed |= cv::Rect(patch.corner.x + 1, patch.corner.y + 1, patch.width, patch.height);
  }
  const cv::Rect table(0, 0, lattice.width() + 2, lattice.height() + 2);
  const int most = reach + deepestWall(lattice) + OccupancyGrid::kSpeckleReach;
  const cv::Rect near = grown(changed, most) & table;
  constexpr int kColumns = SparseGrid::kTileColumns, kRows = SparseGrid::kTileRows;
  const cv::Point corner(near.x / kColumns * kColumns, near.y / kRows * kRows);
  return cv::Rect(corner, roundedUp(cv::Size(near.br() - corner))) & table;
}

}  // namespace

DistanceField::DistanceField(const OccupancyGrid& grid, const StopToken& stop)
    : lattice_(grid.lattice()),
      step_(lattice_.resolution() / kStepsPerCell),
      reach_(reachInCells(lattice_) * kStepsPerCell),
      has_speckle_(grid.hasSpeckle()),
      quality_(grid),
      nearness_(lattice_.width() + 2, lattice_.height() + 2) {
  const cv::Rect table(0, 0, lattice_.width() + 2, lattice_.height() + 2);
  fill(grid, table, reach_ / kStepsPerCell, kStepsPerCell, stop, nearness_);
}

DistanceField::DistanceField(const OccupancyGrid& grid, const DistanceField& before,
                             const std::vector<MapPatch>& patches, const StopToken& stop)
    : lattice_(grid.lattice()),
      step_(before.step_),
      reach_(before.reach_),
      has_speckle_(grid.hasSpeckle()),
      quality_(grid),
      nearness_(before.nearness_) {
  const int reach = reach_ / kStepsPerCell;
  const bool is_near = has_speckle_ == before.has_speckle_;  // what patches change
  const cv::Rect all(0, 0, lattice_.width() + 2, lattice_.height() + 2);
  const cv::Rect part = is_near ? changedBy(patches, lattice_, reach) : all;
  if (!part.empty()) fill(grid, part, reach, kStepsPerCell, stop, nearness_);
}

NearnessView DistanceField::view() const {
  return {nearness_.values(), nearness_.stride(), lattice_.width(), lattice_.height(), reach_};
}

double DistanceField::between(const Eigen::Vector2d& point_map) const {
  const Eigen::Vector2d cells = lattice_.toLattice(point_map) / lattice_.resolution();
  return step_ * stepsBetween(view(), cells.x() - 0.5, cells.y() - 0.5);
}

double DistanceField::sumBetween(const Pose2& T_map_base, const Eigen::ArrayXf& x,
                                 const Eigen::ArrayXf& y, Eigen::Index stride, double most) const {
  static const DistanceKernel kSum = fastestSumOfSteps();
  const Pose2 base = lattice_.toLattice(T_map_base);
  const double per_metre = 1.0 / lattice_.resolution();
  const double c = per_metre * std::cos(base.theta), s = per_metre * std::sin(base.theta);
  const PointFrame frame{per_metre * base.x - 0.5, per_metre * base.y - 0.5, c, s};
  return step_ * kSum(view(), frame, {x.data(), y.data(), x.size(), stride}, most / step_);
}

}  // namespace adaptive_localization
