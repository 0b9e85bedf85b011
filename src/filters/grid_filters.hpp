// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "adaptive_localization/filters/registries.hpp"

namespace adaptive_localization {

/// markov, its options and presets.
FilterDescription markov();

}  // namespace adaptive_localization
