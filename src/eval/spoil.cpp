// SPDX-License-Identifier: BSD-3-Clause
#include "eval/spoil.hpp"

#include <iomanip>
#include <sstream>
#include <utility>

#include "eval/arguments.hpp"
#include "eval/log_spoiler.hpp"
#include "eval/map_spoiler.hpp"

namespace adaptive_localization {
namespace {

template <class Thing>
Thing spoilAll(Thing thing, const Damages<Thing>& damages, const std::vector<Spoil>& spoils,
               std::uint64_t seed) {
  for (const auto& [kind, amount] : spoils) {
    if (findDamage(damages, kind)) thing = spoil(thing, kind, amount, seed);
  }
  return thing;
}

}  // namespace

std::vector<DamageKind> damageKinds() {
  std::vector<DamageKind> kinds = kindsOf(mapDamages());
  for (const auto& kind : kindsOf(logDamages())) kinds.push_back(kind);
  return kinds;
}

Spoil parseSpoil(const std::string& text) {
  const auto colon = text.find(':');
  const std::string name = text.substr(0, colon);
  const auto kinds = damageKinds();
  const DamageKind& kind = findKind(kinds, name);
  if (colon == std::string::npos) return {name, kind.amount};
  const double amount = toNumber("damage '" + name + "'", text.substr(colon + 1));
  checkAmount(kind, amount);
  return {name, amount};
}

std::string toText(const Spoil& spoil) {
  return spoil.kind + ":" + toText(OptionValue(spoil.amount));
}

std::string toText(const std::vector<Spoil>& spoils) {
  std::string text;
  for (const auto& spoil : spoils) text += (text.empty() ? "" : ", ") + toText(spoil);
  return text;
}

OccupancyGrid spoil(OccupancyGrid map, const std::vector<Spoil>& spoils, std::uint64_t seed) {
  return spoilAll(std::move(map), mapDamages(), spoils, seed);
}

Log spoil(Log log, const std::vector<Spoil>& spoils, std::uint64_t seed) {
  return spoilAll(std::move(log), logDamages(), spoils, seed);
}

std::string describeKinds(const std::vector<DamageKind>& kinds) {
  std::ostringstream text;
  for (const auto& kind : kinds) {
    const std::string usual =
        toText(OptionValue(kind.amount)) + (kind.unit.empty() ? "" : " " + kind.unit);
    text << "  " << std::left << std::setw(9) << kind.name << std::setw(10) << usual
         << kind.sentence << '\n';
  }
  return text.str();
}

}  // namespace adaptive_localization
