// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/eval/experiment_result.hpp"

#include <nlohmann/json.hpp>
#include <stdexcept>

namespace adaptive_localization {
namespace {

using Json = nlohmann::json;

Json toJson(const std::optional<double>& value) {
  return value ? Json(*value) : Json();
}

std::optional<double> toOptional(const Json& json) {
  if (json.is_null()) return std::nullopt;
  return json.get<double>();
}

/// Calls item(key, member) for all members that are stored under their own names, so that they are
/// named in one place for writing and for reading.
template <class Stored, class Item>
void visit(Stored& result, Item&& item) {
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
  item("rms_m", result.rms_m);
  item("rms_deg", result.rms_deg);
  item("max_m", result.max_m);
  item("probe_errors_m", result.probe_errors_m);
  item("particles_first", result.particles_first);
  item("particles_mean", result.particles_mean);
  item("particles_max", result.particles_max);
  item("update_ms_median", result.update_ms_median);
  item("update_ms_max", result.update_ms_max);
}

template <class Stored, class Item>
void visitTrial(Stored& trial, Item&& item) {
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

Json toJson(const Trial& trial) {
  Json json;
  json["kind"] = toText(trial.kind);
  json["pose"] = {trial.T_map_base.x, trial.T_map_base.y, trial.T_map_base.theta};
  json["found_s"] = toJson(trial.found_s);
  json["told_s"] = toJson(trial.told_s);
  json["within_s"] = toJson(trial.within_s);
  visitTrial(trial, [&](const char* key, const auto& value) { json[key] = value; });
  return json;
}

/// Calls item(key, member) for all that may be missing.
template <class Stored, class Item>
void visitOptional(Stored& accuracy, Item&& item) {
  item("normalized_mean", accuracy.normalized_mean);
  item("scan_bound_m", accuracy.scan_bound_m);
  item("scan_bound_deg", accuracy.scan_bound_deg);
  item("drive_bound_m", accuracy.drive_bound_m);
  item("drive_bound_deg", accuracy.drive_bound_deg);
}

Json toJson(const Accuracy& accuracy) {
  Json json;
  json["scans"] = accuracy.scans;
  json["mean_m"] = accuracy.mean_m;
  json["mean_deg"] = accuracy.mean_deg;
  json["normalized"] = Json::array();
  for (const auto& value : accuracy.normalized) json["normalized"].push_back(toJson(value));
  visitOptional(accuracy, [&](const char* key, const auto& value) { json[key] = toJson(value); });
  return json;
}

Accuracy toAccuracy(const Json& json) {
  Accuracy accuracy;
  json.at("scans").get_to(accuracy.scans);
  json.at("mean_m").get_to(accuracy.mean_m);
  json.at("mean_deg").get_to(accuracy.mean_deg);
  for (const auto& value : json.at("normalized")) {
    accuracy.normalized.push_back(toOptional(value));
  }
  visitOptional(accuracy, [&](const char* key, auto& value) { value = toOptional(json.at(key)); });
  return accuracy;
}

Trial::Kind toKind(const std::string& text) {
  for (const auto kind : {Trial::Kind::kKnownStart, Trial::Kind::kWrongStart, Trial::Kind::kStart,
                          Trial::Kind::kKidnap}) {
    if (toText(kind) == text) return kind;
  }
  throw std::invalid_argument("'kind': got '" + text + "'");
}

Trial toTrial(const Json& json) {
  Trial trial;
  trial.kind = toKind(json.at("kind"));
  const auto pose = json.at("pose").get<std::vector<double>>();
  trial.T_map_base = {pose.at(0), pose.at(1), pose.at(2)};
  trial.found_s = toOptional(json.at("found_s"));
  trial.told_s = toOptional(json.at("told_s"));
  trial.within_s = toOptional(json.at("within_s"));
  visitTrial(trial, [&](const char* key, auto& value) { json.at(key).get_to(value); });
  return trial;
}

}  // namespace

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
  json["experiment"] = result.id.experiment;
  json["case"] = result.id.of_case;
  json["label"] = result.id.label;
  json["seed"] = result.id.seed;
  json["settings"] = result.id.settings;
  visit(result, [&](const char* key, const auto& value) { json[key] = value; });
  json["both_share"] = toJson(result.both_share);
  json["accuracy"] = toJson(result.accuracy);
  json["trials"] = Json::array();
  for (const auto& trial : result.trials) json["trials"].push_back(toJson(trial));
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

ExperimentResult fromLine(const std::string& line) {
  try {
    const Json json = Json::parse(line);
    ExperimentResult result;
    json.at("experiment").get_to(result.id.experiment);
    json.at("case").get_to(result.id.of_case);
    json.at("label").get_to(result.id.label);
    json.at("seed").get_to(result.id.seed);
    json.at("settings").get_to(result.id.settings);
    visit(result, [&](const char* key, auto& value) { json.at(key).get_to(value); });
    result.both_share = toOptional(json.at("both_share"));
    result.accuracy = toAccuracy(json.at("accuracy"));
    for (const auto& trial : json.at("trials")) result.trials.push_back(toTrial(trial));
    return result;
  } catch (const std::exception& error) {
    throw std::invalid_argument(std::string("no result of an experiment: ") + error.what());
  }
}

}  // namespace adaptive_localization
