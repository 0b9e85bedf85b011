// SPDX-License-Identifier: BSD-3-Clause
// What scans teach of the map, that is, how badly they usually fit, and of how well the place is
// known.
#include <algorithm>

#include "localizer/recovery.hpp"

namespace adaptive_localization {

/// What is usual is learned where the robot is known to be, or was told to be. In a race for a
/// robot that is not, the likeliest place tells.
void Recovery::learn(double error) {
  if (!is_settled_) {
    const double most = isNew() ? hypotheses_.likeliestError() : hypotheses_.mostTolerated();
    learnUsual(std::min(error, most));
  } else if (status_ == Status::kTracking || status_ == Status::kAmbiguous) {  // not while lost
    if (!isOneOfMany() || isAsUsual(error)) learnUsual(error);
  }
}

void Recovery::learnUsual(double error) {
  isNew() ? usual_.observeUnknown(error) : usual_.observe(error);
}

/// The scan is as usual as it is unexplained, and so are those that came while others were searched
/// for, unless the robot may be lost.
void Recovery::findNothingBetter(double error) {
  const bool is_tracked = status_ == Status::kTracking;
  const int scans = is_tracked ? std::min(unexplained_, doubt_.scans() + 1) : 1;
  for (int i = 0; i < scans; ++i) learnUsual(error);
  pace_.findNothingBetter(error);
}

/// Whether a scan that fits the core's place adds to what is known of it. While others are searched
/// for, it tells nothing that it would not tell of them as well.
bool Recovery::isEarned(double error) const {
  constexpr double kWell = 0.1;  // m, of a scan that tells of its place, whatever was before
  const bool is_moot = doubt_.isRaised() || (were_many_ && !isAsUsual(error));
  if (is_settled_ && (proof_.isSuspect() || (isNew() && is_moot))) return false;
  const bool is_tracked = status_ == Status::kTracking && !doubt_.isRaised();
  return is_tracked || (is_settled_ && error < kWell);
}

}  // namespace adaptive_localization
