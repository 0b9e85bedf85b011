// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <string>

namespace adaptive_localization {

/// Types of a bag's messages, by topic.
using TopicTypes = std::map<std::string, std::string>;

/// What a choice of topic is for: the message types that fit, the argument or
/// option that names one, a word.
struct TopicKind {
  std::set<std::string> types;
  std::string argument;
  std::string what;
};

/// a, b, c; "none" for no words.
std::string join(const std::set<std::string>& words);

/// Names of the topics whose type fits.
std::set<std::string> topicsOf(const TopicKind& kind, const TopicTypes& types);

/// The topic that `wanted` names, or, if it is empty, the only one that fits; the slash in front
/// does not matter. Throws std::invalid_argument naming the topics there are.
std::string choose(const std::string& wanted, const TopicKind& kind, const TopicTypes& types);

/// What is wrong with a topic that `wanted` names; empty for nothing. The slash in front does not
/// matter.
std::string faultOf(const std::string& wanted, const TopicKind& kind, const TopicTypes& types);

}  // namespace adaptive_localization
