// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/serialization.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bag_record.hpp"

namespace adaptive_localization {

/// A message of a bag, as recorded.
struct BagMessage {
  std::string topic, type;
  bool is_fixed{false};   // of /tf_static
  bool is_broken{false};  // what was recorded is no message of that type, and left out
  std::vector<std::uint8_t> bytes;

  /// The message, if it is one of that type.
  template <class Message>
  std::optional<Message> as() const {
    if (is_broken || type != ros::message_traits::DataType<Message>::value()) return std::nullopt;
    ros::serialization::IStream stream(const_cast<std::uint8_t*>(bytes.data()),
                                       static_cast<std::uint32_t>(bytes.size()));
    Message message;
    ros::serialization::deserialize(stream, message);
    return message;
  }
};

/// The laser scans, transforms, odometry, poses and what other senses tell of a bag, in the order
/// of recording but for what is on /tf_static, which comes first, whenever it was recorded.
///
/// A damaged bag can crash the library that reads bags, or keep it busy for ever: so that works in
/// a process of its own, which is born with the stream. Best before there are threads.
class BagStream {
 public:
  /// Throws std::runtime_error if there can be no process.
  explicit BagStream(const std::string& file);

  /// The topics of the bag with their types.
  /// Throws std::invalid_argument saying that the bag cannot be read or is damaged, and why.
  const std::map<std::string, std::string>& types();

  /// The next message; none at the end. Throws as types() does.
  std::optional<BagMessage> next();

  /// Why there were no more messages, though the bag goes on; empty if it does not.
  const std::string& whyStopped() const { return why_stopped_; }

 private:
  BagRecord receive();
  [[noreturn]] void sayDamaged();

  ChildProcess reader_;
  bool has_contents_{false};
  bool is_over_{false};
  std::map<std::string, std::string> types_;
  std::vector<std::pair<std::string, std::string>> topics_;  // with their types, by number
  std::string why_stopped_;
};

}  // namespace adaptive_localization
