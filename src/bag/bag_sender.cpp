// SPDX-License-Identifier: BSD-3-Clause
// Reads a bag in a process of its own.
#include <console_bridge/console.h>
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <geometry_msgs/QuaternionStamped.h>
#include <nav_msgs/Odometry.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <sensor_msgs/Imu.h>
#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/MagneticField.h>
#include <sensor_msgs/PointCloud.h>
#include <sensor_msgs/Range.h>
#include <tf2_msgs/TFMessage.h>

#include <functional>
#include <map>
#include <utility>

#include "bag_record.hpp"
#include "sonar_array.hpp"

namespace adaptive_localization {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// A type of message: which bag has it, whether bytes are one.
struct Type {
  std::string checksum;
  std::function<void(Bytes&)> read;  // throws if they are none
};

template <class Message>
std::pair<const std::string, Type> typeOf() {
  return {ros::message_traits::DataType<Message>::value(),
          {ros::message_traits::MD5Sum<Message>::value(), [](Bytes& bytes) {
             ros::serialization::IStream stream(bytes.data(),
                                                static_cast<std::uint32_t>(bytes.size()));
             Message message;
             ros::serialization::deserialize(stream, message);
           }}};
}

const std::map<std::string, Type>& types() {
  static const std::map<std::string, Type> all{typeOf<sensor_msgs::LaserScan>(),
                                               typeOf<tf2_msgs::TFMessage>(),
                                               typeOf<nav_msgs::Odometry>(),
                                               typeOf<geometry_msgs::PoseStamped>(),
                                               typeOf<geometry_msgs::PoseWithCovarianceStamped>(),
                                               typeOf<sensor_msgs::Imu>(),
                                               typeOf<sensor_msgs::MagneticField>(),
                                               typeOf<geometry_msgs::QuaternionStamped>(),
                                               typeOf<sensor_msgs::Range>(),
                                               typeOf<sensor_msgs::PointCloud>(),
                                               typeOf<SonarArray>()};
  return all;
}

bool isFixed(const std::string& topic) {
  return topic == "/tf_static" || topic == "tf_static";
}

class BagSender {
 public:
  BagSender(const std::string& file, std::FILE* out) : out_(out), bag_(file) {}

  void sendTopics() {
    rosbag::View all(bag_);
    for (const auto* connection : all.getConnections()) {
      const auto number = static_cast<std::uint32_t>(numbers_.size());
      const bool is_new =
          numbers_.insert({{connection->topic, connection->datatype}, number}).second;
      if (!is_new) continue;
      send(out_, BagRecord::kTopic, connection->topic + '\0' + connection->datatype);
    }
    send(out_, BagRecord::kContents);
  }

  void sendMessages(BagRecord::Kind kind) {
    rosbag::View view;
    view.addQuery(bag_, [kind](const rosbag::ConnectionInfo* connection) {
      return types().count(connection->datatype) > 0 &&
             isFixed(connection->topic) == (kind == BagRecord::kFixed);
    });
    for (const rosbag::MessageInstance& message : view) sendOne(message, kind);
  }

 private:
  void sendOne(const rosbag::MessageInstance& message, BagRecord::Kind kind) {
    ChildProcess::beat();
    const Type& type = types().at(message.getDataType());
    if (message.getMD5Sum() != type.checksum) return;  // another type of the same name
    const std::uint32_t topic = numbers_.at({message.getTopic(), message.getDataType()});
    try {
      bytes_.resize(message.size());
      ros::serialization::OStream stream(bytes_.data(), static_cast<std::uint32_t>(bytes_.size()));
      message.write(stream);
      type.read(bytes_);
    } catch (const rosbag::BagException&) {
      throw;
    } catch (const std::exception&) {  // runs past its end, or is longer than memory
      return send(out_, BagRecord::kBroken, topic);
    }
    send(out_, kind, topic, bytes_);
  }

  std::FILE* out_;
  rosbag::Bag bag_;
  std::map<std::pair<std::string, std::string>, std::uint32_t> numbers_;  // of topic and type
  Bytes bytes_;
};

}  // namespace

void sendBag(const std::string& file, std::FILE* out) {
  console_bridge::setLogLevel(console_bridge::CONSOLE_BRIDGE_LOG_NONE);
  try {
    BagSender sender(file, out);
    sender.sendTopics();
    try {
      for (const auto kind : {BagRecord::kFixed, BagRecord::kMessage}) sender.sendMessages(kind);
    } catch (const rosbag::BagException& error) {
      send(out, BagRecord::kStopped, error.what());
    }
    send(out, BagRecord::kEnd);
  } catch (const rosbag::BagException& error) {
    send(out, BagRecord::kFailed, error.what());
  }
}

}  // namespace adaptive_localization
