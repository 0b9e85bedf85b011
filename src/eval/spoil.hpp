// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "adaptive_localization/map/occupancy_grid.hpp"
#include "eval/damage.hpp"
#include "eval/log.hpp"

namespace adaptive_localization {

/// What a user wants to be spoiled: a kind of damage to maps or to logs.
struct Spoil {
  std::string kind;
  double amount{0.0};
};

/// All kinds: those of maps, then those of logs.
std::vector<DamageKind> damageKinds();

/// Reads KIND or KIND:AMOUNT; without an amount it is the usual one. Throws std::invalid_argument
/// listing the known kinds, or naming the amount's range.
Spoil parseSpoil(const std::string& text);

/// KIND:AMOUNT, with commas between several.
std::string toText(const Spoil& spoil);
std::string toText(const std::vector<Spoil>& spoils);

/// Does to a map, or to a log, what is meant for it, in that order.
OccupancyGrid spoil(OccupancyGrid map, const std::vector<Spoil>& spoils, std::uint64_t seed);
Log spoil(Log log, const std::vector<Spoil>& spoils, std::uint64_t seed);

/// The part of a usage text that tells of kinds, a line each.
std::string describeKinds(const std::vector<DamageKind>& kinds);

}  // namespace adaptive_localization
