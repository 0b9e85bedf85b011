// SPDX-License-Identifier: BSD-3-Clause
#include "simulator_node.hpp"

#include <rosgraph_msgs/Clock.h>
#include <sensor_msgs/LaserScan.h>
#include <visualization_msgs/MarkerArray.h>

#include <cmath>
#include <stdexcept>

#include "callbacks.hpp"
#include "conversions.hpp"
#include "core/suggestion.hpp"
#include "paint_markers.hpp"
#include "ros_params.hpp"
#include "simulator_messages.hpp"
#include "truth_markers.hpp"

namespace adaptive_localization {
namespace {

constexpr double kClockEpoch = 100.0;  // s: simulated stamps are not near 0, which means "unset"
constexpr double kTick = 0.01;         // s of real time between two looks at the clock
constexpr double kCatchUp = 0.2;       // s of real time; what a slow machine lost before stays lost
constexpr int kQueue = 2000;           // what catching up sends at once, at the highest of speeds

SimulatorNodeOptions readOptions(const Parameters& parameters) {
  SimulatorNodeOptions defaults;
  ros::param::get("/use_sim_time", defaults.publish_clock);
  const auto options = parameters.read(defaults);
  if (options.speed != 1.0 && !options.publish_clock) {
    throw std::invalid_argument("option 'speed': got " + std::to_string(options.speed) +
                                " without publish_clock, expected 1");
  }
  if (options.lock_step && !options.publish_clock) {
    throw std::invalid_argument(
        "option 'lock_step': got true without publish_clock, expected false");
  }
  return options;
}

std::vector<std::string> knownKeys() {
  std::vector<std::string> keys = keysOf(describe(SimulatorNodeOptions{}));
  for (const auto& key : keysOf(describe(SimulationOptions{}))) keys.push_back(key);
  return keys;
}

}  // namespace

SimulatorNode::SimulatorNode(ros::NodeHandle node, ros::NodeHandle private_node)
    : SimulatorNode(node, private_node, readParameters(private_node)) {}

SimulatorNode::SimulatorNode(ros::NodeHandle node, ros::NodeHandle private_node,
                             const Parameters& parameters)
    : options_(readOptions(parameters)),
      simulation_(Simulation::load(SimulationOptions::from(parameters))),
      epoch_(options_.publish_clock ? ros::Time(kClockEpoch) : ros::Time::now()),
      wall_epoch_(ros::WallTime::now()) {
  reportUnknown(parameters.unknownKeys(), knownKeys());
  if (options_.publish_clock) clock_ = node.advertise<rosgraph_msgs::Clock>("/clock", 10);
  odometry_ = node.advertise<nav_msgs::Odometry>("odom", kQueue);
  scan_ = node.advertise<sensor_msgs::LaserScan>("scan", kQueue);
  if (simulation_.hasImu()) imu_ = node.advertise<sensor_msgs::Imu>("imu", kQueue);
  if (simulation_.hasCamera()) {
    landmarks_ = node.advertise<sensor_msgs::PointCloud>("landmarks", kQueue);
  }
  if (simulation_.hasSonars()) sonar_ = node.advertise<sensor_msgs::Range>("sonar", kQueue);
  truth_ = node.advertise<nav_msgs::Odometry>("base_pose_ground_truth", kQueue);
  markers_ = private_node.advertise<visualization_msgs::MarkerArray>("truth_markers", 1);
  const Paint& paint = simulation_.paint();
  if (paint.carpet || !paint.lines.empty()) {
    paint_ = private_node.advertise<visualization_msgs::MarkerArray>("paint", 1, true);
    publishPaint();
  }
  if (options_.publish_laser_tf) publishSensorFrames();
  transforms_ = subscribe<tf2_msgs::TFMessage>(
      node, "/tf", kQueue, [this](const auto& message) { onTransforms(*message); });
  command_ = subscribe<geometry_msgs::Twist>(node, "cmd_vel", 1,
                                             [this](const auto& message) { onCommand(*message); });
  kidnap_ = subscribe<geometry_msgs::PoseStamped>(
      node, "kidnap", 1, [this](const auto& message) { onKidnap(*message); });
  if (simulation_.hasImu()) {
    disturbance_ = subscribe<std_msgs::Float64>(
        node, "disturb_compass", 1, [this](const auto& message) { onDisturbance(*message); });
  }
  kidnap_random_ = serve<std_srvs::Empty>(node, "kidnap_random",
                                          [this](auto&, auto&) { return onKidnapRandom(); });
  reset_ =
      serve<std_srvs::Empty>(node, "reset_positions", [this](auto&, auto&) { return onReset(); });
  timer_ = every(node, ros::WallDuration(kTick), "Simulation", [this] { advance(); });
  reportPlace("Simulated Pioneer 3-DX starts");
}

void SimulatorNode::advance() {
  double behind =
      (ros::WallTime::now() - wall_epoch_).toSec() - simulation_.time() / options_.speed;
  if (behind > kCatchUp) {
    wall_epoch_ += ros::WallDuration(behind - kCatchUp);
    behind = kCatchUp;
  }
  for (auto steps = std::floor(behind * options_.speed / Simulation::kStep);
       steps >= 1.0 && !mustWait(); --steps) {
    const Sensed sensed = simulation_.step();
    if (options_.publish_clock) {
      rosgraph_msgs::Clock clock;
      clock.clock = toRosTime(simulation_.time());
      clock_.publish(clock);
    }
    publish(sensed);
  }
}

/// Once somebody localizes the robot, and as long as one may hope that this goes on.
bool SimulatorNode::mustWait() const {
  constexpr double kLag = 0.5;        // s; more than between scans
  constexpr double kPatience = 30.0;  // s of real time
  if (!options_.lock_step || localized_.isZero()) return false;
  return (toRosTime(simulation_.time()) - localized_).toSec() > kLag &&
         (ros::WallTime::now() - localized_at_).toSec() < kPatience;
}

void SimulatorNode::onTransforms(const tf2_msgs::TFMessage& message) {
  for (const auto& transform : message.transforms) {
    if (withoutLeadingSlash(transform.header.frame_id) != options_.global_frame_id) continue;
    simulation_.localize(toPose2(transform.transform));
    localized_ = transform.header.stamp;
    localized_at_ = ros::WallTime::now();
  }
}

/// Makes a message if somebody hears it.
template <class Make>
void SimulatorNode::send(const ros::Publisher& publisher, double stamp, const std::string& frame,
                         const Make& make) {
  if (publisher.getNumSubscribers() == 0) return;
  auto message = make();
  message.header.stamp = toRosTime(stamp);
  message.header.frame_id = frame;
  publisher.publish(message);
}

/// Odometry first, so that whoever gets the scan can place it.
void SimulatorNode::publish(const Sensed& sensed) {
  if (sensed.odometry) publishOdometry(*sensed.odometry);
  if (sensed.imu) {
    send(imu_, sensed.imu->stamp, options_.imu_frame, [&] { return toMessage(*sensed.imu); });
  }
  if (sensed.picture) {
    send(landmarks_, sensed.picture->stamp, options_.camera_frame,
         [&] { return toMessage(*sensed.picture); });
  }
  for (const Ping& ping : sensed.pings) publishPing(ping);
  if (!sensed.scan) return;
  if (!sensed.scan->ranges.empty()) publishScan(*sensed.scan, options_.laser_frame);
  if (sensed.second_scan) publishScan(*sensed.second_scan, options_.second_laser_frame);
  if (markers_.getNumSubscribers() > 0) publishMarkers();
}

void SimulatorNode::publishOdometry(const OdometryReading& reading) {
  geometry_msgs::TransformStamped transform;
  transform.header.stamp = toRosTime(reading.stamp);
  transform.header.frame_id = options_.odom_frame_id;
  transform.child_frame_id = options_.base_frame_id;
  transform.transform = toTransformMessage(reading.T_odom_base);
  tf_.sendTransform(transform);

  const auto make = [this](const Pose2& pose, const Velocity& velocity) {
    nav_msgs::Odometry message = toMessage(pose, velocity);
    message.child_frame_id = options_.base_frame_id;
    return message;
  };
  send(odometry_, reading.stamp, options_.odom_frame_id,
       [&] { return make(reading.T_odom_base, reading.velocity); });
  send(truth_, reading.stamp, options_.global_frame_id,
       [&] { return make(simulation_.truth(), simulation_.velocity()); });
}

void SimulatorNode::publishScan(const LaserScan& scan, const std::string& frame) {
  send(scan_, scan.stamp, frame, [&] {
    sensor_msgs::LaserScan message = toMessage(scan);
    message.scan_time = 1.0F / 75.0F;
    return message;
  });
}

void SimulatorNode::publishPing(const Ping& ping) {
  send(sonar_, ping.stamp, options_.sonar_frame_prefix + std::to_string(ping.sonar),
       [&] { return toMessage(simulation_.reading(ping)); });
}

void SimulatorNode::publishMarkers() {
  std_msgs::Header header;
  header.stamp = toRosTime(simulation_.time());
  header.frame_id = options_.global_frame_id;
  markers_.publish(truthMarkers(header, simulation_.truth(), simulation_.people()));
}

/// At no time in particular: it is there for good.
void SimulatorNode::publishPaint() {
  std_msgs::Header header;
  header.frame_id = options_.global_frame_id;
  paint_.publish(paintMarkers(header, simulation_.paint()));
}

void SimulatorNode::publishSensorFrames() {
  constexpr double kSonarHeight = 0.209;  // m
  std::vector<geometry_msgs::TransformStamped> transforms;
  const auto add = [&](const std::string& frame, const Pose2& T_base_sensor, double z) {
    geometry_msgs::TransformStamped transform;
    transform.header.stamp = epoch_;
    transform.header.frame_id = options_.base_frame_id;
    transform.child_frame_id = frame;
    transform.transform = toTransformMessage(T_base_sensor);
    transform.transform.translation.z = z;
    transforms.push_back(transform);
  };
  for (const Pose2& mount : simulation_.laserMounts()) {
    add(transforms.empty() ? options_.laser_frame : options_.second_laser_frame, mount,
        options_.laser_z);
  }
  if (simulation_.hasImu()) add(options_.imu_frame, {}, 0.0);
  if (simulation_.hasCamera()) add(options_.camera_frame, {}, 0.0);
  for (std::size_t i = 0; simulation_.hasSonars() && i < Sonars::kCount; ++i) {
    add(options_.sonar_frame_prefix + std::to_string(i), Sonars::mounts()[i], kSonarHeight);
  }
  static_tf_.sendTransform(transforms);
}

void SimulatorNode::onCommand(const geometry_msgs::Twist& message) {
  simulation_.command({message.linear.x, message.angular.z, message.linear.y});
}

void SimulatorNode::onKidnap(const geometry_msgs::PoseStamped& message) {
  const Pose2 pose = toPose2(message.pose);
  if (withoutLeadingSlash(message.header.frame_id) != options_.global_frame_id || !isFinite(pose)) {
    ROS_WARN("kidnap: got a pose in frame '%s', expected a finite one in '%s'; ignored",
             message.header.frame_id.c_str(), options_.global_frame_id.c_str());
    return;
  }
  simulation_.kidnap(pose);
  reportPlace("Robot carried");
}

void SimulatorNode::onDisturbance(const std_msgs::Float64& message) {
  if (!std::isfinite(message.data)) {
    ROS_WARN("disturb_compass: got %g, expected an angle in radians; ignored", message.data);
    return;
  }
  simulation_.disturbCompass(message.data);
  ROS_INFO("Compass turned by %.0f deg", message.data * 180.0 / kPi);
}

bool SimulatorNode::onKidnapRandom() {
  simulation_.kidnapRandom();
  reportPlace("Robot carried");
  return true;
}

bool SimulatorNode::onReset() {
  simulation_.reset();
  reportPlace("Robot carried back");
  return true;
}

void SimulatorNode::reportPlace(const char* what) const {
  const Pose2& truth = simulation_.truth();
  ROS_INFO("%s: %.2f m, %.2f m, %.0f deg", what, truth.x, truth.y, truth.theta * 180.0 / kPi);
}

}  // namespace adaptive_localization
