// SPDX-License-Identifier: BSD-3-Clause
// How a summary is shown to people and to programs.
#include <algorithm>
#include <functional>
#include <iomanip>
#include <sstream>
#include <utility>

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

std::string percent(double share, int digits = 1) {
  return fixed(100.0 * share, digits) + " %";
}

std::string countOf(const Share& share) {
  return share.of > 0 ? std::to_string(share.count) + "/" + std::to_string(share.of) : "";
}

std::string interval(const Share& share) {
  return share.of > 0 ? fixed(100.0 * share.low, 1) + "–" + percent(share.high) : "";
}

using Row = ExperimentSummary;
using Cell = std::function<std::string(const Row&)>;  // empty: nothing to say

std::vector<std::pair<std::string, Cell>> findingColumns() {
  return {
      {"found", [](const Row& r) { return countOf(r.found); }},
      {"95 % interval", [](const Row& r) { return interval(r.found); }},
      {"found after s: median, 95 %",
       [](const Row& r) {
         return r.found.of ? seconds(r.found_median_s) + ", " + seconds(r.found_p95_s) : "";
       }},
      {"told after s: median, 95 %",
       [](const Row& r) {
         return r.found.of ? seconds(r.told_median_s) + ", " + seconds(r.told_p95_s) : "";
       }},
      {"ambiguous before", [](const Row& r) { return countOf(r.ambiguous); }},
      {"never says tracking before", [](const Row& r) { return countOf(r.flagged); }},
      {"says tracking at the end, wrongly",
       [](const Row& r) { return countOf(r.silent_failures); }},
  };
}

std::vector<std::pair<std::string, Cell>> honestyColumns() {
  return {
      {"says tracking, wrongly: of the scans, longest",
       [](const Row& r) {
         return percent(r.silently_wrong_share) + ", " + fixed(r.silently_wrong_longest_s, 1) +
                " s";
       }},
      {"while carried: says tracking, jumps",
       [](const Row& r) {
         if (r.carried == 0) return std::string();
         return percent(r.carried_tracking_share) + ", " + std::to_string(r.carried_jumps);
       }},
      {"false alarms: tracking left, jumps",
       [](const Row& r) {
         if (r.settled_h <= 0.0) return std::string();
         return std::to_string(r.left_tracking) + ", " + std::to_string(r.false_jumps) + " in " +
                fixed(r.settled_h, 2) + " h";
       }},
      {"both places at the end", [](const Row& r) { return countOf(r.both_at_end); }},
      {"both places: of the scans",
       [](const Row& r) { return r.both_at_end.of ? percent(r.both_share) : ""; }},
      {"says tracking: of the scans",
       [](const Row& r) { return r.both_at_end.of ? percent(r.tracking_share) : ""; }},
  };
}

std::vector<std::pair<std::string, Cell>> costColumns() {
  return {
      {"error, m",
       [](const Row& r) { return r.rms_median_m > 0.0 ? fixed(r.rms_median_m, 3) : ""; }},
      {"error at the moments, mm: mean (std)",
       [](const Row& r) {
         std::string text;
         for (std::size_t i = 0; i < r.probe_mean_m.size(); ++i) {
           text += (text.empty() ? "" : ", ") + fixed(1e3 * r.probe_mean_m[i], 0) + " (" +
                   fixed(1e3 * r.probe_std_m[i], 0) + ")";
         }
         return text;
       }},
      {"particles: first, mean, most",
       [](const Row& r) {
         return fixed(r.particles_first, 0) + ", " + fixed(r.particles_mean, 0) + ", " +
                std::to_string(r.particles_max);
       }},
      {"ms per update: median, most",
       [](const Row& r) {
         return fixed(r.update_ms_median, 2) + ", " + fixed(r.update_ms_max, 1);
       }},
  };
}

std::string toTable(const std::vector<const Row*>& rows) {
  std::vector<std::pair<std::string, Cell>> columns{
      {"case", [](const Row& r) { return r.of_case; }},
      {"core", [](const Row& r) { return r.label; }},
      {"runs", [](const Row& r) { return std::to_string(r.runs); }}};
  for (const auto& more : {findingColumns(), honestyColumns(), costColumns()}) {
    for (const auto& column : more) {
      const bool says_something = std::any_of(
          rows.begin(), rows.end(), [&](const Row* row) { return !column.second(*row).empty(); });
      if (says_something) columns.push_back(column);
    }
  }
  std::string head = "|", line = "|", body;
  for (const auto& [name, cell] : columns) {
    head += " " + name + " |";
    line += "---|";
  }
  for (const Row* row : rows) {
    body += "|";
    for (const auto& [name, cell] : columns) body += " " + cell(*row) + " |";
    body += "\n";
  }
  return rows.front()->experiment + ":\n\n" + head + "\n" + line + "\n" + body;
}

}  // namespace

std::string toTables(const std::vector<ExperimentSummary>& summaries) {
  std::string text;
  std::vector<const Row*> rows;
  for (std::size_t i = 0; i < summaries.size(); ++i) {
    rows.push_back(&summaries[i]);
    const bool is_last =
        i + 1 == summaries.size() || summaries[i + 1].experiment != summaries[i].experiment;
    if (!is_last) continue;
    text += (text.empty() ? "" : "\n") + toTable(rows);
    rows.clear();
  }
  return text;
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
