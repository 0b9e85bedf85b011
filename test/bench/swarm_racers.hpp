// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "swarm/swarm_move.hpp"

namespace adaptive_localization {

/// A swarm that is compared with others, by its name in tables.
struct SwarmRacer {
  std::string name;
  std::shared_ptr<const SwarmMove> move;
};

/// All: the bat algorithm and its form with leaders (Araujo Neto 2019), as printed and improved,
/// and the particle swarm (Kennedy and Eberhart 1995).
std::vector<SwarmRacer> swarmRacers();
std::vector<std::string> swarmNames();

/// Those with these names. Throws std::invalid_argument naming the one that is unknown.
std::vector<SwarmRacer> swarmRacers(const std::vector<std::string>& names);

}  // namespace adaptive_localization
