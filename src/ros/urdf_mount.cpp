// SPDX-License-Identifier: BSD-3-Clause
#include "urdf_mount.hpp"

#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

#include <stdexcept>

namespace adaptive_localization {
namespace {

Eigen::Isometry3d toIsometry(const urdf::Pose& pose) {
  Eigen::Isometry3d transform = Eigen::Isometry3d::Identity();
  const urdf::Rotation& q = pose.rotation;
  transform.linear() = Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized().toRotationMatrix();
  transform.translation() << pose.position.x, pose.position.y, pose.position.z;
  return transform;
}

}  // namespace

Eigen::Isometry3d mountFromUrdf(const std::string& urdf, const std::string& base_frame,
                                const std::string& sensor_frame) {
  const auto model = urdf::parseURDF(urdf);
  if (!model) throw std::invalid_argument("robot_description is no valid URDF");
  auto link = model->getLink(sensor_frame);
  if (!link) throw std::invalid_argument("robot_description has no link '" + sensor_frame + "'");
  Eigen::Isometry3d T_link_sensor = Eigen::Isometry3d::Identity();
  while (link->name != base_frame) {
    const auto& joint = link->parent_joint;
    if (!joint) {
      throw std::invalid_argument("robot_description: '" + sensor_frame + "' is not mounted on '" +
                                  base_frame + "'");
    }
    if (joint->type != urdf::Joint::FIXED) {
      throw std::invalid_argument("robot_description: joint '" + joint->name + "' between '" +
                                  base_frame + "' and '" + sensor_frame + "' is not fixed");
    }
    T_link_sensor = toIsometry(joint->parent_to_joint_origin_transform) * T_link_sensor;
    link = link->getParent();
  }
  return T_link_sensor;
}

}  // namespace adaptive_localization
