// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/eval/accuracy_summary.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace adaptive_localization {
namespace {

using Results = std::vector<ExperimentResult>;

template <class Get>
double meanOf(const Results& runs, const Get& get) {
  double sum = 0.0;
  for (const auto& run : runs) sum += get(run);
  return runs.empty() ? 0.0 : sum / static_cast<double>(runs.size());
}

template <class Get>
double rmsOf(const Results& runs, const Get& get) {
  return std::sqrt(meanOf(runs, [&](const ExperimentResult& run) { return get(run) * get(run); }));
}

std::optional<double> rmsOfAll(const Results& runs, std::optional<double> Accuracy::*bound) {
  const bool have_all = std::all_of(runs.begin(), runs.end(), [&](const ExperimentResult& run) {
    return (run.accuracy.*bound).has_value();
  });
  if (runs.empty() || !have_all) return std::nullopt;
  return rmsOf(runs, [&](const ExperimentResult& run) { return *(run.accuracy.*bound); });
}

/// Of the seconds at which there is a normalised error, the share with a mean over the runs within
/// the band for their number.
double secondsInBand(const Results& runs) {
  std::size_t seconds = 0;
  for (const auto& run : runs) seconds = std::max(seconds, run.accuracy.normalized.size());
  int counted = 0;
  int inside = 0;
  for (std::size_t second = 0; second < seconds; ++second) {
    double sum = 0.0;
    int count = 0;
    for (const auto& run : runs) {
      const auto& errors = run.accuracy.normalized;
      if (second >= errors.size() || !errors[second]) continue;
      sum += *errors[second];
      ++count;
    }
    if (count == 0) continue;
    ++counted;
    inside += consistencyBand(count).contains(sum / count);
  }
  return counted > 0 ? static_cast<double>(inside) / counted : 0.0;
}

void addConsistency(const Results& runs, AccuracySummary& summary) {
  Results judged;
  std::copy_if(
      runs.begin(), runs.end(), std::back_inserter(judged),
      [](const ExperimentResult& run) { return run.accuracy.normalized_mean.has_value(); });
  if (judged.empty()) return;
  summary.normalized =
      meanOf(judged, [](const ExperimentResult& run) { return *run.accuracy.normalized_mean; });
  summary.band = consistencyBand(static_cast<int>(judged.size()));
  summary.seconds_in_band = secondsInBand(judged);
}

}  // namespace

AccuracySummary summarizeAccuracy(const Results& all) {
  using R = ExperimentResult;
  Results runs;
  std::copy_if(all.begin(), all.end(), std::back_inserter(runs),
               [](const R& run) { return run.accuracy.scans > 0; });
  AccuracySummary summary;
  summary.runs = static_cast<int>(runs.size());
  summary.mean_m = meanOf(runs, [](const R& run) { return run.accuracy.mean_m; });
  summary.mean_deg = meanOf(runs, [](const R& run) { return run.accuracy.mean_deg; });
  for (const auto& run : runs) {
    summary.worst_mean_m = std::max(summary.worst_mean_m, run.accuracy.mean_m);
  }
  summary.rms_m = rmsOf(runs, [](const R& run) { return run.rms_m; });
  summary.rms_deg = rmsOf(runs, [](const R& run) { return run.rms_deg; });
  summary.scan_bound_m = rmsOfAll(runs, &Accuracy::scan_bound_m);
  summary.scan_bound_deg = rmsOfAll(runs, &Accuracy::scan_bound_deg);
  summary.drive_bound_m = rmsOfAll(runs, &Accuracy::drive_bound_m);
  summary.drive_bound_deg = rmsOfAll(runs, &Accuracy::drive_bound_deg);
  addConsistency(runs, summary);
  return summary;
}

}  // namespace adaptive_localization
