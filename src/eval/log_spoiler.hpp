// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "eval/damage.hpp"
#include "eval/log.hpp"

namespace adaptive_localization {

/// What odometry and scans in use suffer from.
const Damages<Log>& logDamages();

/// The same scans, stamped so many seconds later, or earlier: odometry and reference are those of
/// the new stamps. Scans for which there is no odometry then are left out.
Log restamped(Log log, double seconds);

/// The log made as poor as that; the same for the same seed. The reference stays true: of each scan
/// that is left, the pose at its stamp.
/// Throws std::invalid_argument listing the known kinds, or naming the amount's range.
Log spoil(const Log& log, const std::string& kind, double amount, std::uint64_t seed);

}  // namespace adaptive_localization
