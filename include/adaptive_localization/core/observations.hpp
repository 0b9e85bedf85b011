// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "adaptive_localization/core/scan.hpp"

namespace adaptive_localization {

/// Where base points to in the map, as a compass tells.
struct Heading {
  double theta{0.0};      // rad
  double deviation{0.0};  // standard deviation, rad
};

/// All that was sensed at one instant. What was not sensed is empty.
struct Observations {
  double stamp{0.0};  // s
  Scan scan{};
  std::optional<Heading> heading{};
};

}  // namespace adaptive_localization
