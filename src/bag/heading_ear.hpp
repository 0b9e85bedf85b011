// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>

#include "bag_stream.hpp"
#include "core/heading_history.hpp"
#include "core/heading_topics.hpp"
#include "heading_messages.hpp"

namespace adaptive_localization {

/// What was heard of one sense.
struct Heard {
  int received{0};
  int dropped{0};
};

/// Hears a compass and a gyroscope, by messages live or from a bag. What cannot be used is dropped,
/// counted, and said why.
class HeadingEar {
 public:
  /// How a sensor's frame sits on base; throws std::exception saying why if nobody knows.
  using RotationOf = std::function<Eigen::Matrix3d(const std::string& frame)>;
  /// Told which of the senses a message is of, "compass" or "gyroscope", and what is wrong with it.
  using Complain = std::function<void(const std::string& sense, const std::string& why)>;

  HeadingEar(const HeadingTopics& topics, RotationOf rotation_of, Complain complain)
      : topics_(topics), rotation_of_(std::move(rotation_of)), complain_(std::move(complain)) {}

  void hear(const sensor_msgs::Imu& message);
  void hear(const sensor_msgs::MagneticField& message);
  void hear(const geometry_msgs::QuaternionStamped& message);

  /// If it is on one of the topics, with or without the slash in front.
  void hear(const BagMessage& message);

  HeadingHistory& history() { return history_; }
  const HeadingHistory& history() const { return history_; }
  const Heard& headings() const { return headings_; }
  const Heard& rates() const { return rates_; }

 private:
  template <class Message>
  void hearHeading(const Message& message);
  template <class Message, class Use>
  void use(const std::string& sense, Heard& heard, const Message& message, const Use& how);

  const HeadingTopics& topics_;  // the owner's, which may change
  RotationOf rotation_of_;
  Complain complain_;
  HeadingHistory history_;
  Heard headings_, rates_;
};

}  // namespace adaptive_localization
