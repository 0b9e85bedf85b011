// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "ser/range_table.hpp"
#include "ser/scan_energy.hpp"

namespace adaptive_localization {

/// A scan laid out as the rows of a range table are, once for each direction that its beam 0 may
/// point to: the range that each direction should have. As intervals, for groups of neighbouring
/// headings; [0, 255] where no beam tells anything.
class ScanTargets {
 public:
  /// Groups of `headings` directions each; a divisor of kDirections.
  ScanTargets(const DirectionalScan& scan, int headings);

  int size() const { return kDirections / headings_; }
  const std::uint8_t* low(int group) const { return at(low_, group); }
  const std::uint8_t* high(int group) const { return at(high_, group); }

 private:
  static const std::uint8_t* at(const std::vector<std::uint8_t>& ranges, int group) {
    return ranges.data() + static_cast<std::size_t>(group) * kRangeStride;
  }

  int headings_;
  std::vector<std::uint8_t> low_, high_;
};

}  // namespace adaptive_localization
