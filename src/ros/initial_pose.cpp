// SPDX-License-Identifier: BSD-3-Clause
#include "initial_pose.hpp"

#include <ros/console.h>

#include <cmath>

#include "adaptive_localization/core/options.hpp"
#include "conversions.hpp"

namespace adaptive_localization {
namespace {

/// Within the ranges of initial_pose_* and initial_cov_*: it is kept there for the next start.
bool isUsable(const Gaussian2& prior) {
  const Eigen::Array3d variances = prior.covariance.diagonal();
  return isFinite(prior.mean) && std::abs(prior.mean.x) <= kCoordinate.high &&
         std::abs(prior.mean.y) <= kCoordinate.high && prior.covariance.allFinite() &&
         variances.minCoeff() >= kVariance.low && variances.maxCoeff() <= kVariance.high;
}

}  // namespace

std::optional<Gaussian2> readInitialPose(const geometry_msgs::PoseWithCovarianceStamped& message,
                                         const std::string& map_frame, const Odometry& odometry) {
  const std::string frame = withoutLeadingSlash(message.header.frame_id);
  if (frame.empty()) {
    ROS_WARN("The initial pose has no frame, taken as '%s'", map_frame.c_str());
  } else if (frame != map_frame) {
    ROS_WARN("Initial pose ignored: got frame '%s', expected '%s'", frame.c_str(),
             map_frame.c_str());
    return std::nullopt;
  }
  Gaussian2 prior = toGaussian(message.pose);
  if (!isUsable(prior)) {
    ROS_WARN(
        "Initial pose ignored: got (%g, %g) m with variances %g, %g, %g, expected numbers within "
        "%g m and variances from %g to %g",
        prior.mean.x, prior.mean.y, prior.covariance(0, 0), prior.covariance(1, 1),
        prior.covariance(2, 2), kCoordinate.high, kVariance.low, kVariance.high);
    return std::nullopt;
  }
  std::string why;
  if (const auto motion = odometry.motionSince(message.header.stamp, &why)) {
    prior.mean = prior.mean * *motion;
  } else if (odometry.at(ros::Time(0))) {
    ROS_WARN("Initial pose taken as that of now, its stamp is not in tf: %s", why.c_str());
  }
  ROS_INFO("Initial pose (%.3f, %.3f) m, %.1f deg", prior.mean.x, prior.mean.y,
           prior.mean.theta * 180.0 / kPi);
  return prior;
}

}  // namespace adaptive_localization
