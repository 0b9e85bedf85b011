// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace adaptive_localization {

/// Red, green and blue, each in [0, 1].
struct Rgb {
  float red, green, blue;
};

// Of the markers that the node publishes; the panel's legend says what they mean.
constexpr Rgb kFittingHit{0.0F, 0.6F, 0.0F};
constexpr Rgb kOtherHit{0.9F, 0.0F, 0.7F};
constexpr Rgb kRefusedMatch{0.9F, 0.7F, 0.0F};
constexpr Rgb kKnownLandmark{0.1F, 0.3F, 0.9F};
constexpr Rgb kLandmarkSighting{0.9F, 0.6F, 0.1F};

}  // namespace adaptive_localization
