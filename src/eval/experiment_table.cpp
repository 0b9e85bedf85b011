// SPDX-License-Identifier: BSD-3-Clause
// How a summary is shown to people and to programs.
#include <iomanip>
#include <sstream>

#include "adaptive_localization/eval/experiment_summary.hpp"

namespace adaptive_localization {
namespace {

using Json = nlohmann::ordered_json;

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

std::string fixed(double value, int digits) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << value;
  return text.str();
}

std::string seconds(const std::optional<double>& time) {
  return time ? fixed(*time, 1) : "never";
}

std::string percent(const Share& share) {
  return share.of > 0 ? fixed(100.0 * share.low, 1) + "–" + fixed(100.0 * share.high, 1) + " %"
                      : "";
}

std::string countOf(const Share& share) {
  return share.of > 0 ? std::to_string(share.count) + "/" + std::to_string(share.of) : "";
}

std::string pair(const Share& trials, const std::optional<double>& median,
                 const std::optional<double>& p95) {
  return trials.of > 0 ? seconds(median) + ", " + seconds(p95) : "";
}

}  // namespace

std::string toTable(const std::vector<ExperimentSummary>& summaries) {
  std::ostringstream table;
  table << "| experiment | case | core | runs | found | 95 % interval | found after s: median, p95 "
           "| told after s: median, p95 | fails silently | wrong in silence: share, longest s "
           "| false alarms: left, jumps in h | ambiguous | error m | particles: first, mean, max "
           "| ms per update: median, max |\n"
           "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  for (const auto& row : summaries) {
    table << "| " << row.experiment << " | " << row.of_case << " | " << row.label << " | "
          << row.runs << " | " << countOf(row.found) << " | " << percent(row.found) << " | "
          << pair(row.found, row.found_median_s, row.found_p95_s) << " | "
          << pair(row.found, row.told_median_s, row.told_p95_s) << " | "
          << countOf(row.silent_failures) << " | " << fixed(100.0 * row.silently_wrong_share, 1)
          << " %, " << fixed(row.silently_wrong_longest_s, 1) << " | " << row.left_tracking << ", "
          << row.false_jumps << " in " << fixed(row.settled_h, 2) << " | " << countOf(row.ambiguous)
          << " | " << fixed(row.rms_median_m, 3) << " | " << fixed(row.particles_first, 0) << ", "
          << fixed(row.particles_mean, 0) << ", " << row.particles_max << " | "
          << fixed(row.update_ms_median, 2) << ", " << fixed(row.update_ms_max, 1) << " |\n";
  }
  return table.str();
}

nlohmann::ordered_json toJson(const ExperimentSummary& row) {
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
  json["particles"]["first"] = row.particles_first;
  json["particles"]["mean"] = row.particles_mean;
  json["particles"]["max"] = row.particles_max;
  json["update_ms"]["median"] = row.update_ms_median;
  json["update_ms"]["max"] = row.update_ms_max;
  return json;
}

}  // namespace adaptive_localization
