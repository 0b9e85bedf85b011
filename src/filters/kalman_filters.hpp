// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "adaptive_localization/filters/filter_registry.hpp"

namespace adaptive_localization {

/// ekf_icp, its options and presets.
FilterDescription ekfIcp();

}  // namespace adaptive_localization
