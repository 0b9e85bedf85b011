// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "adaptive_localization/core/options.hpp"

namespace adaptive_localization {

/// Throws std::invalid_argument for an option of this package that is no more, naming it and what
/// does its work now: another option, or a constant.
void refuseFormerOptions(const Parameters& parameters);

}  // namespace adaptive_localization
