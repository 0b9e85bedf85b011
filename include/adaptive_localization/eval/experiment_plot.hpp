// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "adaptive_localization/eval/experiment_summary.hpp"

namespace adaptive_localization {

/// Draws, for each case and core, which share of the trials was found after which time, and, beside
/// it, how many particles there were: two panels for each case that has trials. Throws
/// std::runtime_error naming the file that could not be written.
void savePlot(const std::vector<ExperimentSummary>& summaries, const std::string& file);

}  // namespace adaptive_localization
