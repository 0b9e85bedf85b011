// SPDX-License-Identifier: BSD-3-Clause
#include "scan_targets.hpp"

#include <algorithm>

namespace adaptive_localization {

ScanTargets::ScanTargets(const DirectionalScan& scan, int headings)
    : headings_(headings),
      low_(static_cast<std::size_t>(size()) * kRangeStride, 0),
      high_(static_cast<std::size_t>(size()) * kRangeStride, kNoReturn) {
  for (int group = 0; group < size(); ++group) {
    for (int d = 0; d < kDirections; ++d) {
      std::int16_t low = kNoReturn;
      std::int16_t high = 0;
      for (int h = 0; h < headings; ++h) {
        const int beam = (d - group * headings - h + 2 * kDirections) % kDirections;
        const std::int16_t range = scan.range[static_cast<std::size_t>(beam)];
        low = std::min<std::int16_t>(low, range < 0 ? std::int16_t{0} : range);
        high = std::max<std::int16_t>(high, range < 0 ? std::int16_t{kNoReturn} : range);
      }
      const std::size_t i =
          static_cast<std::size_t>(group) * kRangeStride + static_cast<std::size_t>(d);
      low_[i] = static_cast<std::uint8_t>(low);
      high_[i] = static_cast<std::uint8_t>(high);
    }
  }
}

}  // namespace adaptive_localization
