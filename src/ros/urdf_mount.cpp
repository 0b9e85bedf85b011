// SPDX-License-Identifier: BSD-3-Clause
#include "urdf_mount.hpp"

#include <tinyxml.h>
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

// urdfdom's own parser of sensors wants an attribute that the URDF format does not have.
AngleLimits viewFromUrdf(const std::string& urdf, const std::string& sensor_frame) {
  TiXmlDocument document;
  document.Parse(urdf.c_str());
  TiXmlHandle robot = TiXmlHandle(&document).FirstChildElement("robot");
  for (TiXmlElement* sensor = robot.FirstChildElement("sensor").ToElement(); sensor;
       sensor = sensor->NextSiblingElement("sensor")) {
    TiXmlHandle element(sensor);
    const TiXmlElement* parent = element.FirstChildElement("parent").ToElement();
    const char* link = parent ? parent->Attribute("link") : nullptr;
    if (!link || sensor_frame != link) continue;
    const TiXmlElement* sweep =
        element.FirstChildElement("ray").FirstChildElement("horizontal").ToElement();
    double low = 0.0;
    double high = 0.0;
    const bool limited = sweep && sweep->QueryDoubleAttribute("min_angle", &low) == TIXML_SUCCESS &&
                         sweep->QueryDoubleAttribute("max_angle", &high) == TIXML_SUCCESS;
    constexpr double kMargin = kPi / 360.0;
    if (limited && low < high) return {low - kMargin, high + kMargin};
  }
  return {};
}

}  // namespace adaptive_localization
