// SPDX-License-Identifier: BSD-3-Clause
#include "master_state.hpp"

#include <ros/master.h>
#include <ros/this_node.h>
#include <xmlrpcpp/XmlRpcException.h>

namespace adaptive_localization {
namespace {

/// [[name, [node, ...]], ...]
NodeGraph::NodesByName nodesByName(XmlRpc::XmlRpcValue& list) {
  NodeGraph::NodesByName result;
  for (int i = 0; i < list.size(); ++i) {
    auto& nodes = result[static_cast<std::string>(list[i][0])];
    for (int k = 0; k < list[i][1].size(); ++k) nodes.push_back(list[i][1][k]);
  }
  return result;
}

}  // namespace

NodeGraph toNodeGraph(XmlRpc::XmlRpcValue state, XmlRpc::XmlRpcValue types) {
  NodeGraph graph;
  graph.publishers = nodesByName(state[0]);
  graph.subscribers = nodesByName(state[1]);
  graph.services = nodesByName(state[2]);
  for (int i = 0; i < types.size(); ++i) {
    graph.topic_types[static_cast<std::string>(types[i][0])] =
        static_cast<std::string>(types[i][1]);
  }
  return graph;
}

std::optional<NodeGraph> askMaster() {
  XmlRpc::XmlRpcValue request, response, state, types;
  request[0] = ros::this_node::getName();
  try {
    if (!ros::master::execute("getSystemState", request, response, state, false) ||
        !ros::master::execute("getTopicTypes", request, response, types, false)) {
      return std::nullopt;
    }
    return toNodeGraph(state, types);
  } catch (const XmlRpc::XmlRpcException&) {
    return std::nullopt;
  }
}

}  // namespace adaptive_localization
