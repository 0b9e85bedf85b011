// SPDX-License-Identifier: BSD-3-Clause
#include "rviz/node_graph.hpp"

#include <gmock/gmock.h>

namespace adaptive_localization {
namespace {

using testing::ElementsAre;
using testing::Field;
using testing::IsEmpty;

/// What a master knows of a node with this name and its topics in the namespace of the node.
void addNode(NodeGraph& graph, const std::string& node, const std::string& service,
             const std::string& topic) {
  const std::string own[][2] = {
      {"/status", "diagnostic_msgs/DiagnosticStatus"},
      {"/confidence", "std_msgs/Float32"},
      {"/modes", "geometry_msgs/PoseArray"},
      {"/parameter_updates", "dynamic_reconfigure/Config"},
      {"/parameter_descriptions", "dynamic_reconfigure/ConfigDescription"}};
  for (const auto& [name, type] : own) {
    graph.publishers[node + name].push_back(node);
    graph.topic_types[node + name] = type;
  }
  graph.services[node + "/set_parameters"].push_back(node);
  graph.services[node + "/get_loggers"].push_back(node);
  if (!service.empty()) graph.services[service].push_back(node);
  if (topic.empty()) return;
  graph.subscribers[topic].push_back(node);
  graph.topic_types[topic] = "geometry_msgs/PoseWithCovarianceStamped";
}

}  // namespace

TEST(NodeGraph, FindsNodesUnderAnyNameInOrder) {
  NodeGraph graph;
  addNode(graph, "/zoe/where", "/zoe/global_localization", "/zoe/initialpose");
  addNode(graph, "/amcl", "/global_localization", "/initialpose");
  const auto found = findLocalizations(graph);
  ASSERT_THAT(found, ElementsAre(Field(&LocalizationNames::node, "/amcl"),
                                 Field(&LocalizationNames::node, "/zoe/where")));
  EXPECT_EQ(found[1].status, "/zoe/where/status");
  EXPECT_EQ(found[1].modes, "/zoe/where/modes");
  EXPECT_EQ(found[1].descriptions, "/zoe/where/parameter_descriptions");
  EXPECT_EQ(found[1].updates, "/zoe/where/parameter_updates");
  EXPECT_EQ(found[1].set_parameters, "/zoe/where/set_parameters");
  EXPECT_EQ(found[1].global_localization, "/zoe/global_localization");
  EXPECT_EQ(found[1].initial_pose, "/zoe/initialpose");
  EXPECT_EQ(found[0].global_localization, "/global_localization");
}

TEST(NodeGraph, FindsWhatWasRemapped) {
  NodeGraph graph;
  addNode(graph, "/amcl", "/fleet/robot_7_global_localization", "/fleet/put_robot_7");
  graph.topic_types["/other"] = "std_msgs/String";
  graph.subscribers["/other"] = {"/amcl"};
  graph.subscribers["/initialpose"] = {"/somebody"};
  graph.topic_types["/initialpose"] = "geometry_msgs/PoseWithCovarianceStamped";
  graph.services["/global_localization"] = {"/somebody"};
  const auto found = findLocalizations(graph);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].global_localization, "/fleet/robot_7_global_localization");
  EXPECT_EQ(found[0].initial_pose, "/fleet/put_robot_7");
}

TEST(NodeGraph, PrefersTheUsualNames) {
  NodeGraph graph;
  addNode(graph, "/amcl", "/global_localization", "/initialpose");
  graph.subscribers["/a_pose"] = {"/amcl"};
  graph.topic_types["/a_pose"] = "geometry_msgs/PoseWithCovarianceStamped";
  graph.services["/a_global_localization"] = {"/amcl"};
  const auto found = findLocalizations(graph);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].initial_pose, "/initialpose");
  EXPECT_EQ(found[0].global_localization, "/global_localization");
}

TEST(NodeGraph, NamesThatAreMissingAreEmpty) {
  NodeGraph graph;
  addNode(graph, "/amcl", "", "");
  graph.services["/amcl/set_parameters"] = {"/somebody"};
  const auto found = findLocalizations(graph);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].initial_pose, "");
  EXPECT_EQ(found[0].global_localization, "");
  EXPECT_EQ(found[0].set_parameters, "");
}

TEST(NodeGraph, OtherNodesAreNone) {
  NodeGraph graph;
  EXPECT_THAT(findLocalizations(graph), IsEmpty());
  addNode(graph, "/amcl", "", "");
  graph.topic_types["/amcl/confidence"] = "std_msgs/Float64";
  EXPECT_THAT(findLocalizations(graph), IsEmpty()) << "another type";
  graph = {};
  addNode(graph, "/amcl", "", "");
  graph.publishers["/amcl/modes"] = {"/somebody"};
  EXPECT_THAT(findLocalizations(graph), IsEmpty()) << "another publisher";
}

TEST(NodeGraph, NamesAreComparedInFull) {
  NodeGraph graph;
  addNode(graph, "/amcl", "/global_localization", "/initialpose");
  const auto before = findLocalizations(graph);
  EXPECT_TRUE(before[0] == findLocalizations(graph)[0]);
  graph.subscribers.clear();
  EXPECT_FALSE(before[0] == findLocalizations(graph)[0]);
}

}  // namespace adaptive_localization
