// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "adaptive_localization/core/options.hpp"
#include "ser/ser_sampler.hpp"

namespace adaptive_localization {

struct PlaceSamplerOptions {
  double place_ser_share{0.2};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("place_ser_share", place_ser_share, kProbability, "",
           "Share of the poses elsewhere that are drawn from the similar energy region, in case no "
           "place is the right one.");
  }
};

/// Around the places that the global search found for the scan just taken,
///
///     p(pose) = (1 - s) sum_k w_k N(pose; place_k, deviations) + s SER(pose),
///     w_k ~ exp(-(error_k - error_best) / scale)
///
/// and from the SER alone where it found none, or takes more work than may be done by now.
class PlaceSampler : public PoseSampler {
 public:
  /// Throws std::invalid_argument if the map has no free cell.
  PlaceSampler(const PlaceSamplerOptions& options, std::shared_ptr<Places> places,
               std::shared_ptr<const OccupancyGrid> map);

  bool condition(const Observations& observations) override;
  Pose2 draw(Rng& rng) const override;

 private:
  PlaceSamplerOptions options_;
  std::shared_ptr<Places> places_;
  SerSampler ser_;
  std::vector<Place> found_;
  std::vector<double> cumulative_;  // weights of the places
};

}  // namespace adaptive_localization
