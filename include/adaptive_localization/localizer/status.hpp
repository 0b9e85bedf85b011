// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace adaptive_localization {

/// What is known of the robot's place, in a word. Globalizing: it is being looked for, or there is
/// an initial pose that no scan has verified yet.
enum class Status { kUninitialised, kGlobalizing, kTracking, kAmbiguous, kLost };
std::string toText(Status status);

}  // namespace adaptive_localization
