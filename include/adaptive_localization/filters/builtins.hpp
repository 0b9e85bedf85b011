// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "adaptive_localization/filters/registries.hpp"

namespace adaptive_localization {

/// What comes with the package.
const Registries& builtins();

}  // namespace adaptive_localization
