// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace adaptive_localization {

constexpr double kPi = 3.14159265358979323846;

/// The representative of an angle in (-pi, pi]. Every difference of headings goes through it.
inline double wrapAngle(double angle) {
  if (angle > -kPi && angle <= kPi) return angle;  // nearly always, and much faster
  const double wrapped = std::remainder(angle, 2.0 * kPi);
  return wrapped <= -kPi ? kPi : wrapped;
}

/// A pose in the plane, SE(2): x, y in metres, theta in radians, counter-clockwise positive.
/// `T_a_b` names the pose of frame b in frame a; it takes coordinates in b to coordinates in a.
struct Pose2 {
  double x{0.0};
  double y{0.0};
  double theta{0.0};
};

/// Composition: T_a_c = T_a_b * T_b_c.
inline Pose2 operator*(const Pose2& a, const Pose2& b) {
  const double c = std::cos(a.theta);
  const double s = std::sin(a.theta);
  return {a.x + c * b.x - s * b.y, a.y + s * b.x + c * b.y, wrapAngle(a.theta + b.theta)};
}

/// T_a_b * point_b = point_a.
inline Eigen::Vector2d operator*(const Pose2& a, const Eigen::Vector2d& point) {
  const double c = std::cos(a.theta);
  const double s = std::sin(a.theta);
  return {a.x + c * point.x() - s * point.y(), a.y + s * point.x() + c * point.y()};
}

/// A pose T_a_b that takes many points: its sine and cosine are computed once.
class Transform2 {
 public:
  explicit Transform2(const Pose2& T_a_b)
      : x_(T_a_b.x), y_(T_a_b.y), cos_(std::cos(T_a_b.theta)), sin_(std::sin(T_a_b.theta)) {}

  /// T_a_b * point_b = point_a.
  Eigen::Vector2d operator*(const Eigen::Vector2d& point) const {
    return {x_ + cos_ * point.x() - sin_ * point.y(), y_ + sin_ * point.x() + cos_ * point.y()};
  }

 private:
  double x_, y_, cos_, sin_;
};

/// T_b_a from T_a_b.
inline Pose2 inverse(const Pose2& a) {
  const double c = std::cos(a.theta);
  const double s = std::sin(a.theta);
  return {-c * a.x - s * a.y, s * a.x - c * a.y, wrapAngle(-a.theta)};
}

/// T_b_c from T_a_b and T_a_c: where c is as seen from b.
inline Pose2 between(const Pose2& T_a_b, const Pose2& T_a_c) {
  return inverse(T_a_b) * T_a_c;
}

/// Euclidean distance of the two positions, metres.
inline double distance(const Pose2& a, const Pose2& b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

/// How far a motion brought the robot to see something else: metres and radians together.
inline double wayOf(const Pose2& motion) {
  return std::hypot(motion.x, motion.y) + std::abs(motion.theta);
}

inline bool isFinite(const Pose2& a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.theta);
}

/// Farther from its frame's origin, doubles do not tell where a robot is from where it was.
constexpr double kFarthest = 1e9;  // m

inline bool isPlace(const Pose2& a) {
  return isFinite(a) && std::abs(a.x) <= kFarthest && std::abs(a.y) <= kFarthest;
}

}  // namespace adaptive_localization
