// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "adaptive_localization/core/options.hpp"
#include "ser/ser_sampler.hpp"

namespace adaptive_localization {

struct PlaceSamplerOptions {
  double place_deviation_xy{0.1};
  double place_deviation_theta{kPi / 60.0};
  double place_error_scale{0.02};
  double place_ser_share{0.2};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("place_deviation_xy", place_deviation_xy, kDeviation, "m",
           "Standard deviation in x and y of poses drawn around a place.");
    option("place_deviation_theta", place_deviation_theta, kDeviation, "rad",
           "Standard deviation in heading of poses drawn around a place.");
    option("place_error_scale", place_error_scale, kPositive, "m",
           "A place whose mean range error is this much above the best one's is drawn e times less "
           "often.");
    option("place_ser_share", place_ser_share, kProbability, "",
           "Share of poses drawn from the SER instead, in case that no place is the right one.");
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
