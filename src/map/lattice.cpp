// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/map/lattice.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>

namespace adaptive_localization {
namespace {

// No sensor tells less than a millimetre, no world is larger: what is made of a map must fit
// numbers.
constexpr double kFinest = 1e-3;         // m per cell
constexpr double kCoarsest = 1e5;        // m per cell
constexpr double kFarthestOrigin = 1e8;  // m, of the origin; coordinates of the earth are below

/// Of a table with a border of one cell whose sides are whole tiles: its indices are int.
std::int64_t cellsInTiles(int width, int height) {
  constexpr std::int64_t kTile = 64, kBorder = 2;
  const auto whole = [](int cells) { return kTile * ((cells + kBorder + kTile - 1) / kTile); };
  return whole(width) * whole(height);
}

std::string print(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

}  // namespace

Lattice::Lattice(int width, int height, double resolution, const Pose2& origin)
    : width_(width),
      height_(height),
      resolution_(resolution),
      origin_(origin),
      to_lattice_(inverse(origin)) {
  if (width <= 0 || height <= 0) {
    throw std::invalid_argument("map size: got " + std::to_string(width) + " x " +
                                std::to_string(height) + " cells, expected at least 1 x 1");
  }
  if (cellsInTiles(width, height) > std::numeric_limits<int>::max()) {
    throw std::invalid_argument(
        "map size: got " + std::to_string(width) + " x " + std::to_string(height) +
        " cells, expected at most 2147483647 in all, with sides rounded up to multiples of 64");
  }
  if (!(resolution >= kFinest && resolution <= kCoarsest)) {
    throw std::invalid_argument("map resolution: got " + print(resolution) + ", expected " +
                                print(kFinest) + " to " + print(kCoarsest) + " m per cell");
  }
  if (!isFinite(origin) || std::abs(origin.x) > kFarthestOrigin ||
      std::abs(origin.y) > kFarthestOrigin) {
    throw std::invalid_argument("map origin: got (" + print(origin.x) + ", " + print(origin.y) +
                                ") m, " + print(origin.theta) + " rad, expected numbers within " +
                                print(kFarthestOrigin) + " m");
  }
}

Cell Lattice::cellAt(const Eigen::Vector2d& point_map) const {
  const Eigen::Vector2d cells = toLattice(point_map) / resolution_;
  const auto clamp = [](double value) {  // a point far outside must not overflow int
    return static_cast<int>(std::floor(std::fmin(std::fmax(value, -1e9), 1e9)));
  };
  return {clamp(cells.x()), clamp(cells.y())};
}

Eigen::Vector2d Lattice::centre(const Cell& cell) const {
  return origin_ * Eigen::Vector2d((cell.x + 0.5) * resolution_, (cell.y + 0.5) * resolution_);
}

bool Lattice::operator==(const Lattice& other) const {
  return width_ == other.width_ && height_ == other.height_ && resolution_ == other.resolution_ &&
         origin_.x == other.origin_.x && origin_.y == other.origin_.y &&
         origin_.theta == other.origin_.theta;
}

}  // namespace adaptive_localization
