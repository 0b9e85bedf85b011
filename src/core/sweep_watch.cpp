// SPDX-License-Identifier: BSD-3-Clause
#include "core/sweep_watch.hpp"

#include <algorithm>

namespace adaptive_localization {

bool SweepWatch::isPossible(const std::string& frame, const LaserScan& scan) {
  constexpr double kSlack = 1.5;  // stamps are not exact
  Seen& seen = seen_[frame];
  const double period = scan.stamp - seen.stamp;
  if (seen.count > 0 && period < 0.0) seen = {};  // time jumped back
  if (seen.count > 0) seen.period[seen.count % kPeriods] = period;
  seen.stamp = scan.stamp;
  ++seen.count;
  const double longest = *std::max_element(seen.period.begin(), seen.period.end());
  return longest == 0.0 || durationOf(scan) <= kSlack * longest;
}

}  // namespace adaptive_localization
