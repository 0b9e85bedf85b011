// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "adaptive_localization/core/particles.hpp"
#include "adaptive_localization/core/pose2.hpp"

namespace adaptive_localization {

/// A box of poses: indices of position and heading. Headings go round: 0 follows the last.
struct PoseBin {
  std::int32_t x;
  std::int32_t y;
  std::int32_t theta;
};

/// Counts the boxes that poses fall into and numbers them in the order of their first pose: the
/// histogram of KLD-sampling and of clustering. A hash set with open addressing, O(1) per pose.
class PoseBins {
 public:
  static constexpr int kNone = -1;

  /// Sides of a box in metres and radians; the angle is rounded so that boxes divide the circle.
  PoseBins(double side, double angle);

  /// The number of the pose's bin; a new one if it was empty.
  int add(const Pose2& pose) { return addBin(binOf(pose)); }

  /// The same for all particles, in their order: the number of each one's bin.
  std::vector<int> addAll(const Particles& particles);

  /// The number of a bin, kNone if no pose fell into it. Headings wrap.
  int find(PoseBin bin) const;

  int count() const { return static_cast<int>(bins_.size()); }
  const PoseBin& bin(int number) const { return bins_[static_cast<std::size_t>(number)]; }
  int headings() const { return headings_; }

 private:
  PoseBin binOf(const Pose2& pose) const;
  int addBin(const PoseBin& bin);
  std::size_t slotOf(const PoseBin& bin) const;
  void grow();

  double side_;
  int headings_;
  std::vector<PoseBin> bins_;
  std::vector<int> slots_;  // numbers of bins or kNone; a power of two of them
};

}  // namespace adaptive_localization
