// SPDX-License-Identifier: BSD-3-Clause
#include "core/sweep_watch.hpp"

#include <algorithm>

namespace adaptive_localization {

bool SweepWatch::isPossible(const std::string& frame, const LaserScan& scan) {
  constexpr double kSlack = 1.5;   // stamps are not exact
  constexpr std::size_t kFew = 3;  // scans: too few to tell a pause
  Seen& seen = seen_[frame];
  const double period = scan.stamp - seen.stamp;
  if (seen.count > 0 && period < 0.0) seen = {};  // time jumped back
  if (seen.count > 0) seen.period[seen.count % kPeriods] = period;
  seen.stamp = scan.stamp;
  ++seen.count;
  std::array<double, kPeriods> sorted = seen.period;
  std::sort(sorted.rbegin(), sorted.rend());
  const double usual = seen.count > kFew ? sorted[1] : sorted[0];
  return usual == 0.0 || durationOf(scan) <= kSlack * usual;
}

}  // namespace adaptive_localization
