// SPDX-License-Identifier: BSD-3-Clause
#include "eval/report.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "core/whole_file.hpp"
#include "json.hpp"

namespace adaptive_localization {
namespace {

/// All null without a reference.
nlohmann::json errorsToJson(const Metrics& metrics) {
  const auto error = [&](auto member) {
    return metrics.errors ? nlohmann::json((*metrics.errors).*member) : nlohmann::json();
  };

  nlohmann::json json;
  json["ate_rmse_m"] = error(&ErrorMetrics::ate_rmse_m);
  json["ate_mean_m"] = error(&ErrorMetrics::ate_mean_m);
  json["ate_median_m"] = error(&ErrorMetrics::ate_median_m);
  json["ate_p95_m"] = error(&ErrorMetrics::ate_p95_m);
  json["ate_max_m"] = error(&ErrorMetrics::ate_max_m);
  json["heading_rmse_deg"] = error(&ErrorMetrics::heading_rmse_deg);
  json["final_error_m"] = error(&ErrorMetrics::final_error_m);
  json["final_heading_error_deg"] = error(&ErrorMetrics::final_heading_error_deg);
  json["converged_at_s"] = error(&ErrorMetrics::converged_at_s);
  json["lost_share"] = error(&ErrorMetrics::lost_share);
  json["misled_share"] = error(&ErrorMetrics::misled_share);
  json["misled_longest_s"] = error(&ErrorMetrics::misled_longest_s);
  json["tracking_at_s"] = error(&ErrorMetrics::tracking_at_s);
  json["nees"] = {{"mean", error(&ErrorMetrics::nees_mean)},
                  {"median", error(&ErrorMetrics::nees_median)},
                  {"in_band", error(&ErrorMetrics::nees_in_band)}};
  json["calibration"] = error(&ErrorMetrics::calibration);
  json["carried"] = error(&ErrorMetrics::carryings);
  return json;
}

}  // namespace

nlohmann::json toJson(const RunDescription& description, const Metrics& metrics) {
  nlohmann::json json;
  json["log"] = description.log;
  json["map"] = description.map;
  json["filter"] = description.filter;
  json["start"] = description.start;
  json["spoil"] = description.spoil;
  json["spoil_seed"] = description.spoil_seed;
  json["mount"] = {description.mount.position.x(), description.mount.position.y(),
                   std::atan2(description.mount.axes(1, 0), description.mount.axes(0, 0))};
  json["seed"] = description.seed;
  json["threads"] = description.threads;
  json["scans"] = metrics.scans;
  json["updates"] = metrics.updates;
  json["duration_s"] = metrics.duration_s;
  json["path_m"] = metrics.path_m;
  json["wall_s"] = metrics.wall_s;
  json["cpu_s"] = metrics.cpu_s;
  json["peak_rss_mb"] = metrics.peak_rss_mb;
  json["update_ms"] = {{"median", metrics.update_ms_median},
                       {"p99", metrics.update_ms_p99},
                       {"max", metrics.update_ms_max},
                       {"first", metrics.update_ms_first},
                       {"longest_after_first", metrics.update_ms_longest}};
  json["update_cpu_ms"] = {{"median", metrics.update_cpu_ms_median},
                           {"mean", metrics.update_cpu_ms_mean}};
  json["particles"] = {{"mean", metrics.particles_mean}, {"max", metrics.particles_max}};
  json.update(errorsToJson(metrics));
  json["jumps"] = metrics.jumps;
  json["confidence_mean"] = metrics.confidence_mean;
  json["status"] = metrics.status;
  json["tracking_share"] = metrics.tracking_share;
  json["nowhere_share"] = metrics.nowhere_share;
  return json;
}

std::string summarize(const RunDescription& description, const Metrics& metrics) {
  std::ostringstream text;
  text << std::fixed << description.filter << ": " << metrics.scans << " scans, "
       << std::setprecision(0) << metrics.duration_s << " s, " << metrics.path_m << " m; ";
  if (!description.start.empty()) text << "started " << description.start << "; ";
  if (!description.spoil.empty()) text << "spoiled by " << description.spoil << "; ";
  if (metrics.errors) {
    text << std::setprecision(3) << "error " << metrics.errors->ate_rmse_m << " m rms, "
         << metrics.errors->ate_max_m << " m at most, " << std::setprecision(2)
         << metrics.errors->heading_rmse_deg << " deg rms, lost " << std::setprecision(1)
         << 100.0 * metrics.errors->lost_share << " % of the scans; "
         << toText(metrics.errors->carryings);
  } else {
    text << "no reference; ";
  }
  text << std::setprecision(2) << metrics.update_ms_median << " ms per update, "
       << std::setprecision(0) << metrics.particles_mean << " particles, " << std::setprecision(2)
       << "confidence " << metrics.confidence_mean;
  return text.str();
}

void saveScans(const RunRecord& run, const std::string& file) {
  std::ostringstream output;
  output << "stamp,x,y,yaw,deviation,status,confidence,fit,modes,particles,updated,update_ms,"
            "odom_x,odom_y,odom_yaw,reference_x,reference_y,reference_yaw\n"
         << std::setprecision(15);
  for (const RunStep& step : run.steps) {
    const Pose2& pose = step.T_map_base;
    output << step.stamp << ',' << pose.x << ',' << pose.y << ',' << pose.theta << ','
           << std::sqrt(std::max(0.0, step.covariance(0, 0) + step.covariance(1, 1))) << ','
           << toText(step.status) << ',' << step.confidence << ',' << step.fit << ',' << step.modes
           << ',' << step.particles << ',' << step.updated << ',' << step.update_ms << ','
           << step.T_odom_base.x << ',' << step.T_odom_base.y << ',' << step.T_odom_base.theta
           << ',';
    if (step.T_map_base_reference) {
      const Pose2& truth = *step.T_map_base_reference;
      output << truth.x << ',' << truth.y << ',' << truth.theta << '\n';
    } else {
      output << ",,\n";
    }
  }
  writeWholeFile(file, output.str());
}

nlohmann::json toJson(const std::vector<RunView>& views) {
  const auto rows = [](const Eigen::Array3Xd& columns) {
    nlohmann::json all = nlohmann::json::array();
    for (Eigen::Index i = 0; i < columns.cols(); ++i) {
      all.push_back({columns(0, i), columns(1, i), columns(2, i)});
    }
    return all;
  };
  nlohmann::json all = nlohmann::json::array();
  for (const RunView& view : views) {
    nlohmann::json modes = nlohmann::json::array();
    for (const Mode& mode : view.modes) {
      const Pose2& pose = mode.T_map_base;
      modes.push_back({pose.x, pose.y, pose.theta, mode.mass});
    }
    all.push_back({{"stamp", view.stamp},
                   {"modes", modes},
                   {"hits", rows(view.hits)},
                   {"particles", rows(view.particles)}});
  }
  return all;
}

void saveJson(const nlohmann::json& json, const std::string& file) {
  writeWholeFile(file, json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + '\n');
}

}  // namespace adaptive_localization
