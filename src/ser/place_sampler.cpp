// SPDX-License-Identifier: BSD-3-Clause
#include "ser/place_sampler.hpp"

#include <algorithm>
#include <cmath>

namespace adaptive_localization {
namespace {

// Of poses drawn around a place, and how much worse (mean range error, m) one is drawn e times
// less.
constexpr double kDeviationXy = 0.1, kDeviationTheta = kPi / 60.0, kErrorScale = 0.02;

}  // namespace

PlaceSampler::PlaceSampler(const PlaceSamplerOptions& options, std::shared_ptr<Places> places,
                           std::shared_ptr<const OccupancyGrid> map)
    : options_(options), places_(places), ser_(std::move(places), std::move(map)) {}

bool PlaceSampler::condition(const Observations& observations) {
  found_.clear();
  cumulative_.clear();
  const bool has_ser = ser_.condition(observations);
  if (observations.scan.hits() > 0) {
    found_ = places_->search(observations).value_or(std::vector<Place>{});
  }
  double sum = 0.0;
  for (const Place& place : found_) {
    sum += std::exp(-(place.error - found_.front().error) / kErrorScale);
    cumulative_.push_back(sum);
  }
  return has_ser || !found_.empty();
}

Pose2 PlaceSampler::draw(Rng& rng) const {
  const bool from_ser = !ser_.isEmpty() && rng.uniform() < options_.place_ser_share;
  if (found_.empty() || from_ser) return ser_.draw(rng);
  const double chosen = rng.uniform() * cumulative_.back();
  const auto at = std::upper_bound(cumulative_.begin(), cumulative_.end(), chosen);
  const auto k =
      std::min<std::size_t>(static_cast<std::size_t>(at - cumulative_.begin()), found_.size() - 1);
  const Pose2& place = found_[k].T_map_base;
  const double x = rng.normal(place.x, kDeviationXy);
  const double y = rng.normal(place.y, kDeviationXy);
  return {x, y, wrapAngle(rng.normal(place.theta, kDeviationTheta))};
}

}  // namespace adaptive_localization
