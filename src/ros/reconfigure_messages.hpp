// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <dynamic_reconfigure/Config.h>
#include <dynamic_reconfigure/ConfigDescription.h>

#include <map>
#include <string>
#include <vector>

#include "adaptive_localization/core/options.hpp"

namespace adaptive_localization {

using Values = std::map<std::string, OptionValue>;

/// The values that a message gives.
Values valuesOf(const dynamic_reconfigure::Config& message);

/// The values of options.
dynamic_reconfigure::Config toConfig(const std::vector<OptionDescription>& options);

/// Types, ranges, choices and meanings of options, whose values are the defaults; those for experts
/// in a group of their own.
dynamic_reconfigure::ConfigDescription toDescription(const std::vector<OptionDescription>& options);

}  // namespace adaptive_localization
