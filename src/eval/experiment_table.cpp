// SPDX-License-Identifier: BSD-3-Clause
// A summary for people.
#include <algorithm>
#include <functional>
#include <iomanip>
#include <sstream>
#include <utility>

#include "adaptive_localization/eval/experiment_summary.hpp"

namespace adaptive_localization {
namespace {

std::string fixed(double value, int digits) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << value;
  return text.str();
}

std::string seconds(const std::optional<double>& time) {
  return time ? fixed(*time, 1) : "never";
}

std::string seconds(const std::optional<double>& median, const std::optional<double>& p95) {
  return seconds(median) + ", " + seconds(p95);
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

/// P(error < 0.3 m) in each, from the lowest confidence to the highest.
std::string tenths(const Calibration& calibration) {
  std::string text;
  for (const auto& share : calibration.shares()) {
    text += (text.empty() ? "" : " ") + (share ? fixed(*share, 2) : "–");
  }
  return text;
}

using Row = ExperimentSummary;
using Cell = std::function<std::string(const Row&)>;  // empty: nothing to say

std::vector<std::pair<std::string, Cell>> findingColumns() {
  return {
      {"found", [](const Row& r) { return countOf(r.found); }},
      {"95 % interval", [](const Row& r) { return interval(r.found); }},
      {"found after s: median, 95 %",
       [](const Row& r) { return r.found.of ? seconds(r.found_median_s, r.found_p95_s) : ""; }},
      {"told after s: median, 95 %",
       [](const Row& r) { return r.found.of ? seconds(r.told_median_s, r.told_p95_s) : ""; }},
      {"ambiguous before", [](const Row& r) { return countOf(r.ambiguous); }},
      {"found after s, where not ambiguous",
       [](const Row& r) {
         const bool is_else = r.ambiguous.count > 0 && r.ambiguous.count < r.ambiguous.of;
         return is_else ? seconds(r.clear_median_s, r.clear_p95_s) : "";
       }},
      {"scans that say tracking before: median, most",
       [](const Row& r) {
         if (r.found.of == 0) return std::string();
         return fixed(r.told_early_median, 0) + ", " + fixed(r.told_early_most, 0);
       }},
      {"in time", [](const Row& r) { return countOf(r.in_time); }},
      {"in time or flagged", [](const Row& r) { return countOf(r.in_time_or_flagged); }},
      {"right at the end", [](const Row& r) { return countOf(r.right_at_end); }},
      {"says tracking at the end, wrongly",
       [](const Row& r) { return countOf(r.silent_failures); }},
      {"left a known start", [](const Row& r) { return countOf(r.left); }},
  };
}

std::vector<std::pair<std::string, Cell>> honestyColumns() {
  return {
      {"says tracking, wrongly: of the scans, longest",
       [](const Row& r) {
         return percent(r.silently_wrong_share, 2) + ", " + fixed(r.silently_wrong_longest_s, 1) +
                " s";
       }},
      {"jumps per run", [](const Row& r) { return fixed(r.jumps_per_run, 2); }},
      {"near, by tenths of confidence", [](const Row& r) { return tenths(r.calibration); }},
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

/// A number of millimetres or degrees with those of the bounds; empty without bounds.
std::string besideBounds(double value, double factor, const std::optional<double>& of_scan,
                         const std::optional<double>& of_drive, int digits) {
  if (!of_scan || !of_drive) return "";
  return fixed(factor * value, digits) + "; " + fixed(factor * *of_scan, digits) + ", " +
         fixed(factor * *of_drive, digits);
}

std::vector<std::pair<std::string, Cell>> accuracyColumns() {
  return {
      {"mean error, mm (worst run), deg",
       [](const Row& r) {
         const auto& a = r.accuracy;
         if (!a.scan_bound_m) return std::string();
         return fixed(1e3 * a.mean_m, 1) + " (" + fixed(1e3 * a.worst_mean_m, 1) + "), " +
                fixed(a.mean_deg, 2);
       }},
      {"rms error, mm; bound of a scan, of the drive",
       [](const Row& r) {
         const auto& a = r.accuracy;
         return besideBounds(a.rms_m, 1e3, a.scan_bound_m, a.drive_bound_m, 1);
       }},
      {"rms error, deg; bound of a scan, of the drive",
       [](const Row& r) {
         const auto& a = r.accuracy;
         return besideBounds(a.rms_deg, 1.0, a.scan_bound_deg, a.drive_bound_deg, 3);
       }},
      {"NEES; 95 % band; seconds in it",
       [](const Row& r) {
         const auto& a = r.accuracy;
         if (!a.normalized || !a.scan_bound_m) return std::string();
         return fixed(*a.normalized, 2) + "; " + fixed(a.band.low, 2) + "–" +
                fixed(a.band.high, 2) + "; " + percent(a.seconds_in_band, 0);
       }},
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
      {"off the way-points, mm: median, 95 %, most; off the way, rms; way-points a minute",
       [](const Row& r) {
         if (r.arrivals_per_min == 0.0) return std::string();
         return fixed(1e3 * r.arrival_median_m, 0) + ", " + fixed(1e3 * r.arrival_95_m, 0) + ", " +
                fixed(1e3 * r.arrival_largest_m, 0) + "; " + fixed(1e3 * r.way_error_median_m, 0) +
                "; " + fixed(r.arrivals_per_min, 1);
       }},
      {"particles: first, mean, most",
       [](const Row& r) {
         return fixed(r.particles_first, 0) + ", " + fixed(r.particles_mean, 0) + ", " +
                std::to_string(r.particles_max);
       }},
      {"looks elsewhere per run",
       [](const Row& r) { return r.looks_elsewhere > 0.0 ? fixed(r.looks_elsewhere, 1) : ""; }},
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
  for (const auto& more : {findingColumns(), honestyColumns(), accuracyColumns(), costColumns()}) {
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

}  // namespace adaptive_localization
