// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_msgs/DiagnosticStatus.h>

#include <cstdio>
#include <string>
#include <vector>

#include "heading_source.hpp"
#include "scan_source.hpp"

namespace adaptive_localization {

/// A status of this node, named as diagnostic_updater names it: "<node>: <what>".
inline diagnostic_msgs::DiagnosticStatus makeStatus(
    const std::string& what, diagnostic_msgs::DiagnosticStatus::_level_type level,
    const std::string& message) {
  diagnostic_msgs::DiagnosticStatus status;
  status.name = ros::this_node::getName().substr(1) + ": " + what;
  status.hardware_id = "none";
  status.level = level;
  status.message = message;
  return status;
}

inline void add(diagnostic_msgs::DiagnosticStatus& status, const std::string& key,
                const std::string& value) {
  diagnostic_msgs::KeyValue pair;
  pair.key = key;
  pair.value = value;
  status.values.push_back(pair);
}

inline void addCounts(diagnostic_msgs::DiagnosticStatus& status, const ScanSource::Counts& scans) {
  add(status, "scans received", std::to_string(scans.received));
  add(status, "scans used", std::to_string(scans.used));
  add(status, "scans dropped", std::to_string(scans.dropped));
}

inline void addSenses(diagnostic_msgs::DiagnosticStatus& status,
                      const std::vector<SenseStatus>& senses) {
  for (const SenseStatus& sense : senses) {
    const std::string& name = sense.health.name;
    add(status, name, sense.state);
    add(status, name + " messages received", std::to_string(sense.health.heard.received));
    add(status, name + " messages dropped", std::to_string(sense.health.heard.dropped));
  }
}

template <class... Values>
std::string print(const char* format, Values... values) {
  char text[128];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

}  // namespace adaptive_localization
