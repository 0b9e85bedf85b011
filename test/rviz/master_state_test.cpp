// SPDX-License-Identifier: BSD-3-Clause
#include "rviz/master_state.hpp"

#include <gmock/gmock.h>
#include <xmlrpcpp/XmlRpcException.h>

namespace adaptive_localization {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

XmlRpc::XmlRpcValue fromXml(const std::string& xml) {
  int offset = 0;
  return XmlRpc::XmlRpcValue(xml, &offset);
}

std::string array(const std::string& items) {
  return "<value><array><data>" + items + "</data></array></value>";
}

std::string text(const std::string& word) {
  return "<value><string>" + word + "</string></value>";
}

}  // namespace

TEST(MasterState, ReadsWhatTheMasterAnswers) {
  const std::string topic = array(text("/scan") + array(text("/laser") + text("/player")));
  const std::string state =
      array(array(topic) + array("") + array(array(text("/s") + array(text("/n")))));
  const std::string types = array(array(text("/scan") + text("sensor_msgs/LaserScan")));
  const NodeGraph graph = toNodeGraph(fromXml(state), fromXml(types));
  EXPECT_THAT(graph.publishers, ElementsAre(Pair("/scan", ElementsAre("/laser", "/player"))));
  EXPECT_THAT(graph.subscribers, IsEmpty());
  EXPECT_THAT(graph.services, ElementsAre(Pair("/s", ElementsAre("/n"))));
  EXPECT_THAT(graph.topic_types, ElementsAre(Pair("/scan", "sensor_msgs/LaserScan")));
}

TEST(MasterState, RefusesOtherAnswers) {
  EXPECT_THROW(toNodeGraph(fromXml(text("no")), fromXml(array(""))), XmlRpc::XmlRpcException);
  const std::string state = array(array(array(text("/scan"))) + array("") + array(""));
  EXPECT_THROW(toNodeGraph(fromXml(state), fromXml(array(""))), XmlRpc::XmlRpcException);
}

}  // namespace adaptive_localization
