// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/localizer/usual_error.hpp"

namespace adaptive_localization {

UsualError::UsualError(const DistanceField& field) {
  constexpr double kGoodMap = 0.05;  // m
  constexpr double kPoorMap = 0.2;   // m, at the most: maps painted from plans have solid walls
  const double extra = 0.5 * field.wallDepth() - field.lattice().resolution();
  value_ = std::clamp(kGoodMap + extra, kGoodMap, kPoorMap);
}

}  // namespace adaptive_localization
