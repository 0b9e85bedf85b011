// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace adaptive_localization {

/// Whom an option is for.
enum class Audience {
  kUsers,    // what a robot and its place need
  kAmcl,     // amcl's own names
  kExperts,  // how an algorithm works; the defaults are measured, and serve all
};

/// Options that are not known here, of plug-ins, are for experts.
Audience audienceOf(const std::string& option);

}  // namespace adaptive_localization
