// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "eval/experiment.hpp"

namespace adaptive_localization {

/// KEY:=VALUE from the command line. A key of the experiment's file, with dots (duration,
/// simulation.people, success.scans), or else an option of all cores.
using Overrides = std::vector<std::pair<std::string, std::string>>;

/// Reads an experiment:
///
///     name: kidnap
///     sentence: The robot is lifted and put down elsewhere.
///     world: ../../maps/maze        # a folder with world.yaml and map.yaml, from this file
///     map: ../map.yaml              # another map than the world's, or surveyed: as by a robot
///     route: random                 # or a list of [x, y]; otherwise the floor plan's
///     start: random                 # or [x, y, yaw], or {regions: [[x, y, x, y], ...],
///                                   #   yaw: [low, high], farther_than: m}
///     start_known: true             # the localizer is told; otherwise it starts anywhere
///     told: {off_by: 5.4, turned_by: 0}   # m, rad: what it is told is wrong; or [x, y, yaw]
///                                   #   off_by: [x, y] is so far along a line, either way
///     simulation: {people: 2}       # options of p3dx_simulator; drive is on
///     duration: 42                  # s
///     events:                       # of five kinds; with every: s, again and again
///       - {what: kidnap, at: 12, every: 15, to: random}
///       - {what: carry, at: 12, for: 3, to: random, laser: garbage}       # or blocked
///       - {what: block, at: 10, for: 20, share: 0.3, pattern: sector}     # or scattered
///       - {what: cover, at: 10, for: 30}   # the laser, by a hand
///       - {what: disturb, at: 10, for: 60, turned_by: 1.57}   # rad, the compass; simulation.imu
///     success: {position: 0.15, heading: 5, scans: 3, within: 1}   # m, degrees; s, any
///                                   #   modulo_half_turn: true, the twin place counts as well
///     bounds: true                  # with Cramér-Rao bounds of the error, see error_bound.hpp
///     probes: [20, 30]              # s
///     half_turn: [5, 2.5]           # the map looks the same after half a turn about this point
///     options: {update_min_d: 0}    # of all cores
///     cores:                        # line_map: world, or a file, from this file's place
///       - {filter: amcl, preset: recommended, label: amcl, options: {max_particles: 1000}}
///     seeds: {first: 1, count: 100}
///     cases:                        # scenarios; each may say any of the above in its own way
///       - {label: maze}
///       - {label: expansion, world: ../../maps/expansion}
///
/// Required: name, sentence, world, cores.
/// Throws std::invalid_argument naming file, key, value and what was expected.
Experiment loadExperiment(const std::string& yaml_file, const Overrides& overrides = {});

}  // namespace adaptive_localization
