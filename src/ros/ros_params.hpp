// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include "adaptive_localization/core/options.hpp"

namespace adaptive_localization {

/// All parameters in a node handle's namespace. Lists and nested ones, which no option has, are
/// warned about and left out, and so is an initial pose or covariance that is NaN, as amcl saved
/// when it was stopped early.
Parameters readParameters(const ros::NodeHandle& node);

/// Says which given parameters have no effect: amcl's own that are not used in one line, others,
/// perhaps misspelt, as warnings by name, with the known one that is nearest.
void reportUnknown(const std::vector<std::string>& keys, const std::vector<std::string>& known);

/// Names those that have amcl's usual values, and leaves them out if amcl_compatibility says so.
Parameters withoutUntuned(const Parameters& given);

}  // namespace adaptive_localization
