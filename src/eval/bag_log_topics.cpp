// SPDX-License-Identifier: BSD-3-Clause
#include "bag_log_topics.hpp"

#include <algorithm>
#include <stdexcept>

#include "../bag/names.hpp"

namespace adaptive_localization {
namespace {

bool areSame(const std::string& a, const std::string& b) {
  return withoutLeadingSlash(a) == withoutLeadingSlash(b);
}

}  // namespace

std::string join(const std::set<std::string>& words) {
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "" : ", ") + word;
  return text.empty() ? "none" : text;
}

std::set<std::string> topicsOf(const TopicKind& kind, const TopicTypes& types) {
  std::set<std::string> names;
  for (const auto& [topic, type] : types) {
    if (kind.types.count(type)) names.insert(topic);
  }
  return names;
}

std::string choose(const std::string& wanted, const TopicKind& kind, const TopicTypes& types) {
  const auto candidates = topicsOf(kind, types);
  if (wanted.empty()) {
    if (candidates.size() == 1) return *candidates.begin();
    if (candidates.empty()) throw std::invalid_argument("has no topic with " + kind.what);
    throw std::invalid_argument("has several topics with " + kind.what + ", name one with " +
                                kind.argument + ": " + join(candidates));
  }
  for (const auto& topic : candidates) {
    if (areSame(topic, wanted)) return topic;
  }
  throw std::invalid_argument(kind.argument + ": got '" + wanted + "', expected a topic with " +
                              kind.what + " of this bag: " + join(candidates));
}

std::string faultOf(const std::string& wanted, const TopicKind& kind, const TopicTypes& types) {
  const auto found = std::find_if(types.begin(), types.end(),
                                  [&](const auto& entry) { return areSame(entry.first, wanted); });
  if (found == types.end()) {
    return kind.argument + ": no topic '" + wanted + "' with " + kind.what + " in this bag";
  }
  if (kind.types.count(found->second)) return "";
  return kind.argument + ": the messages of '" + wanted + "' are " + found->second + ", expected " +
         join(kind.types);
}

}  // namespace adaptive_localization
