// SPDX-License-Identifier: BSD-3-Clause
#include "node_graph.hpp"

#include <algorithm>
#include <tuple>

#include "endings.hpp"

namespace adaptive_localization {
namespace {

bool has(const NodeGraph::NodesByName& names, const std::string& name, const std::string& node) {
  const auto found = names.find(name);
  return found != names.end() &&
         std::find(found->second.begin(), found->second.end(), node) != found->second.end();
}

/// The name if the node has it there, else nothing.
std::string ifHas(const NodeGraph::NodesByName& names, const std::string& name,
                  const std::string& node) {
  return has(names, name, node) ? name : "";
}

bool isOfType(const NodeGraph& graph, const std::string& topic, const std::string& type) {
  const auto found = graph.topic_types.find(topic);
  return found != graph.topic_types.end() && found->second == type;
}

/// Of the names that the node has there and that a condition holds for, the first that ends so;
/// else the first.
template <class Condition>
std::string nameWith(const NodeGraph::NodesByName& names, const std::string& node,
                     const std::string& end, const Condition& condition) {
  std::string first;
  for (const auto& entry : names) {
    const std::string& name = entry.first;
    if (!has(names, name, node) || !condition(name)) continue;
    if (endsWith(name, end)) return name;
    if (first.empty()) first = name;
  }
  return first;
}

LocalizationNames namesOf(const NodeGraph& graph, const std::string& node,
                          const std::string& prefix) {
  LocalizationNames names;
  names.node = node;
  names.status = prefix + "status";
  names.modes = prefix + "modes";
  names.descriptions = ifHas(graph.publishers, prefix + "parameter_descriptions", node);
  names.updates = ifHas(graph.publishers, prefix + "parameter_updates", node);
  names.set_parameters = ifHas(graph.services, prefix + "set_parameters", node);
  const std::string service = "global_localization", topic = "initialpose";
  names.global_localization =
      nameWith(graph.services, node, "/" + service,
               [&](const std::string& name) { return endsWith(name, service); });
  names.initial_pose = nameWith(graph.subscribers, node, "/" + topic, [&](const std::string& name) {
    return isOfType(graph, name, "geometry_msgs/PoseWithCovarianceStamped");
  });
  return names;
}

}  // namespace

bool operator==(const LocalizationNames& a, const LocalizationNames& b) {
  const auto all = [](const LocalizationNames& n) {
    return std::tie(n.node, n.status, n.modes, n.descriptions, n.updates, n.set_parameters,
                    n.global_localization, n.initial_pose);
  };
  return all(a) == all(b);
}

std::vector<LocalizationNames> findLocalizations(const NodeGraph& graph) {
  std::vector<LocalizationNames> found;
  for (const auto& [topic, nodes] : graph.publishers) {
    if (!endsWith(topic, "/status")) continue;
    const std::string prefix = topic.substr(0, topic.size() - std::string("status").size());
    if (!isOfType(graph, topic, "diagnostic_msgs/DiagnosticStatus") ||
        !isOfType(graph, prefix + "confidence", "std_msgs/Float32") ||
        !isOfType(graph, prefix + "modes", "geometry_msgs/PoseArray")) {
      continue;
    }
    for (const std::string& node : nodes) {
      if (has(graph.publishers, prefix + "modes", node)) {
        found.push_back(namesOf(graph, node, prefix));
      }
    }
  }
  std::sort(found.begin(), found.end(),
            [](const auto& a, const auto& b) { return a.node < b.node; });
  return found;
}

}  // namespace adaptive_localization
