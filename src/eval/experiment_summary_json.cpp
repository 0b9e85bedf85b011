// SPDX-License-Identifier: BSD-3-Clause
// A summary for programs.
#include "adaptive_localization/eval/experiment_summary.hpp"
#include "json.hpp"

namespace adaptive_localization {
namespace {

using Json = nlohmann::json;

Json toJson(const AccuracySummary& accuracy) {
  Json json;
  json["runs"] = accuracy.runs;
  json["mean_m"] = accuracy.mean_m;
  json["mean_deg"] = accuracy.mean_deg;
  json["worst_mean_m"] = accuracy.worst_mean_m;
  json["rms_m"] = accuracy.rms_m;
  json["rms_deg"] = accuracy.rms_deg;
  json["bound_of_scan"] = {{"m", accuracy.scan_bound_m}, {"deg", accuracy.scan_bound_deg}};
  json["bound_of_drive"] = {{"m", accuracy.drive_bound_m}, {"deg", accuracy.drive_bound_deg}};
  json["nees"] = {{"mean", accuracy.normalized},
                  {"band", Json{accuracy.band.low, accuracy.band.high}},
                  {"seconds_in_band", accuracy.seconds_in_band}};
  return json;
}

}  // namespace

/// By this name the JSON library finds it.
void to_json(Json& json, const Share& share) {
  json = {{"count", share.count},
          {"of", share.of},
          {"share", share.value},
          {"low", share.low},
          {"high", share.high}};
}

nlohmann::json toJson(const ExperimentSummary& row) {
  Json json;
  json["experiment"] = row.experiment;
  json["case"] = row.of_case;
  json["core"] = row.label;
  json["filter"] = row.filter;
  json["preset"] = row.preset;
  json["runs"] = row.runs;
  json["found"] = row.found;
  json["found_s"] = {{"median", row.found_median_s}, {"p95", row.found_p95_s}};
  json["told_s"] = {{"median", row.told_median_s}, {"p95", row.told_p95_s}};
  json["silent_failures"] = row.silent_failures;
  json["found_clear_s"] = {{"median", row.clear_median_s}, {"p95", row.clear_p95_s}};
  json["in_time"] = row.in_time;
  json["in_time_or_flagged"] = row.in_time_or_flagged;
  json["right_at_end"] = row.right_at_end;
  json["left"] = row.left;
  json["told_early_scans"] = {{"median", row.told_early_median}, {"max", row.told_early_most}};
  json["always_flagged"] = row.flagged;
  json["ambiguous"] = row.ambiguous;
  json["false_alarms"] = {{"settled_h", row.settled_h},
                          {"left_tracking", row.left_tracking},
                          {"jumps", row.false_jumps}};
  json["jumps_per_run"] = row.jumps_per_run;
  json["silently_wrong"] = {{"share", row.silently_wrong_share},
                            {"longest_s", row.silently_wrong_longest_s}};
  json["calibration"] = row.calibration;
  json["calibration"]["share"] = row.calibration.shares();
  json["carried"] = {{"tracking_share", row.carried_tracking_share}, {"jumps", row.carried_jumps}};
  json["modes"] = {{"both_at_end", row.both_at_end},
                   {"both_share", row.both_share},
                   {"first_mass", row.first_mass},
                   {"second_mass", row.second_mass}};
  json["tracking_share"] = row.tracking_share;
  json["error"] = {{"rms_median_m", row.rms_median_m},
                   {"rms_median_deg", row.rms_median_deg},
                   {"max_m", row.max_m},
                   {"probe_mean_m", row.probe_mean_m},
                   {"probe_std_m", row.probe_std_m}};
  json["mission"] = {{"arrival_median_m", row.arrival_median_m},
                     {"arrival_95_m", row.arrival_95_m},
                     {"arrival_largest_m", row.arrival_largest_m},
                     {"arrivals_per_min", row.arrivals_per_min},
                     {"way_error_median_m", row.way_error_median_m}};
  json["accuracy"] = toJson(row.accuracy);
  json["particles"] = {{"first", row.particles_first},
                       {"mean", row.particles_mean},
                       {"max", row.particles_max},
                       {"by_s", row.particles_by_s}};
  json["looks_elsewhere"] = row.looks_elsewhere;
  json["update_ms"] = {{"median", row.update_ms_median}, {"max", row.update_ms_max}};
  return json;
}

}  // namespace adaptive_localization
