// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/localizer/status.hpp"

namespace adaptive_localization {

std::string toText(Status status) {
  switch (status) {
    case Status::kGlobalizing:
      return "globalizing";
    case Status::kTracking:
      return "tracking";
    case Status::kAmbiguous:
      return "ambiguous";
    case Status::kLost:
      return "lost";
    default:
      return "uninitialised";
  }
}

}  // namespace adaptive_localization
