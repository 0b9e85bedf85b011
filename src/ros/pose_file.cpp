// SPDX-License-Identifier: BSD-3-Clause
#include "pose_file.hpp"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <stdexcept>

#include "adaptive_localization/core/options.hpp"
#include "core/whole_file.hpp"

namespace adaptive_localization {
namespace {

/// Like a node's initial pose, but nothing goes without saying.
struct PoseOptions {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  double x{kNone}, y{kNone}, a{kNone}, xx{kNone}, yy{kNone}, aa{kNone};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("initial_pose_x", x, kCoordinate, "m", "");
    option("initial_pose_y", y, kCoordinate, "m", "");
    option("initial_pose_a", a, kCoordinate, "rad", "");
    option("initial_cov_xx", xx, kVariance, "m^2", "");
    option("initial_cov_yy", yy, kVariance, "m^2", "");
    option("initial_cov_aa", aa, kVariance, "rad^2", "");
  }
};

}  // namespace

std::optional<Gaussian2> readPoseFile(const std::string& path) {
  if (!std::ifstream(path)) return std::nullopt;
  Parameters parameters;
  parameters.load(path);
  const auto values = parameters.read<PoseOptions>();
  Gaussian2 pose;
  pose.mean = {values.x, values.y, values.a};
  pose.covariance.diagonal() << values.xx, values.yy, values.aa;
  if (!isFinite(pose.mean) || !pose.covariance.allFinite()) {
    throw std::invalid_argument(path +
                                ": expected six finite numbers, initial_pose_x, _y, _a and "
                                "initial_cov_xx, _yy, _aa");
  }
  return pose;
}

void writePoseFile(const std::string& path, const Gaussian2& pose) {
  char text[400];
  std::snprintf(text, sizeof text,
                "initial_pose_x: %.9g\ninitial_pose_y: %.9g\ninitial_pose_a: %.9g\n"
                "initial_cov_xx: %.9g\ninitial_cov_yy: %.9g\ninitial_cov_aa: %.9g\n",
                pose.mean.x, pose.mean.y, pose.mean.theta, pose.covariance(0, 0),
                pose.covariance(1, 1), pose.covariance(2, 2));
  writeWholeFile(path, text);
}

}  // namespace adaptive_localization
