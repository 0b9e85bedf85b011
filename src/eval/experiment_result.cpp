// SPDX-License-Identifier: BSD-3-Clause
#include "eval/experiment_result.hpp"

#include <stdexcept>

#include "json.hpp"

namespace adaptive_localization {
namespace {

using Json = nlohmann::json;

// These call item(key, member) for all members.

template <class Stored, class Item>
void visitTrial(Stored& trial, Item&& item) {
  item("kind", trial.kind);
  item("pose", trial.T_map_base);
  item("found_s", trial.found_s);
  item("told_s", trial.told_s);
  item("validated_s", trial.validated_s);
  item("wrongly_validated", trial.wrongly_validated);
  item("within_s", trial.within_s);
  item("left_s", trial.left_s);
  item("at", trial.at);
  item("scans", trial.scans);
  item("searching", trial.searching);
  item("searching_tracking", trial.searching_tracking);
  item("late_tracking", trial.late_tracking);
  item("searching_ambiguous", trial.searching_ambiguous);
  item("end_status", trial.end_status);
  item("end_error_m", trial.end_error_m);
  item("end_error_deg", trial.end_error_deg);
  item("is_silent_failure", trial.is_silent_failure);
}

template <class Stored, class Item>
void visitAccuracy(Stored& accuracy, Item&& item) {
  item("scans", accuracy.scans);
  item("mean_m", accuracy.mean_m);
  item("mean_deg", accuracy.mean_deg);
  item("normalized_mean", accuracy.normalized_mean);
  item("normalized", accuracy.normalized);
  item("scan_bound_m", accuracy.scan_bound_m);
  item("scan_bound_deg", accuracy.scan_bound_deg);
  item("drive_bound_m", accuracy.drive_bound_m);
  item("drive_bound_deg", accuracy.drive_bound_deg);
}

template <class Stored, class Item>
void visitResult(Stored& result, Item&& item) {
  item("experiment", result.id.experiment);
  item("case", result.id.of_case);
  item("label", result.id.label);
  item("seed", result.id.seed);
  item("settings", result.id.settings);
  item("filter", result.filter);
  item("preset", result.preset);
  item("duration_s", result.duration_s);
  item("scans", result.scans);
  item("updates", result.updates);
  item("settled_s", result.settled_s);
  item("left_tracking", result.left_tracking);
  item("false_jumps", result.false_jumps);
  item("jumps", result.jumps);
  item("silently_wrong", result.silently_wrong);
  item("silently_wrong_s", result.silently_wrong_s);
  item("carried", result.carried);
  item("carried_tracking", result.carried_tracking);
  item("carried_jumps", result.carried_jumps);
  item("status", result.status);
  item("first_mass", result.first_mass);
  item("second_mass", result.second_mass);
  item("has_both_at_end", result.has_both_at_end);
  item("calibration", result.calibration);
  item("rms_m", result.rms_m);
  item("rms_deg", result.rms_deg);
  item("max_m", result.max_m);
  item("probe_errors_m", result.probe_errors_m);
  item("arrival_errors_m", result.arrival_errors_m);
  item("way_error_m", result.way_error_m);
  item("particles_first", result.particles_first);
  item("particles_mean", result.particles_mean);
  item("particles_max", result.particles_max);
  item("particles_by_s", result.particles_by_s);
  item("looks_elsewhere", result.looks_elsewhere);
  item("update_ms_median", result.update_ms_median);
  item("update_ms_max", result.update_ms_max);
  item("both_share", result.both_share);
  item("accuracy", result.accuracy);
  item("trials", result.trials);
}

/// Writes a member.
auto into(Json& json) {
  return [&json](const char* key, const auto& value) { json[key] = value; };
}

}  // namespace

// By these names the JSON library finds them.

void to_json(Json& json, const Pose2& pose) {
  json = {pose.x, pose.y, pose.theta};
}

void to_json(Json& json, Trial::Kind kind) {
  json = toText(kind);
}

void to_json(Json& json, const Trial& trial) {
  visitTrial(trial, into(json));
}

void to_json(Json& json, const Accuracy& accuracy) {
  visitAccuracy(accuracy, into(json));
}

std::string toText(Trial::Kind kind) {
  switch (kind) {
    case Trial::Kind::kKnownStart:
      return "known start";
    case Trial::Kind::kWrongStart:
      return "wrong start";
    case Trial::Kind::kStart:
      return "start";
    default:
      return "kidnap";
  }
}

std::string toLine(const ExperimentResult& result) {
  Json json;
  visitResult(result, into(json));
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

RunId idOf(const std::string& line) {
  try {
    const Json json = Json::parse(line);
    return {json.at("experiment"), json.at("case"), json.at("label"), json.at("seed"),
            json.at("settings")};
  } catch (const std::exception& error) {
    throw std::invalid_argument(std::string("no result of an experiment: ") + error.what());
  }
}

}  // namespace adaptive_localization
