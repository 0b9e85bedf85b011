// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

#include <optional>
#include <string>

#include "adaptive_localization/core/belief.hpp"
#include "parameter_writer.hpp"

namespace adaptive_localization {

/// Keeps the pose on the parameter server, in initial_pose_* and initial_cov_*, and
/// in a file if there is one, so that a node started again begins where this one ended.
class PoseKeeper {
 public:
  /// `rate` in Hz; not above 0: keeps nothing. `file`: written too, unless empty.
  PoseKeeper(ParameterWriter& parameters, double rate, std::string file);

  /// Not above 0: forgets the last pose, which is old by the time the node ends.
  void setRate(double rate);

  /// Takes a new pose and writes it when it is time.
  void keep(const Gaussian2& pose, const ros::Time& stamp);

  /// Writes the last pose taken, if any.
  void write() const;

 private:
  void writeFile() const;

  ParameterWriter& parameters_;
  double rate_;
  std::string file_;
  std::optional<Gaussian2> pose_;
  ros::Time written_;
};

}  // namespace adaptive_localization
