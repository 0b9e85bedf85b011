// SPDX-License-Identifier: BSD-3-Clause
#include "initial_pose.hpp"

#include <ros/console.h>

#include <algorithm>
#include <cmath>

#include "adaptive_localization/core/options.hpp"
#include "conversions.hpp"

namespace adaptive_localization {
namespace {

/// Within the ranges of initial_pose_* and initial_cov_*: it is kept there for the next start.
bool isUsable(const Gaussian2& prior) {
  constexpr double kRounded = 1.001;
  const Eigen::Array3d variances = prior.covariance.diagonal();
  const double most_xy = kRounded * std::sqrt(variances[0] * variances[1]);
  const double xy = std::max(std::abs(prior.covariance(0, 1)), std::abs(prior.covariance(1, 0)));
  return isPlace(prior.mean) && prior.covariance.allFinite() &&
         variances.minCoeff() >= kVariance.low && variances.maxCoeff() <= kVariance.high &&
         xy <= most_xy;
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
        "Initial pose ignored: got (%g, %g) m, %g rad with variances %g, %g, %g and a covariance "
        "of "
        "x and y of %g and %g, expected numbers within %g m, variances from %g to %g and a "
        "covariance that they allow",
        prior.mean.x, prior.mean.y, prior.mean.theta, prior.covariance(0, 0),
        prior.covariance(1, 1), prior.covariance(2, 2), prior.covariance(0, 1),
        prior.covariance(1, 0), kFarthest, kVariance.low, kVariance.high);
    return std::nullopt;
  }
  const auto& q = message.pose.pose.orientation;
  if (q.x == 0.0 && q.y == 0.0 && q.z == 0.0 && q.w == 0.0) {
    ROS_WARN("The initial pose has no orientation, its heading is taken as 0");
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
