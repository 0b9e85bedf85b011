// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <benchmark/benchmark.h>

#include <cstdint>

namespace adaptive_localization {

/// Says how many items each iteration deals with, and the time for one.
inline void countItems(benchmark::State& state, std::int64_t per_iteration) {
  state.SetItemsProcessed(state.iterations() * per_iteration);
  state.counters["per_item"] = benchmark::Counter(
      static_cast<double>(per_iteration),
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// Energy grids and the global search.
void registerPlaces();

/// Scan matching, by surfaces and by lines.
void registerMatches();

}  // namespace adaptive_localization
