// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "adaptive_localization/core/options.hpp"
#include "adaptive_localization/ser/ground.hpp"
#include "match/scan_matcher.hpp"

namespace adaptive_localization {

/// The ground's places, or places of one's own as the options say.
std::shared_ptr<Places> placesFor(const Ground& ground, const Parameters& given);

/// A matcher on the ground's surfaces, or on surfaces of its own. Throws as makeScanMatcher().
ScanMatcher scanMatcherFor(const Ground& ground, const MatchOptions& options);

}  // namespace adaptive_localization
