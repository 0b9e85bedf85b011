// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <string>

namespace adaptive_localization {

/// What a choice of topic is for: the message types that fit, the argument that names one, a word.
struct TopicKind {
  std::set<std::string> types;
  std::string argument;
  std::string what;
};

/// The topics of a bag by name, with their types.
class BagTopics {
 public:
  explicit BagTopics(const std::map<std::string, std::string>& types) : types_(types) {}

  /// Names of the topics whose type fits.
  std::set<std::string> of(const TopicKind& kind) const;

  /// The topic that `wanted` names, or, if it is empty, the only one that fits; the slash in front
  /// does not matter. Throws std::invalid_argument naming the topics there are.
  std::string choose(const std::string& wanted, const TopicKind& kind) const;

 private:
  std::map<std::string, std::string> types_;
};

/// Frame and topic names are compared without the leading slash of ROS's early days.
std::string withoutSlash(const std::string& name);

/// a, b, c; "none" for no words.
std::string join(const std::set<std::string>& words);

}  // namespace adaptive_localization
