// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <xmlrpcpp/XmlRpcValue.h>

#include <optional>

#include "node_graph.hpp"

namespace adaptive_localization {

/// Asks the ROS master who is there. Waits for its answer; nothing if it does not answer as a
/// master does.
std::optional<NodeGraph> askMaster();

/// From the answers to getSystemState and getTopicTypes. Throws XmlRpc::XmlRpcException if they are
/// made otherwise.
NodeGraph toNodeGraph(XmlRpc::XmlRpcValue state, XmlRpc::XmlRpcValue types);

}  // namespace adaptive_localization
