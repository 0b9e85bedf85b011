// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/eval/accuracy_summary.hpp"

#include <algorithm>

#include "adaptive_localization/eval/statistics.hpp"

namespace adaptive_localization {
namespace {

using Results = std::vector<ExperimentResult>;

/// None unless all have one.
std::optional<double> rmsOfAll(const Results& runs, std::optional<double> Accuracy::*bound) {
  std::vector<double> bounds;
  for (const auto& run : runs) {
    if (run.accuracy.*bound) bounds.push_back(*(run.accuracy.*bound));
  }
  if (runs.empty() || bounds.size() < runs.size()) return std::nullopt;
  return rootMeanSquare(bounds);
}

/// Of the seconds at which there is a normalised error, the share with a mean over the runs within
/// the band for their number.
double secondsInBand(const Results& runs) {
  std::size_t seconds = 0;
  for (const auto& run : runs) seconds = std::max(seconds, run.accuracy.normalized.size());
  int counted = 0;
  int inside = 0;
  for (std::size_t second = 0; second < seconds; ++second) {
    std::vector<double> errors;
    for (const auto& run : runs) {
      const auto& of_run = run.accuracy.normalized;
      if (second < of_run.size() && of_run[second]) errors.push_back(*of_run[second]);
    }
    if (errors.empty()) continue;
    ++counted;
    inside += consistencyBand(static_cast<int>(errors.size())).contains(mean(errors));
  }
  return counted > 0 ? static_cast<double>(inside) / counted : 0.0;
}

void addConsistency(const Results& runs, AccuracySummary& summary) {
  std::vector<double> errors;
  for (const auto& run : runs) {
    if (run.accuracy.normalized_mean) errors.push_back(*run.accuracy.normalized_mean);
  }
  if (errors.empty()) return;
  summary.normalized = mean(errors);
  summary.band = consistencyBand(static_cast<int>(errors.size()));
  summary.seconds_in_band = secondsInBand(runs);
}

}  // namespace

AccuracySummary summarizeAccuracy(const Results& all) {
  using R = ExperimentResult;
  const Results runs = those(all, [](const R& run) { return run.accuracy.scans > 0; });
  AccuracySummary summary;
  summary.runs = static_cast<int>(runs.size());
  const auto means = valuesOf(runs, [](const R& run) { return run.accuracy.mean_m; });
  summary.mean_m = mean(means);
  summary.worst_mean_m = largest(means);
  summary.mean_deg = mean(valuesOf(runs, [](const R& run) { return run.accuracy.mean_deg; }));
  summary.rms_m = rootMeanSquare(valuesOf(runs, &R::rms_m));
  summary.rms_deg = rootMeanSquare(valuesOf(runs, &R::rms_deg));
  summary.scan_bound_m = rmsOfAll(runs, &Accuracy::scan_bound_m);
  summary.scan_bound_deg = rmsOfAll(runs, &Accuracy::scan_bound_deg);
  summary.drive_bound_m = rmsOfAll(runs, &Accuracy::drive_bound_m);
  summary.drive_bound_deg = rmsOfAll(runs, &Accuracy::drive_bound_deg);
  addConsistency(runs, summary);
  return summary;
}

}  // namespace adaptive_localization
