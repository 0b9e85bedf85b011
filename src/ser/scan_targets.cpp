// SPDX-License-Identifier: BSD-3-Clause
#include "scan_targets.hpp"

#include <algorithm>
#include <array>

namespace adaptive_localization {

ScanTargets::ScanTargets(const DirectionalScan& scan, int headings)
    : headings_(headings),
      low_(static_cast<std::size_t>(size()) * kRangeStride, 0),
      high_(static_cast<std::size_t>(size()) * kRangeStride, kNoReturn) {
  constexpr int kRounds = 3;
  std::array<std::uint8_t, kRounds * kDirections> low, high;  // of the beams, thrice round
  for (std::size_t i = 0; i < low.size(); ++i) {
    const std::int16_t range = scan.range[i % kDirections];
    low[i] = static_cast<std::uint8_t>(range < 0 ? 0 : range);
    high[i] = static_cast<std::uint8_t>(range < 0 ? kNoReturn : range);
  }
  targets_.reserve(static_cast<std::size_t>(size()));
  for (int group = 0; group < size(); ++group) {
    std::uint8_t* group_low = low_.data() + static_cast<std::size_t>(group) * kRangeStride;
    std::uint8_t* group_high = high_.data() + static_cast<std::size_t>(group) * kRangeStride;
    for (int h = 0; h < headings; ++h) {
      const int first = 2 * kDirections - group * headings - h;  // beam of direction 0
      for (int d = 0; d < kDirections; ++d) {
        const auto beam = static_cast<std::size_t>(first + d);
        group_low[d] = h == 0 ? low[beam] : std::min(group_low[d], low[beam]);
        group_high[d] = h == 0 ? high[beam] : std::max(group_high[d], high[beam]);
      }
    }
    targets_.push_back(targetOf(group));
  }
}

/// Of parts those that tell something, and one more where their number is odd.
RangeTarget ScanTargets::targetOf(int group) const {
  RangeTarget target{at(low_, group), at(high_, group)};
  int idle = 0;
  for (int first = 0; first < static_cast<int>(kRangeStride); first += RangeTarget::kPart) {
    bool tells = false;
    for (int i = first; i < first + RangeTarget::kPart; ++i) {
      tells |= target.low[i] > 0 || target.high[i] < kNoReturn;
    }
    if (tells) {
      target.parts[static_cast<std::size_t>(target.count++)] = first;
    } else {
      idle = first;
    }
  }
  if (target.count % 2 != 0) target.parts[static_cast<std::size_t>(target.count++)] = idle;
  return target;
}

}  // namespace adaptive_localization
