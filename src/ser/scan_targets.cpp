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
    parts_.push_back(partsOf(group));
  }
}

/// Those that tell something, and one more where their number is odd.
ScanTargets::Parts ScanTargets::partsOf(int group) const {
  Parts parts;
  std::uint8_t idle = 0;
  for (std::uint8_t part = 0; part < RangeTarget::kParts; ++part) {
    const std::uint8_t* low = at(low_, group) + part * RangeTarget::kPart;
    const std::uint8_t* high = at(high_, group) + part * RangeTarget::kPart;
    bool tells = false;
    for (int i = 0; i < RangeTarget::kPart; ++i) tells |= low[i] > 0 || high[i] < kNoReturn;
    if (tells) {
      parts.numbers[static_cast<std::size_t>(parts.count++)] = part;
    } else {
      idle = part;
    }
  }
  if (parts.count % 2 != 0) parts.numbers[static_cast<std::size_t>(parts.count++)] = idle;
  return parts;
}

}  // namespace adaptive_localization
