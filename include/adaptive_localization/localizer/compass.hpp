// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "adaptive_localization/core/observations.hpp"
#include "adaptive_localization/core/options.hpp"
#include "adaptive_localization/core/pose2.hpp"

namespace adaptive_localization {

struct CompassOptions {
  double heading_offset{0.0};
  double heading_offset_std{kPi};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("heading_offset", heading_offset, Range{-kPi, kPi}, "rad",
           "Yaw in the map frame of a robot whose compass reads 0.");
    option("heading_offset_std", heading_offset_std, Range{0, kPi}, "rad",
           "Standard deviation of heading_offset; pi: unknown, it is learned while tracking.");
  }
};

/// Turns a compass's headings into the map's,
///
///     theta_map = reading + offset,   deviation^2 = reading's^2 + offset's^2,
///
/// and learns the offset where scans tell the pose, as a Kalman filter does. There it finds as well
/// whether the compass is disturbed, by steel in a floor say: what scans explain, a compass does
/// not contradict. A disturbed one is not heard until it agrees again, or has gone on telling
/// another offset for so long a way that this is the true one.
class Compass {
 public:
  explicit Compass(const CompassOptions& options = {});

  /// Other options from now on: what was learned is kept if they are the same.
  void configure(const CompassOptions& options);

  /// Forgets what was learned.
  void reset() { *this = Compass(options_); }

  /// In the map; nothing where the offset is unknown or the compass disturbed.
  std::optional<Heading> inMap(const std::optional<Heading>& reading) const;

  /// Compares a reading with the robot's yaw in the map, rad, and its variance, as scans tell it.
  /// way: m or rad since the last comparison; a robot that stands still tells nothing new.
  void compare(const Heading& reading, double yaw, double variance, double way);

  bool isKnown() const;  // the offset
  bool isDisturbed() const { return is_disturbed_; }
  double offset() const { return known_.offset; }  // rad

  /// What becomes of a reading, for a reader: "used", "offset not learned yet", "disturbed".
  std::string state() const;

 private:
  struct Belief {
    double offset;    // rad
    double variance;  // rad^2
    double way{0.0};  // on which readings agreed with it, m or rad
  };

  static bool agree(const Belief& belief, double offset, double variance);
  static void learn(double offset, double variance, double way, Belief& belief);

  CompassOptions options_;
  Belief known_;
  std::optional<Belief> other_;  // what a disturbed compass tells
  double doubt_{0.0};            // way of disagreement, less that of agreement
  bool is_disturbed_{false};
};

}  // namespace adaptive_localization
