// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "adaptive_localization/core/options.hpp"
#include "map/polygon.hpp"
#include "sim/simulation.hpp"

namespace adaptive_localization {

/// Where a robot is put: at a pose, or at a random place among those where it can stand and get
/// away from.
struct Spot {
  std::optional<Pose2> pose;
  std::vector<Bounds> regions;          // in one of them; empty: anywhere
  double yaw_low{-kPi}, yaw_high{kPi};  // rad
  double farther_than{0.0};             // m from where it was
};

/// What the localizer is told of its start although it is not true: a pose, or one so far from the
/// true one, anywhere where the robot could stand.
struct WrongStart {
  std::optional<Pose2> pose;
  double off_by{0.0};                    // m
  std::optional<Eigen::Vector2d> shift;  // m in the map frame, this way or back; without off_by
  double turned_by{0.0};                 // rad
};

/// Something that happens to the robot, again every so many seconds if asked for.
struct ExperimentEvent {
  enum class What { kKidnap, kCarry, kBlock, kCover, kDisturb };

  What what{What::kKidnap};
  double at{0.0};          // s
  double duration{0.0};    // s, but of a kidnap
  double every{0.0};       // s; 0: once
  Spot to;                 // of a kidnap or a carry
  double turned_by{0.0};   // rad, by which a disturbed compass is off
  double share{0.0};       // of the beams, of a block
  bool is_sector{false};   // the blocked beams lie side by side and stay the same
  bool is_garbage{false};  // what a carried laser sees: anything, rather than a hand before it
};

/// When an estimate is right: near enough for so many scans in a row.
struct SuccessRule {
  double position{0.15};              // m
  double heading{5.0 * kPi / 180.0};  // rad
  int scans{3};
  std::optional<double> within;  // s, the time in which it must be found
  bool is_modulo{false};         // the place that is half a turn away counts as well
};

/// A core under test.
struct ExperimentCore {
  std::string label;
  Parameters parameters;  // filter, preset and options
};

/// One scenario: a world, what happens in it, and the cores that live through it.
struct ExperimentCase {
  std::string experiment, label;
  std::string world, map;                             // YAML files; no map: one is surveyed
  std::optional<std::vector<Eigen::Vector2d>> route;  // none: the floor plan's; empty: random
  Spot start;
  bool is_start_known{false};
  std::optional<WrongStart> told;  // the start is known, wrongly
  Parameters simulation;           // options of the simulated robot
  double duration{30.0};           // s
  std::vector<ExperimentEvent> events;
  SuccessRule success;
  std::vector<double> probes;      // s: moments at which the error is noted
  bool has_bounds{false};          // the bounds of the error are worked out too
  std::optional<Pose2> half_turn;  // the map looks the same after half a turn about this point
  std::vector<ExperimentCore> cores;
  int first_seed{1};
  int seeds{30};
  std::string fingerprint;  // of all that decides the results but core and seed
};

/// A named experiment; experiment_loader.hpp reads it from a file.
struct Experiment {
  std::string name, sentence;
  std::vector<ExperimentCase> cases;
};

}  // namespace adaptive_localization
