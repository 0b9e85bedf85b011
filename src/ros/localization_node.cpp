// SPDX-License-Identifier: BSD-3-Clause
#include "localization_node.hpp"

#include <chrono>
#include <stdexcept>
#include <utility>

#include "conversions.hpp"
#include "ros_params.hpp"

namespace adaptive_localization {
namespace {

NodeOptions readNodeOptions(const Parameters& parameters) {
  auto options = parameters.read<NodeOptions>();
  for (auto* frame : {&options.odom_frame_id, &options.base_frame_id, &options.global_frame_id}) {
    *frame = withoutLeadingSlash(*frame);
  }
  return options;
}

std::optional<Prior> startOf(const NodeOptions& options) {
  if (options.start == "wait") return std::nullopt;
  if (options.start == "anywhere") return Anywhere{};
  return options.initialPose();
}

/// Makes a localizer on a map of one cell: wrong parameters show at the start, not with the map.
void checkAndReport(const Parameters& parameters, const NodeOptions& options) {
  const auto cell =
      std::make_shared<const OccupancyGrid>(Lattice(1, 1, 1.0, {}), std::vector<std::int8_t>{0});
  const Localizer localizer(parameters, cell);
  reportUnknown(localizer.unknownKeys());
  std::string text;
  const auto append = [&text](const std::vector<OptionDescription>& rows) {
    for (const auto& row : rows) text += "\n  " + row.key + ": " + toText(row.value);
  };
  append(describe(options));
  append(localizer.effectiveOptions());
  ROS_INFO("Options in effect:%s", text.c_str());
}

}  // namespace

LocalizationNode::LocalizationNode(ros::NodeHandle node, ros::NodeHandle private_node)
    : parameters_(readParameters(private_node)),
      options_(readNodeOptions(parameters_)),
      prior_((checkAndReport(parameters_, options_), startOf(options_))),
      tf_listener_(tf_),
      odometry_(tf_, options_.odom_frame_id, options_.base_frame_id),
      publisher_(node, private_node, options_),
      pose_keeper_(private_node, options_.save_pose_rate),
      scans_(node, tf_, options_.odom_frame_id, options_.base_frame_id,
             [this](const auto& scan, const auto& mount) { return onScan(scan, mount); }),
      initial_pose_(node.subscribe("initialpose", 2, &LocalizationNode::onInitialPose, this)),
      global_localization_(node.advertiseService("global_localization",
                                                 &LocalizationNode::onGlobalLocalization, this)),
      no_motion_update_(node.advertiseService("request_nomotion_update",
                                              &LocalizationNode::onNoMotionUpdate, this)),
      maps_(node, options_.use_map_topic, options_.first_map_only,
            [this](const auto& map) { return onMap(map); }) {}

bool LocalizationNode::onMap(const nav_msgs::OccupancyGrid& message) {
  const std::string frame = withoutLeadingSlash(message.header.frame_id);
  if (frame != options_.global_frame_id) {
    ROS_WARN("The map's frame is '%s', but global_frame_id is '%s'", frame.c_str(),
             options_.global_frame_id.c_str());
  }
  try {
    const auto map = std::make_shared<const OccupancyGrid>(toGrid(message));
    if (localizer_) {
      localizer_->setMap(map);
    } else {
      localizer_ = std::make_unique<Localizer>(parameters_, map);
      if (prior_) start(*prior_);
    }
  } catch (const std::invalid_argument& error) {
    ROS_ERROR_THROTTLE(10.0, "Map not used: %s", error.what());
    return false;
  }
  ROS_INFO("Map of %u x %u cells of %.3f m", message.info.width, message.info.height,
           static_cast<double>(message.info.resolution));
  return true;
}

bool LocalizationNode::onScan(const sensor_msgs::LaserScan& message, const LaserMount& mount) {
  if (!localizer_) {
    ROS_WARN_DELAYED_THROTTLE(5.0, "Scans wait for the map");
    return false;
  }
  const ros::Time& stamp = message.header.stamp;
  std::string why;
  const auto T_odom_base = odometry_.at(stamp, &why);
  if (!T_odom_base) throw std::invalid_argument(why);
  const Scan scan = toScan(toLaserScan(message), mount, localizer_->scanOptions());
  if (scan.hits() == 0 && scan.no_return_bearing.size() == 0) {
    throw std::invalid_argument("none of its " + std::to_string(message.ranges.size()) +
                                " ranges is valid");
  }
  const auto begin = std::chrono::steady_clock::now();
  const Localization answer = localizer_->update(*T_odom_base, {stamp.toSec(), scan});
  const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - begin;
  if (answer.updated) ms_per_update_ = spent.count();

  const Particles& particles = localizer_->hypotheses();
  if (answer.status != Status::kUninitialised) {
    publisher_.publish(answer, particles, stamp);
    pose_keeper_.keep({answer.T_map_base, answer.estimate.covariance}, stamp);
  }
  publisher_.publishStatus(answer, particles.size(), ms_per_update_, scans_.counts());
  return true;
}

void LocalizationNode::onInitialPose(const geometry_msgs::PoseWithCovarianceStamped& message) {
  const std::string frame = withoutLeadingSlash(message.header.frame_id);
  if (frame.empty()) {
    ROS_WARN("The initial pose has no frame, taken as '%s'", options_.global_frame_id.c_str());
  } else if (frame != options_.global_frame_id) {
    ROS_WARN("Initial pose ignored: got frame '%s', expected '%s'", frame.c_str(),
             options_.global_frame_id.c_str());
    return;
  }
  Gaussian2 prior = toGaussian(message.pose);
  if (!isFinite(prior.mean) || !prior.covariance.allFinite() ||
      prior.covariance.diagonal().minCoeff() < 0.0) {
    ROS_WARN("Initial pose ignored: expected finite numbers and variances that are not negative");
    return;
  }
  // The pose was true at its stamp; the robot may have moved since.
  std::string why;
  if (const auto motion = odometry_.motionSince(message.header.stamp, &why)) {
    prior.mean = prior.mean * *motion;
  } else if (localizer_) {
    ROS_WARN("Initial pose taken as that of now, its stamp is not in tf: %s", why.c_str());
  }
  start(prior);
  ROS_INFO("Initial pose (%.3f, %.3f) m, %.1f deg", prior.mean.x, prior.mean.y,
           prior.mean.theta * 180.0 / kPi);
}

bool LocalizationNode::onGlobalLocalization(Empty::Request&, Empty::Response&) {
  ROS_INFO("Localizing anywhere on the map");
  start(Anywhere{});
  return true;
}

bool LocalizationNode::onNoMotionUpdate(Empty::Request&, Empty::Response&) {
  if (localizer_) localizer_->requestUpdate();
  return true;
}

void LocalizationNode::start(const Prior& prior) {
  if (localizer_) {
    localizer_->reset(prior);
  } else {
    prior_ = prior;
  }
}

}  // namespace adaptive_localization
