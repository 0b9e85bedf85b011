// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "adaptive_localization/filters/registries.hpp"

namespace adaptive_localization {

/// The cores that come with the package; the one list of their names.
std::vector<FilterDescription> builtinFilters();

}  // namespace adaptive_localization
