// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "adaptive_localization/core/options.hpp"

namespace adaptive_localization {

/// Of filter, laser and odometry, the parameters that have amcl's usual values: its defaults or
/// those of its example, amcl_diff.launch, from which launch files are copied. Most likely nobody
/// ever tuned them, and the defaults of this package are more accurate.
std::vector<std::string> untunedKeys(const Parameters& parameters);

/// What is left of parameters without these, if the option amcl_compatibility says so; a sentence
/// for the user where there are such, else an empty one.
struct TunedParameters {
  Parameters parameters;
  std::string remark;
};
TunedParameters tuned(const Parameters& given);

}  // namespace adaptive_localization
