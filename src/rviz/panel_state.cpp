// SPDX-License-Identifier: BSD-3-Clause
#include "panel_state.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <regex>

#include "endings.hpp"

namespace adaptive_localization {
namespace {

using diagnostic_msgs::DiagnosticStatus;

std::map<std::string, std::string> valuesOf(const DiagnosticStatus& message) {
  std::map<std::string, std::string> values;
  for (const auto& pair : message.values) values[pair.key] = pair.value;
  return values;
}

std::optional<double> numberOf(const std::map<std::string, std::string>& values,
                               const std::string& key) {
  const auto found = values.find(key);
  if (found == values.end()) return std::nullopt;
  char* end = nullptr;
  const double number = std::strtod(found->second.c_str(), &end);
  if (end == found->second.c_str() || !std::isfinite(number)) return std::nullopt;
  return number;
}

std::vector<NamedPlace> toldPlaces(const std::map<std::string, std::string>& values) {
  std::vector<NamedPlace> places;
  for (int i = 1;; ++i) {
    const auto found = values.find("mode " + std::to_string(i));
    if (found == values.end()) return places;
    double mass = 0.0, degrees = 0.0;
    Pose2 pose;
    const int count = std::sscanf(found->second.c_str(), "mass %lf at x %lf m, y %lf m, yaw %lf",
                                  &mass, &pose.x, &pose.y, &degrees);
    if (count != 4) return places;
    pose.theta = degrees * kPi / 180.0;
    places.push_back({pose, mass});
  }
}

/// Whether two messages mean one place: the text is rounded.
bool areOne(const Pose2& a, const Pose2& b) {
  return std::hypot(a.x - b.x, a.y - b.y) < 0.01 && std::abs(wrapAngle(a.theta - b.theta)) < 0.01;
}

/// Status and places come in two messages, either of them first.
void weigh(PanelState& state) {
  for (std::size_t i = 0; i < state.places.size(); ++i) {
    NamedPlace& place = state.places[i];
    const bool is_told = i < state.told.size() && areOne(place.pose, state.told[i].pose);
    if (is_told) place.mass = state.told[i].mass;
  }
}

Pose2 planar(const geometry_msgs::Pose& pose) {
  const auto& q = pose.orientation;
  return {pose.position.x, pose.position.y,
          std::atan2(2.0 * (q.w * q.z + q.x * q.y), q.w * q.w + q.x * q.x - q.y * q.y - q.z * q.z)};
}

/// Of "<node>: Scans". A node that hears no laser counts none and lacks none.
void readScans(const DiagnosticStatus& status, std::vector<Sense>& senses) {
  const auto values = valuesOf(status);
  const double received = numberOf(values, "scans received").value_or(0.0);
  const double dropped = numberOf(values, "scans dropped").value_or(0.0);
  const bool is_fine = status.level == DiagnosticStatus::OK;
  if (received <= 0.0 && is_fine) return;
  std::string state = is_fine ? "used" : status.message;
  if (is_fine && dropped > 0.0) {
    char text[64];
    std::snprintf(text, sizeof text, ", %.0f of %.0f scans dropped", dropped, received);
    state += text;
  }
  senses.push_back({"laser", state, is_fine});
}

/// Of "<node>: Senses": the state of each, its message tells those that are not fine.
void readSenses(const DiagnosticStatus& status, std::vector<Sense>& senses) {
  for (const auto& pair : status.values) {
    if (endsWith(pair.key, " messages received") || endsWith(pair.key, " messages dropped")) {
      continue;
    }
    const std::string trouble = "; " + pair.key + ": " + pair.value + ";";
    const bool is_fine = ("; " + status.message + ";").find(trouble) == std::string::npos;
    senses.push_back({pair.key, pair.value, is_fine});
  }
}

}  // namespace

void read(const DiagnosticStatus& message, PanelState& state) {
  const auto values = valuesOf(message);
  state.status = message.message;
  state.confidence = numberOf(values, "confidence").value_or(state.confidence);
  state.ms_per_update = numberOf(values, "ms per update").value_or(state.ms_per_update);
  if (const auto particles = numberOf(values, "particles"); particles && *particles >= 0.0) {
    state.particles = static_cast<std::size_t>(*particles);
  }
  if (const auto stamp = numberOf(values, "stamp")) {
    state.history.add({*stamp, state.confidence, state.status});
  }
  state.told = toldPlaces(values);
  if (numberOf(values, "modes").value_or(1.0) <= 0.0) state.places.clear();
  weigh(state);
}

void read(const geometry_msgs::PoseArray& message, PanelState& state) {
  state.frame = message.header.frame_id;
  state.places_stamp = message.header.stamp;
  state.places.clear();
  for (const auto& pose : message.poses) state.places.push_back({planar(pose), std::nullopt});
  weigh(state);
}

bool read(const diagnostic_msgs::DiagnosticArray& message, const std::string& node,
          PanelState& state) {
  const std::string name = node.substr(node.find_first_not_of('/')) + ": ";
  std::vector<Sense> senses;
  bool is_ours = false;
  for (const auto& status : message.status) {
    if (status.name == name + "Scans") readScans(status, senses);
    if (status.name == name + "Senses") readSenses(status, senses);
    is_ours = is_ours || status.name == name + "Scans";
  }
  if (is_ours) state.senses = senses;
  return is_ours;
}

void read(const dynamic_reconfigure::ConfigDescription& message, PanelState& state) {
  static const std::regex value(R"re(["']value["']: *["']([^"']*)["'])re");
  for (const auto& group : message.groups) {
    for (const auto& field : group.parameters) {
      if (field.name != "filter") continue;
      state.cores.clear();
      const std::string& text = field.edit_method;
      for (std::sregex_iterator it(text.begin(), text.end(), value), end; it != end; ++it) {
        state.cores.push_back((*it)[1]);
      }
    }
  }
}

void read(const dynamic_reconfigure::Config& message, PanelState& state) {
  const std::string core = coreIn(message);
  if (!core.empty()) state.core = core;
}

std::string coreIn(const dynamic_reconfigure::Config& message) {
  for (const auto& field : message.strs) {
    if (field.name == "filter") return field.value;
  }
  return "";
}

}  // namespace adaptive_localization
