// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace adaptive_localization {

/// Things of one kind by name, of which an option's value chooses one. A Description has a name, a
/// factory `make` and the `options` that the factory reads.
template <class Description>
class Registry {
 public:
  /// The key is that of the option that chooses.
  explicit Registry(std::string key) : key_(std::move(key)) {}

  /// Throws std::invalid_argument if name or factory are missing, or the name is taken.
  void add(Description description) {
    const std::string name = description.name;
    const std::string what = key_ + " '" + name + "'";
    if (name.empty() || !description.make) {
      throw std::invalid_argument(what + ": a name and a factory are needed");
    }
    if (!known_.emplace(name, std::move(description)).second) {
      throw std::invalid_argument(what + " is registered already");
    }
  }

  /// Throws std::invalid_argument listing the known names.
  const Description& find(const std::string& name) const {
    const auto found = known_.find(name);
    if (found != known_.end()) return found->second;
    std::string known;
    for (const auto& other : names()) known += (known.empty() ? "" : ", ") + other;
    throw std::invalid_argument("option '" + key_ + "': got '" + name + "', expected one of " +
                                known);
  }

  /// What the factory of that name makes. Throws std::invalid_argument as find() does and if it
  /// makes nothing, and whatever the factory throws.
  template <class... Arguments>
  auto make(const std::string& name, const Arguments&... arguments) const {
    auto made = find(name).make(arguments...);
    if (!made) throw std::invalid_argument("option '" + key_ + "': '" + name + "' makes nothing");
    return made;
  }

  /// In alphabetical order.
  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const auto& entry : known_) names.push_back(entry.first);
    return names;
  }

  const std::string& key() const { return key_; }

 private:
  std::string key_;
  std::map<std::string, Description> known_;
};

}  // namespace adaptive_localization
