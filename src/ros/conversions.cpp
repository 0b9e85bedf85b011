// SPDX-License-Identifier: BSD-3-Clause
#include "conversions.hpp"

#include <array>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace adaptive_localization {
namespace {

Eigen::Quaterniond toQuaternion(const geometry_msgs::Quaternion& message) {
  const Eigen::Quaterniond rotation(message.w, message.x, message.y, message.z);
  const double norm = rotation.norm();
  if (norm < 1e-6) return Eigen::Quaterniond::Identity();
  if (std::isfinite(norm)) return rotation.normalized();
  return Eigen::Quaterniond(Eigen::Vector4d::Constant(std::numeric_limits<double>::quiet_NaN()));
}

geometry_msgs::Quaternion toMessage(const Eigen::Quaterniond& rotation) {
  geometry_msgs::Quaternion message;
  message.x = rotation.x();
  message.y = rotation.y();
  message.z = rotation.z();
  message.w = rotation.w();
  return message;
}

geometry_msgs::Quaternion yawMessage(double yaw) {
  return toMessage(Eigen::Quaterniond(std::cos(yaw / 2.0), 0.0, 0.0, std::sin(yaw / 2.0)));
}

double yawOf(const geometry_msgs::Quaternion& message) {
  const Eigen::Quaterniond q = toQuaternion(message);
  return std::atan2(2.0 * (q.w() * q.z() + q.x() * q.y()),
                    1.0 - 2.0 * (q.y() * q.y() + q.z() * q.z()));
}

/// Throws unless the z axis stays upright, or nearly: what is tilted is no map of a floor.
void checkLevel(const geometry_msgs::Quaternion& message) {
  constexpr double kMost = 0.1;  // rad
  const double tilt = std::acos(std::fmin(toQuaternion(message).toRotationMatrix()(2, 2), 1.0));
  if (tilt > kMost) {
    throw std::invalid_argument("map origin: got a rotation that tilts it by " +
                                std::to_string(tilt) + " rad, expected one about z");
  }
}

int toSize(std::uint32_t cells, const char* name) {
  if (cells > static_cast<std::uint32_t>(std::numeric_limits<int>::max())) {
    throw std::invalid_argument(std::string("map ") + name + ": got " + std::to_string(cells) +
                                " cells, expected fewer");
  }
  return static_cast<int>(cells);
}

// Where (x, y, yaw) stand in a covariance over (x, y, z, roll, pitch, yaw).
constexpr std::array<std::size_t, 3> kAxes{0, 1, 5};

}  // namespace

void checkPlace(const std::string& frame, const std::string& parent, double x, double y,
                double most) {
  if (std::abs(x) <= most && std::abs(y) <= most) return;
  std::ostringstream text;
  text << "tf has '" << frame << "' at (" << x << ", " << y << ") m in '" << parent
       << "', expected numbers within " << most << " m";
  throw std::runtime_error(text.str());
}

LaserScan toLaserScan(const sensor_msgs::LaserScan& message) {
  LaserScan scan;
  scan.stamp = message.header.stamp.toSec();
  scan.angle_min = message.angle_min;
  scan.angle_increment = message.angle_increment;
  scan.time_increment = message.time_increment;
  scan.range_min = message.range_min;
  scan.range_max = message.range_max;
  scan.ranges = message.ranges;
  scan.intensities = message.intensities;
  return scan;
}

sensor_msgs::LaserScan toMessage(const LaserScan& scan) {
  sensor_msgs::LaserScan message;
  const auto last = static_cast<double>(scan.ranges.size() - 1);
  message.angle_min = static_cast<float>(scan.angle_min);
  message.angle_max = static_cast<float>(scan.angle_min + last * scan.angle_increment);
  message.angle_increment = static_cast<float>(scan.angle_increment);
  message.time_increment = static_cast<float>(scan.time_increment);
  message.range_min = static_cast<float>(scan.range_min);
  message.range_max = static_cast<float>(scan.range_max);
  message.ranges = scan.ranges;
  message.intensities = scan.intensities;
  return message;
}

OccupancyGrid toGrid(const nav_msgs::OccupancyGrid& message, bool origin_is_cell_center) {
  checkLevel(message.info.origin.orientation);
  const auto resolution = static_cast<double>(message.info.resolution);
  const double shift = origin_is_cell_center ? -resolution / 2.0 : 0.0;
  const Lattice lattice(toSize(message.info.width, "width"), toSize(message.info.height, "height"),
                        resolution, toPose2(message.info.origin) * Pose2{shift, shift, 0.0});
  return OccupancyGrid(lattice, message.data);
}

nav_msgs::OccupancyGrid toMessage(const OccupancyGrid& grid) {
  nav_msgs::OccupancyGrid message;
  message.info.width = static_cast<std::uint32_t>(grid.lattice().width());
  message.info.height = static_cast<std::uint32_t>(grid.lattice().height());
  message.info.resolution = static_cast<float>(grid.lattice().resolution());
  message.info.origin = toPoseMessage(grid.lattice().origin());
  message.data = grid.cells();
  return message;
}

MapPatch toPatch(const map_msgs::OccupancyGridUpdate& message) {
  const auto size = [](std::uint32_t cells) {
    return cells > static_cast<std::uint32_t>(std::numeric_limits<int>::max())
               ? -1
               : static_cast<int>(cells);
  };
  return {{message.x, message.y}, size(message.width), size(message.height), message.data};
}

Pose2 toPose2(const geometry_msgs::Pose& message) {
  return {message.position.x, message.position.y, yawOf(message.orientation)};
}

Pose2 toPose2(const geometry_msgs::Transform& message) {
  return {message.translation.x, message.translation.y, yawOf(message.rotation)};
}

geometry_msgs::Pose toPoseMessage(const Pose2& pose) {
  geometry_msgs::Pose message;
  message.position.x = pose.x;
  message.position.y = pose.y;
  message.orientation = yawMessage(pose.theta);
  return message;
}

geometry_msgs::Transform toTransformMessage(const Pose2& pose) {
  geometry_msgs::Transform message;
  message.translation.x = pose.x;
  message.translation.y = pose.y;
  message.rotation = yawMessage(pose.theta);
  return message;
}

geometry_msgs::Transform toTransformMessage(const Eigen::Isometry3d& transform) {
  geometry_msgs::Transform message;
  message.translation.x = transform.translation().x();
  message.translation.y = transform.translation().y();
  message.translation.z = transform.translation().z();
  message.rotation = toMessage(Eigen::Quaterniond(transform.rotation()));
  return message;
}

LaserMount toMount(const geometry_msgs::Transform& message) {
  LaserMount mount;
  mount.position = {message.translation.x, message.translation.y};
  mount.axes = toQuaternion(message.rotation).toRotationMatrix().topLeftCorner<2, 2>();
  return mount;
}

Eigen::Isometry3d toIsometry(const geometry_msgs::Transform& message) {
  const auto& t = message.translation;
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.linear() = toQuaternion(message.rotation).toRotationMatrix();
  result.translation() = Eigen::Vector3d(t.x, t.y, t.z);
  return result;
}

Gaussian2 toGaussian(const geometry_msgs::PoseWithCovariance& message) {
  Gaussian2 gaussian;
  gaussian.mean = toPose2(message.pose);
  const auto& covariance = message.covariance;
  gaussian.covariance << covariance[0], covariance[1], 0.0,  //
      covariance[6], covariance[7], 0.0,                     //
      0.0, 0.0, covariance[35];
  return gaussian;
}

geometry_msgs::PoseWithCovariance toMessage(const Pose2& pose, const Eigen::Matrix3d& covariance) {
  geometry_msgs::PoseWithCovariance message;
  message.pose = toPoseMessage(pose);
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      message.covariance[6 * kAxes[row] + kAxes[column]] =
          covariance(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column));
    }
  }
  return message;
}

geometry_msgs::PoseArray toMessage(const Particles& particles) {
  geometry_msgs::PoseArray message;
  message.poses.reserve(static_cast<std::size_t>(particles.size()));
  for (Eigen::Index i = 0; i < particles.size(); ++i) {
    message.poses.push_back(toPoseMessage(particles.pose(i)));
  }
  return message;
}

}  // namespace adaptive_localization
