// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "adaptive_localization/core/scan.hpp"

namespace adaptive_localization {

/// All that was sensed at one instant.
struct Observations {
  double stamp{0.0};  // s
  Scan scan;
};

}  // namespace adaptive_localization
