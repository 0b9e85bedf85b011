// SPDX-License-Identifier: BSD-3-Clause
#include "ser/ser_sampler.hpp"

namespace adaptive_localization {

SerSampler::SerSampler(std::shared_ptr<Places> places, std::shared_ptr<const OccupancyGrid> map)
    : places_(std::move(places)), free_space_(std::move(map)) {}

bool SerSampler::condition(const Observations& observations) {
  region_ = {};
  grid_ = observations.scan.hits() > 0 ? places_->energyGrid(observations.scan) : nullptr;
  if (!grid_) return false;
  const auto energy = grid_->energyOf(observations.scan);
  if (energy) region_ = grid_->similarTo(*energy);
  return !isEmpty();
}

Pose2 SerSampler::draw(Rng& rng) const {
  if (isEmpty()) return free_space_.draw(rng);
  const std::size_t chosen = region_.begin + rng.below(region_.size());
  const double x = rng.uniform(-0.5, 0.5);
  const double y = rng.uniform(-0.5, 0.5);
  return grid_->pose(chosen, {x, y, rng.uniform(-0.5, 0.5)});
}

}  // namespace adaptive_localization
