// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

namespace adaptive_localization {

/// Who publishes, hears and serves what, as the ROS master tells it: names of nodes by the resolved
/// name of a topic or service.
struct NodeGraph {
  using NodesByName = std::map<std::string, std::vector<std::string>>;
  std::map<std::string, std::string> topic_types;
  NodesByName publishers;
  NodesByName subscribers;
  NodesByName services;
};

/// One localization node with the resolved names of what a panel uses of it. Names that are empty:
/// the node has no such topic or service, or not yet.
struct LocalizationNames {
  std::string node;
  std::string status;
  std::string modes;
  std::string descriptions;         // of dynamic_reconfigure
  std::string updates;              // of dynamic_reconfigure
  std::string set_parameters;       // service of dynamic_reconfigure
  std::string global_localization;  // service, wherever it was remapped to
  std::string initial_pose;         // topic, wherever it was remapped to
};
bool operator==(const LocalizationNames& a, const LocalizationNames& b);

/// All localization nodes, by name. One is known by its topics, whatever it is called: `status`,
/// `confidence` and `modes` with the types that they have, side by side. A service that was
/// remapped is found as long as its name still ends with global_localization; the topic of initial
/// poses is the one of its type that the node hears, that ending with initialpose if there are
/// several.
std::vector<LocalizationNames> findLocalizations(const NodeGraph& graph);

}  // namespace adaptive_localization
