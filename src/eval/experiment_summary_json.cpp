// SPDX-License-Identifier: BSD-3-Clause
// A summary for programs.
#include "adaptive_localization/eval/experiment_summary.hpp"

namespace adaptive_localization {
namespace {

using Json = nlohmann::json;

Json toJson(const std::optional<double>& value) {
  return value ? Json(*value) : Json();
}

Json toJson(const Share& share) {
  Json json;
  json["count"] = share.count;
  json["of"] = share.of;
  json["share"] = share.value;
  json["low"] = share.low;
  json["high"] = share.high;
  return json;
}

Json toJson(const AccuracySummary& accuracy) {
  Json json;
  json["runs"] = accuracy.runs;
  json["mean_m"] = accuracy.mean_m;
  json["mean_deg"] = accuracy.mean_deg;
  json["worst_mean_m"] = accuracy.worst_mean_m;
  json["rms_m"] = accuracy.rms_m;
  json["rms_deg"] = accuracy.rms_deg;
  json["bound_of_scan"]["m"] = toJson(accuracy.scan_bound_m);
  json["bound_of_scan"]["deg"] = toJson(accuracy.scan_bound_deg);
  json["bound_of_drive"]["m"] = toJson(accuracy.drive_bound_m);
  json["bound_of_drive"]["deg"] = toJson(accuracy.drive_bound_deg);
  json["nees"]["mean"] = toJson(accuracy.normalized);
  json["nees"]["band"] = {accuracy.band.low, accuracy.band.high};
  json["nees"]["seconds_in_band"] = accuracy.seconds_in_band;
  return json;
}

}  // namespace

nlohmann::json toJson(const ExperimentSummary& row) {
  Json json;
  json["experiment"] = row.experiment;
  json["case"] = row.of_case;
  json["core"] = row.label;
  json["filter"] = row.filter;
  json["preset"] = row.preset;
  json["runs"] = row.runs;
  json["found"] = toJson(row.found);
  json["found_s"]["median"] = toJson(row.found_median_s);
  json["found_s"]["p95"] = toJson(row.found_p95_s);
  json["told_s"]["median"] = toJson(row.told_median_s);
  json["told_s"]["p95"] = toJson(row.told_p95_s);
  json["silent_failures"] = toJson(row.silent_failures);
  json["found_clear_s"]["median"] = toJson(row.clear_median_s);
  json["found_clear_s"]["p95"] = toJson(row.clear_p95_s);
  json["in_time"] = toJson(row.in_time);
  json["in_time_or_flagged"] = toJson(row.in_time_or_flagged);
  json["right_at_end"] = toJson(row.right_at_end);
  json["told_early_scans"]["median"] = row.told_early_median;
  json["told_early_scans"]["max"] = row.told_early_most;
  json["always_flagged"] = toJson(row.flagged);
  json["ambiguous"] = toJson(row.ambiguous);
  json["false_alarms"]["settled_h"] = row.settled_h;
  json["false_alarms"]["left_tracking"] = row.left_tracking;
  json["false_alarms"]["jumps"] = row.false_jumps;
  json["jumps_per_run"] = row.jumps_per_run;
  json["silently_wrong"]["share"] = row.silently_wrong_share;
  json["silently_wrong"]["longest_s"] = row.silently_wrong_longest_s;
  json["carried"]["tracking_share"] = row.carried_tracking_share;
  json["carried"]["jumps"] = row.carried_jumps;
  json["modes"]["both_at_end"] = toJson(row.both_at_end);
  json["modes"]["both_share"] = row.both_share;
  json["modes"]["first_mass"] = row.first_mass;
  json["modes"]["second_mass"] = row.second_mass;
  json["tracking_share"] = row.tracking_share;
  json["error"]["rms_median_m"] = row.rms_median_m;
  json["error"]["rms_median_deg"] = row.rms_median_deg;
  json["error"]["max_m"] = row.max_m;
  json["error"]["probe_mean_m"] = row.probe_mean_m;
  json["error"]["probe_std_m"] = row.probe_std_m;
  json["accuracy"] = toJson(row.accuracy);
  json["particles"]["first"] = row.particles_first;
  json["particles"]["mean"] = row.particles_mean;
  json["particles"]["max"] = row.particles_max;
  json["update_ms"]["median"] = row.update_ms_median;
  json["update_ms"]["max"] = row.update_ms_max;
  return json;
}

}  // namespace adaptive_localization
