// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/map/lattice.hpp"

#include <stdexcept>
#include <string>

namespace adaptive_localization {

Lattice::Lattice(int width, int height, double resolution, const Pose2& origin)
    : width_(width),
      height_(height),
      resolution_(resolution),
      origin_(origin),
      inverse_origin_(inverse(origin)) {
  if (width <= 0 || height <= 0) {
    throw std::invalid_argument("map size: got " + std::to_string(width) + " x " +
                                std::to_string(height) + " cells, expected at least 1 x 1");
  }
  if (!(resolution > 0.0) || !std::isfinite(resolution)) {
    throw std::invalid_argument("map resolution: got " + std::to_string(resolution) +
                                ", expected a positive number of metres per cell");
  }
  if (!isFinite(origin)) {
    throw std::invalid_argument("map origin: got a number that is not finite, expected x, y, yaw");
  }
}

Cell Lattice::cellAt(const Eigen::Vector2d& point_map) const {
  const Eigen::Vector2d cells = (inverse_origin_ * point_map) / resolution_;
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
