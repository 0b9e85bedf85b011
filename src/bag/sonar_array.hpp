// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/message_traits.h>
#include <ros/serialization.h>
#include <std_msgs/Header.h>

#include <cstdint>
#include <vector>

namespace adaptive_localization {

/// p2os_msgs/SonarArray by its fields: not every distribution has its package.
struct SonarArray {
  std_msgs::Header header;  // p2os leaves frame_id empty
  std::int32_t ranges_count{0};
  std::vector<double> ranges;  // m, of sonar 0, 1 and so on
};

}  // namespace adaptive_localization

namespace ros {
namespace message_traits {

template <>
struct DataType<adaptive_localization::SonarArray> {
  static const char* value() { return "p2os_msgs/SonarArray"; }
};

template <>
struct MD5Sum<adaptive_localization::SonarArray> {
  static const char* value() { return "2984921c09aef26ad253c7629937a5bb"; }
};

}  // namespace message_traits

namespace serialization {

template <>
struct Serializer<adaptive_localization::SonarArray> {
  template <class Stream, class Message>
  static void allInOne(Stream& stream, Message message) {
    stream.next(message.header);
    stream.next(message.ranges_count);
    stream.next(message.ranges);
  }
  ROS_DECLARE_ALLINONE_SERIALIZER
};

}  // namespace serialization
}  // namespace ros
