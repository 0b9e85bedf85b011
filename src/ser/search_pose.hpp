// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>

namespace adaptive_localization {

/// A pose of the search's lattice: a cell of the range table and the direction of beam 0.
struct SearchPose {
  std::uint32_t cell;
  int direction;
  int cost;  // sum over beams of the truncated range error, in steps
};

/// Work that may still be done, counted in poses looked at, which take some 25 ns each: the same on
/// every machine, so that the same is found.
using SearchWork = std::int64_t;
constexpr SearchWork kUnlimitedWork = std::numeric_limits<SearchWork>::max();

}  // namespace adaptive_localization
