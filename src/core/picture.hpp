// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "adaptive_localization/core/observations.hpp"

namespace adaptive_localization {

/// What was sighted at one instant, from where base was then.
struct Picture {
  double stamp{0.0};  // s
  std::vector<Sighting> sightings;
};

}  // namespace adaptive_localization
