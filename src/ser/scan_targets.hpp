// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "range_kernel.hpp"
#include "ser/scan_energy.hpp"

namespace adaptive_localization {

/// A scan laid out as the rows of a range table are, once for each direction that its beam 0 may
/// point to: the range that each direction should have. As intervals, for groups of neighbouring
/// headings; [0, 255] where no beam tells anything.
class ScanTargets {
 public:
  /// Groups of `headings` directions each; a divisor of kDirections.
  ScanTargets(const DirectionalScan& scan, int headings);
  ScanTargets(const ScanTargets&) = delete;
  ScanTargets& operator=(const ScanTargets&) = delete;

  int size() const { return kDirections / headings_; }
  const RangeTarget& of(int group) const { return targets_[static_cast<std::size_t>(group)]; }

 private:
  static const std::uint8_t* at(const std::vector<std::uint8_t>& ranges, int group) {
    return ranges.data() + static_cast<std::size_t>(group) * kRangeStride;
  }

  RangeTarget targetOf(int group) const;

  int headings_;
  std::vector<std::uint8_t> low_, high_;
  std::vector<RangeTarget> targets_;  // of each group, with ranges of those
};

}  // namespace adaptive_localization
