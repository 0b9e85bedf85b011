// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "adaptive_localization/filters/registries.hpp"

namespace adaptive_localization {

/// ekf_icp, its options and presets.
FilterDescription ekfIcp();

}  // namespace adaptive_localization
