// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "adaptive_localization/core/options.hpp"
#include "adaptive_localization/core/rng.hpp"

namespace adaptive_localization {

/// A kind of damage, as a user sees it.
struct DamageKind {
  std::string name;
  double amount;  // the usual one
  Range range;
  std::string unit;  // empty: a share
  std::string sentence;
};

/// The kind of that name. Throws std::invalid_argument listing the known ones.
const DamageKind& findKind(const std::vector<DamageKind>& kinds, const std::string& name);

/// Throws std::invalid_argument naming kind, amount and range if the amount is out of range.
void checkAmount(const DamageKind& kind, double amount);

/// How a kind of damage is done to things of one type.
template <class Thing>
struct Damage {
  DamageKind kind;
  std::function<Thing(const Thing&, double amount, Rng& rng)> apply;
};

template <class Thing>
using Damages = std::vector<Damage<Thing>>;

template <class Thing>
std::vector<DamageKind> kindsOf(const Damages<Thing>& damages) {
  std::vector<DamageKind> kinds;
  for (const auto& damage : damages) kinds.push_back(damage.kind);
  return kinds;
}

/// The damage of that name, or none.
template <class Thing>
const Damage<Thing>* findDamage(const Damages<Thing>& damages, const std::string& name) {
  for (const auto& damage : damages) {
    if (damage.kind.name == name) return &damage;
  }
  return nullptr;
}

/// The thing spoiled; the same for the same seed. Throws std::invalid_argument listing the known
/// kinds, or naming the amount's range.
template <class Thing>
Thing spoilWith(const Damages<Thing>& damages, const Thing& thing, const std::string& kind,
                double amount, std::uint64_t seed) {
  checkAmount(findKind(kindsOf(damages), kind), amount);
  Rng rng(seed);
  return findDamage(damages, kind)->apply(thing, amount, rng);
}

}  // namespace adaptive_localization
