// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace adaptive_localization {

/// The value that a chi-square variable with so many degrees of freedom stays below with a
/// probability in [0, 1]: the gate of a squared Mahalanobis distance. Infinity for 1.
double chiSquare(int degrees, double probability);

}  // namespace adaptive_localization
