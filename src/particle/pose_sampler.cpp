// SPDX-License-Identifier: BSD-3-Clause
#include "particle/pose_sampler.hpp"

#include <algorithm>
#include <stdexcept>

namespace adaptive_localization {

FreeSpaceSampler::FreeSpaceSampler(std::shared_ptr<const OccupancyGrid> map)
    : map_(std::move(map)) {
  const Lattice& lattice = map_->lattice();
  std::uint32_t count = 0;
  for (int y = 0; y < lattice.height(); ++y) {
    free_before_row_.push_back(count);
    for (int x = 0; x < lattice.width(); ++x) count += map_->isFree({x, y}) ? 1 : 0;
  }
  free_before_row_.push_back(count);
  if (count == 0) {
    throw std::invalid_argument("map: got no free cell among " + std::to_string(lattice.size()) +
                                ", expected at least one");
  }
}

// Two steps instead of a list of all free cells: such a list would take more memory than the map.
Pose2 FreeSpaceSampler::draw(Rng& rng) const {
  const auto chosen = static_cast<std::uint32_t>(rng.below(free_before_row_.back()));
  const auto after = std::upper_bound(free_before_row_.begin(), free_before_row_.end(), chosen);
  const auto row = static_cast<int>(after - free_before_row_.begin()) - 1;
  std::uint32_t left = chosen - free_before_row_[static_cast<std::size_t>(row)];
  int column = 0;
  while (!map_->isFree({column, row}) || left-- > 0) ++column;
  const Lattice& lattice = map_->lattice();
  const Eigen::Vector2d inside((column + rng.uniform()) * lattice.resolution(),
                               (row + rng.uniform()) * lattice.resolution());
  const Eigen::Vector2d point = lattice.origin() * inside;
  return {point.x(), point.y(), rng.uniform(-kPi, kPi)};
}

}  // namespace adaptive_localization
