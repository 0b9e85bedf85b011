// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_msgs/DiagnosticArray.h>
#include <diagnostic_msgs/DiagnosticStatus.h>
#include <dynamic_reconfigure/Config.h>
#include <dynamic_reconfigure/ConfigDescription.h>
#include <geometry_msgs/PoseArray.h>
#include <ros/time.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "adaptive_localization/core/pose2.hpp"
#include "confidence_history.hpp"

namespace adaptive_localization {

/// One of the places where the robot may be.
struct NamedPlace {
  Pose2 pose;
  std::optional<double> mass;  // 0 to 1; none: the status does not tell it
};

/// What the node makes of one sense, in its own words.
struct Sense {
  std::string name;
  std::string state;
  bool is_fine{true};
};

/// What a panel shows of one localization node, gathered from its messages.
struct PanelState {
  std::string status;    // empty: none was heard
  double heard_at{0.0};  // s of a clock that only goes on: when the last status came
  double confidence{0.0};
  std::size_t particles{0};
  double ms_per_update{0.0};
  ConfidenceHistory history;
  std::string frame;       // of the places
  ros::Time places_stamp;  // when the robot was at one of them
  std::vector<NamedPlace> places;
  std::vector<Sense> senses;       // the laser first
  std::string core;                // in effect; empty: not known yet
  std::vector<std::string> cores;  // to choose from
  std::vector<NamedPlace> told;    // places as the status tells them, with masses
};

/// Takes over `~status`. Values that are missing or no numbers stay as they were.
void read(const diagnostic_msgs::DiagnosticStatus& message, PanelState& state);

/// Takes over `~modes`, with masses where the status tells of the same places.
void read(const geometry_msgs::PoseArray& message, PanelState& state);

/// Takes over the laser and the other senses from the diagnostics of this node ("/robot/amcl").
/// Returns false and leaves the state as it was where the array is another node's.
bool read(const diagnostic_msgs::DiagnosticArray& message, const std::string& node,
          PanelState& state);

/// Takes over the cores to choose from: the choices of parameter `filter`.
void read(const dynamic_reconfigure::ConfigDescription& message, PanelState& state);

/// Takes over the core in effect.
void read(const dynamic_reconfigure::Config& message, PanelState& state);

/// The value of parameter `filter`; empty: there is none.
std::string coreIn(const dynamic_reconfigure::Config& message);

}  // namespace adaptive_localization
