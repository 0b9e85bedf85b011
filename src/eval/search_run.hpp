// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "eval/run.hpp"
#include "ser/places.hpp"

namespace adaptive_localization {

/// A place within this of the reference is the right one.
constexpr double kRightDistance = 0.5;                // m
constexpr double kRightHeading = 10.0 * kPi / 180.0;  // rad

/// How often single scans of a recording, each on its own and anywhere in the map, tell where they
/// were taken.
struct SearchMetrics {
  int scans{0};            // with a reference
  int right{0};            // the best place is the right one
  int among{0};            // one of the places is
  int ambiguous{0};        // more than one place was found
  int right_if_unique{0};  // of those that are not ambiguous
  int nowhere{0};          // no place was found
  double places_mean{0.0};
  double ms_median{0.0}, ms_p95{0.0}, ms_max{0.0};  // per search, without making the grid
};

/// Searches `count` scans evenly spread over the log, as many as it has at the most. Scans that
/// cannot be used, or have no reference, are left out; std::invalid_argument if all are.
SearchMetrics searchLog(const Log& log, Places& places, const ScanOptions& options, int count,
                        const RunProgress& progress = {});

nlohmann::json toJson(const SearchMetrics& metrics);

/// The same in one line for people.
std::string summarize(const SearchMetrics& metrics);

}  // namespace adaptive_localization
