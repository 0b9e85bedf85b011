// SPDX-License-Identifier: BSD-3-Clause
#include "eval/damage.hpp"

#include <stdexcept>

#include "core/suggestion.hpp"

namespace adaptive_localization {

const DamageKind& findKind(const std::vector<DamageKind>& kinds, const std::string& name) {
  std::vector<std::string> names;
  std::string known;
  for (const auto& kind : kinds) {
    if (kind.name == name) return kind;
    names.push_back(kind.name);
    known += (known.empty() ? "" : ", ") + kind.name;
  }
  throw std::invalid_argument("damage: got '" + name + "', expected one of " + known +
                              suggestion(name, names));
}

void checkAmount(const DamageKind& kind, double amount) {
  if (amount >= kind.range.low && amount <= kind.range.high) return;
  throw std::invalid_argument("damage '" + kind.name + "': got " + toText(OptionValue(amount)) +
                              ", expected " + toText(OptionValue(kind.range.low)) + " to " +
                              toText(OptionValue(kind.range.high)) +
                              (kind.unit.empty() ? "" : " " + kind.unit));
}

}  // namespace adaptive_localization
