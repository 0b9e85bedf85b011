// SPDX-License-Identifier: BSD-3-Clause
// What is said of where the robot is known to be.
#include <algorithm>

#include "localizer/recovery.hpp"

namespace adaptive_localization {

void Recovery::updateStatus() {
  status_ = judge();
  was_tracking_ = was_tracking_ || (is_settled_ && status_ == Status::kTracking);
}

/// Scans do not fit the place, and either speak for another one, though less than was known before,
/// or fit so badly that there must be one, which is still being searched for. A place that scans
/// alone told, and not long ago, is one of several once such a search takes long, and if it was one
/// of many, until a scan fits there as is usual.
bool Recovery::isDisputed() const {
  constexpr int kLong = 3;  // scans
  if (!is_settled_) return false;
  if (was_refuted_ && unexplained_ > 0) return true;
  if (isOneOfMany() && odds_.areSpent() && !isAsUsual(error_)) return true;
  if (!doubt_.isRaised()) return false;
  if (doubt_.scans() >= kLong && isNew()) return true;
  return unexplained_ > 0 && error_ > kFarWorse * usual_.limit();
}

/// An initial pose is not "tracking" before a scan could contradict it, nor after some way on which
/// no scan told it from all others; nor is a place that hardly explains the scans, however usual
/// such scans are: so badly they fit many another; nor that of a lost robot before it is known
/// where else it can be. A place that scans alone told is one of several until it is proven. What
/// was one of several is not lost as the last of them, before it is decided, as long as the scans
/// fit.
Status Recovery::judge() const {
  if (initial_pose_.isUnverified()) return Status::kGlobalizing;
  const Status nowhere = from_anywhere_ && !was_tracking_ ? Status::kGlobalizing : Status::kLost;
  const bool is_taken = hypotheses_.isByWord() && initial_pose_.isFresh() && unexplained_ == 0;
  const bool was_several = status_ == Status::kAmbiguous;
  const bool is_found = confidence_.latestFit() >= kFoundFit;
  const Status undecided = is_found && was_several ? Status::kAmbiguous : nowhere;
  if (!is_settled_ && !is_taken) {
    return is_found && modes_.size() > 1 ? Status::kAmbiguous : undecided;
  }
  const bool was_lost = status_ == Status::kLost || !was_tracking_;
  if (was_lost && (doubt_.isRaised() || odds_.areLost())) return undecided;
  const double fit = was_lost ? confidence_.latestFit() : confidence_.fit();
  const bool fits = fit >= (was_lost ? kFoundFit : Confidence::kContradiction);
  if (std::max(unfit_, confidence_.contradictions()) >= kContradictions) return nowhere;
  if (!confidence_.isCompact()) return nowhere;
  if (confidence_.isAmbiguous()) return Status::kAmbiguous;
  if (!fits) return nowhere;
  return proof_.isGiven() && !is_unchecked_ ? Status::kTracking : Status::kAmbiguous;
}

}  // namespace adaptive_localization
