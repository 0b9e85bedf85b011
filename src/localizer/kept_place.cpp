// SPDX-License-Identifier: BSD-3-Clause
#include "kept_place.hpp"

#include <algorithm>
#include <limits>

#include "localizer/usual_error.hpp"

namespace adaptive_localization {
namespace {

constexpr double kMostOff = 0.4, kMostHidden = 0.5;              // of the beams
constexpr double kMostHits = 0.8, kNearlyAll = 0.95;             // of the hits
constexpr double kThrough = 0.05, kOfShort = 0.4;                // of the beams; of those too short
constexpr double kMostOfRest = 0.9;                              // of those that nothing hides
constexpr double kHidden = 0.2, kInitial = 2.0, kTracked = 1.5;  // log odds

}  // namespace

bool isHidden(const RangeError::Fit& fit) {
  return fit.throughShare() < std::max(kThrough, kOfShort * fit.short_share);
}

double mostAgainst(const PlaceRefiner& refiner, const Pose2& T_map_base, bool is_word,
                   double usual_error) {
  const RangeError::Fit fit = refiner.fit(T_map_base);
  const bool is_hidden = isHidden(fit);
  const double most_hidden = std::max(kMostHidden, kMostOfView / refiner.view());
  const bool fits_by_ranges = fit.off_share < (is_hidden ? most_hidden : kMostOff);
  const double on = refiner.hitShare(T_map_base, UsualError(usual_error).limit());
  if (!fits_by_ranges && on <= kMostHits) {
    return refiner.view() > kMostOfView ? std::numeric_limits<double>::infinity() : kMostPerMetre;
  }
  const double nearly_all = fits_by_ranges ? kMostOfRest * (1.0 - fit.short_share) : kNearlyAll;
  const double stray = 1.0 / std::max(1, refiner.hits());
  if (is_hidden || on + stray > nearly_all) return kHidden;
  return is_word ? kInitial : kTracked;
}

}  // namespace adaptive_localization
