// SPDX-License-Identifier: BSD-3-Clause
#include "bag_log_topics.hpp"

#include <stdexcept>

namespace adaptive_localization {

std::string withoutSlash(const std::string& name) {
  return !name.empty() && name.front() == '/' ? name.substr(1) : name;
}

std::string join(const std::set<std::string>& words) {
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "" : ", ") + word;
  return text.empty() ? "none" : text;
}

std::set<std::string> BagTopics::of(const TopicKind& kind) const {
  std::set<std::string> names;
  for (const auto& [topic, type] : types_) {
    if (kind.types.count(type)) names.insert(topic);
  }
  return names;
}

std::string BagTopics::choose(const std::string& wanted, const TopicKind& kind) const {
  const auto candidates = of(kind);
  if (wanted.empty()) {
    if (candidates.size() == 1) return *candidates.begin();
    if (candidates.empty()) throw std::invalid_argument("has no topic with " + kind.what);
    throw std::invalid_argument("has several topics with " + kind.what + ", name one with " +
                                kind.argument + ": " + join(candidates));
  }
  for (const auto& topic : candidates) {
    if (withoutSlash(topic) == withoutSlash(wanted)) return topic;
  }
  throw std::invalid_argument(kind.argument + ": got '" + wanted + "', expected a topic with " +
                              kind.what + " of this bag: " + join(candidates));
}

}  // namespace adaptive_localization
