// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/eval/experiment_summary.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <tuple>

#include "adaptive_localization/eval/metrics.hpp"

namespace adaptive_localization {
namespace {

using Results = std::vector<ExperimentResult>;
constexpr double kNever = std::numeric_limits<double>::infinity();

auto rowOf(const ExperimentResult& result) {
  return std::tie(result.id.experiment, result.id.of_case, result.id.label);
}

bool isBefore(const ExperimentResult& a, const ExperimentResult& b) {
  return std::make_pair(rowOf(a), a.id.seed) < std::make_pair(rowOf(b), b.id.seed);
}

bool isSameRun(const ExperimentResult& a, const ExperimentResult& b) {
  return rowOf(a) == rowOf(b) && a.id.seed == b.id.seed;
}

/// Those of known starts, or all others.
std::vector<Trial> trialsOf(const Results& results, bool is_known) {
  std::vector<Trial> trials;
  for (const auto& result : results) {
    for (const auto& trial : result.trials) {
      if ((trial.kind == Trial::Kind::kKnownStart) == is_known) trials.push_back(trial);
    }
  }
  return trials;
}

template <class Item, class Predicate>
Share shareOf(const std::vector<Item>& items, const Predicate& holds) {
  const auto count = std::count_if(items.begin(), items.end(), holds);
  return wilson(static_cast<int>(count), static_cast<int>(items.size()));
}

/// The smallest value that at least this share of all reach; without interpolation, since between a
/// number and never there is nothing.
std::optional<double> timeOf(std::vector<double> times, double share) {
  if (times.empty()) return std::nullopt;
  std::sort(times.begin(), times.end());
  const double rank = std::ceil(share * static_cast<double>(times.size()) - 1e-9);
  const double time = times[static_cast<std::size_t>(std::max(rank, 1.0)) - 1];
  if (time == kNever) return std::nullopt;
  return time;
}

void addTrials(const std::vector<Trial>& trials, ExperimentSummary& row) {
  const auto found = valuesOf(trials, [](const Trial& t) { return t.found_s.value_or(kNever); });
  const auto told = valuesOf(trials, [](const Trial& t) { return t.told_s.value_or(kNever); });
  row.found = shareOf(trials, [](const Trial& t) { return t.found_s.has_value(); });
  row.found_median_s = timeOf(found, 0.5);
  row.found_p95_s = timeOf(found, 0.95);
  std::vector<double> clear;
  for (const auto& trial : trials) {
    if (trial.searching_ambiguous == 0) clear.push_back(trial.found_s.value_or(kNever));
  }
  row.clear_median_s = timeOf(clear, 0.5);
  row.clear_p95_s = timeOf(clear, 0.95);
  row.told_median_s = timeOf(told, 0.5);
  row.told_p95_s = timeOf(told, 0.95);
  std::copy_if(found.begin(), found.end(), std::back_inserter(row.found_s),
               [](double time) { return time < kNever; });
  std::sort(row.found_s.begin(), row.found_s.end());
  row.right_at_end = shareOf(trials, [](const Trial& t) {
    return t.end_error_m < kLostDistance && t.end_error_deg < kLostHeading * 180.0 / kPi;
  });
  const auto limited = those(trials, [](const Trial& t) { return t.within_s.has_value(); });
  const auto in_time = [](const Trial& t) { return t.found_s && *t.found_s <= *t.within_s; };
  row.in_time = shareOf(limited, in_time);
  row.in_time_or_flagged =
      shareOf(limited, [&](const Trial& t) { return in_time(t) || t.late_tracking == 0; });
  const auto early = valuesOf(trials, &Trial::searching_tracking);
  row.told_early_median = quantile(early, 0.5);
  row.told_early_most = largest(early);
  row.silent_failures = shareOf(trials, [](const Trial& t) { return t.is_silent_failure; });
  row.flagged = shareOf(trials, [](const Trial& t) { return t.searching_tracking == 0; });
  row.ambiguous = shareOf(trials, [](const Trial& t) { return t.searching_ambiguous > 0; });
}

void addHonesty(const Results& runs, ExperimentSummary& row) {
  const auto total = [&](auto member) { return sum(valuesOf(runs, member)); };
  const auto share = [](double part, double whole) { return whole > 0.0 ? part / whole : 0.0; };
  using R = ExperimentResult;
  const double scans = total(&R::scans);
  row.settled_h = total(&R::settled_s) / 3600.0;
  row.left_tracking = static_cast<int>(total(&R::left_tracking));
  row.false_jumps = static_cast<int>(total(&R::false_jumps));
  row.jumps_per_run = share(total(&R::jumps), row.runs);
  row.silently_wrong_share = share(total(&R::silently_wrong), scans);
  row.silently_wrong_longest_s = largest(valuesOf(runs, &R::silently_wrong_s));
  for (const auto& run : runs) row.calibration.add(run.calibration);
  row.carried = static_cast<int>(total(&R::carried));
  row.carried_tracking_share = share(total(&R::carried_tracking), total(&R::carried));
  row.carried_jumps = static_cast<int>(total(&R::carried_jumps));
  const auto tracking = [](const R& run) {
    const auto found = run.status.find("tracking");
    return found == run.status.end() ? 0 : found->second;
  };
  row.tracking_share = share(sum(valuesOf(runs, tracking)), scans);
}

void addModes(const Results& runs, ExperimentSummary& row) {
  using R = ExperimentResult;
  const Results turned = those(runs, [](const R& run) { return run.both_share.has_value(); });
  row.both_at_end = shareOf(turned, [](const R& run) { return run.has_both_at_end; });
  row.both_share = mean(valuesOf(turned, [](const R& run) { return *run.both_share; }));
  const Results ambiguous =
      those(runs, [](const R& run) { return run.status.count("ambiguous") > 0; });
  row.first_mass = mean(valuesOf(ambiguous, &R::first_mass));
  row.second_mass = mean(valuesOf(ambiguous, &R::second_mass));
}

void addErrors(const Results& runs, ExperimentSummary& row) {
  using R = ExperimentResult;
  row.rms_median_m = quantile(valuesOf(runs, &R::rms_m), 0.5);
  row.rms_median_deg = quantile(valuesOf(runs, &R::rms_deg), 0.5);
  row.max_m = largest(valuesOf(runs, &R::max_m));
  for (std::size_t i = 0; i < runs.front().probe_errors_m.size(); ++i) {
    std::vector<double> errors;
    for (const auto& run : runs) {
      if (i < run.probe_errors_m.size()) errors.push_back(run.probe_errors_m[i]);
    }
    row.probe_mean_m.push_back(mean(errors));
    row.probe_std_m.push_back(deviation(errors));
  }
}

void addMission(const Results& runs, ExperimentSummary& row) {
  using R = ExperimentResult;
  std::vector<double> errors;
  for (const auto& run : runs) {
    errors.insert(errors.end(), run.arrival_errors_m.begin(), run.arrival_errors_m.end());
  }
  if (errors.empty()) return;
  row.arrivals_per_min =
      60.0 * static_cast<double>(errors.size()) / sum(valuesOf(runs, &R::duration_s));
  row.arrival_median_m = quantile(errors, 0.5);
  row.arrival_95_m = quantile(errors, 0.95);
  row.arrival_largest_m = largest(errors);
  row.way_error_median_m = quantile(valuesOf(runs, &R::way_error_m), 0.5);
}

void addEffort(const Results& runs, ExperimentSummary& row) {
  using R = ExperimentResult;
  row.particles_first = mean(valuesOf(runs, &R::particles_first));
  row.particles_mean = mean(valuesOf(runs, &R::particles_mean));
  row.particles_max = static_cast<int>(largest(valuesOf(runs, &R::particles_max)));
  row.looks_elsewhere = mean(valuesOf(runs, &R::looks_elsewhere));
  const auto lasts = [](const R& run) { return run.particles_by_s.size(); };
  const auto seconds = static_cast<std::size_t>(largest(valuesOf(runs, lasts)));
  for (std::size_t i = 0; i < seconds; ++i) {
    const Results longer = those(runs, [&](const R& run) { return run.particles_by_s.size() > i; });
    row.particles_by_s.push_back(
        mean(valuesOf(longer, [&](const R& run) { return run.particles_by_s[i]; })));
  }
  row.update_ms_median = quantile(valuesOf(runs, &R::update_ms_median), 0.5);
  row.update_ms_max = largest(valuesOf(runs, &R::update_ms_max));
}

ExperimentSummary summarizeRow(const Results& runs) {
  const ExperimentResult& first = runs.front();
  for (const auto& run : runs) {
    if (run.id.settings == first.id.settings) continue;
    throw std::invalid_argument("results of " + first.id.name() +
                                " were made with different settings");
  }
  ExperimentSummary row;
  row.experiment = first.id.experiment;
  row.of_case = first.id.of_case;
  row.label = first.id.label;
  row.filter = first.filter;
  row.preset = first.preset;
  row.runs = static_cast<int>(runs.size());
  addTrials(trialsOf(runs, false), row);
  row.left = shareOf(trialsOf(runs, true), [](const Trial& t) { return t.left_s.has_value(); });
  addHonesty(runs, row);
  addModes(runs, row);
  addErrors(runs, row);
  row.accuracy = summarizeAccuracy(runs);
  addMission(runs, row);
  addEffort(runs, row);
  return row;
}

}  // namespace

std::vector<ExperimentSummary> summarize(std::vector<ExperimentResult> results) {
  std::stable_sort(results.begin(), results.end(), isBefore);
  std::vector<ExperimentSummary> rows;
  for (auto begin = results.begin(); begin != results.end();) {
    const auto end = std::find_if(
        begin, results.end(), [&](const auto& result) { return rowOf(result) != rowOf(*begin); });
    Results runs;
    std::unique_copy(begin, end, std::back_inserter(runs), isSameRun);
    rows.push_back(summarizeRow(runs));
    begin = end;
  }
  return rows;
}

}  // namespace adaptive_localization
