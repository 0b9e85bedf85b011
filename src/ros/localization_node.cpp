// SPDX-License-Identifier: BSD-3-Clause
#include "localization_node.hpp"

#include <chrono>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "callbacks.hpp"
#include "conversions.hpp"
#include "core/reflectors.hpp"
#include "observation/landmark_model.hpp"
#include "reconfigure_fields.hpp"
#include "ros_params.hpp"

namespace adaptive_localization {

LocalizationNode::LocalizationNode(ros::NodeHandle node, ros::NodeHandle private_node)
    : parameters_(withoutUntuned(readParameters(private_node))),
      options_(readNodeOptions(withCacheDir(parameters_))),
      prior_(startOf(options_)),
      tf_input_(tf_),
      odometry_(tf_, options_.odom_frame_id, options_.base_frame_id),
      publisher_(node, private_node, options_),
      display_(private_node, options_),
      parameter_writer_(private_node),
      pose_keeper_(parameter_writer_, options_.save_pose_rate, options_.pose_file),
      scans_(
          node, tf_, tf_input_, options_,
          [this](const auto& scan, const auto& mount, const auto& arrival) {
            return onScan(scan, mount, arrival);
          },
          [this](double seconds) { onTimeJump(seconds); }),
      headings_(node, tf_, odometry_, options_),
      landmarks_(
          node, tf_, tf_input_, odometry_, options_,
          knownLandmarks(parameters_.read<LandmarkOptions>()),
          [this](const auto& stamp, const auto& pose) { onOtherSense(stamp, pose); },
          [this](const auto& stamp, double seconds) { onOtherTimeJump(stamp, seconds); }),
      sonars_(
          node, tf_, odometry_, options_,
          [this](const auto& stamp, const auto& pose) { onOtherSense(stamp, pose); },
          [this](const auto& stamp, double seconds) { onOtherTimeJump(stamp, seconds); }),
      initial_pose_(subscribe<PoseWithCovarianceStamped>(
          node, "initialpose", 2, [this](const auto& message) { onInitialPose(*message); })),
      global_localization_(serve<std_srvs::Empty>(
          node, "global_localization", [this](auto&, auto&) { return onGlobalLocalization(); })),
      no_motion_update_(serve<std_srvs::Empty>(
          node, "request_nomotion_update", [this](auto&, auto&) { return onNoMotionUpdate(); })),
      set_map_(serve<nav_msgs::SetMap>(
          node, "set_map",
          [this](auto& request, auto& response) { return onSetMap(request, response); })),
      places_(node),
      map_builder_(
          node, options_, [this](BuiltMap& map) { onMap(map); }, [this] { return preparation(); },
          [this] { return places_.isBuilding(); }),
      maps_(
          node, options_.use_map_topic, options_.first_map_only,
          [this](auto&& map) { return map_builder_.build(std::move(map), !localizer_); },
          [this](const auto& update) { map_builder_.update(update); }),
      diagnostics_(node, options_, [this] { return health(); }),
      reconfigure_(private_node, parameter_writer_, parameters_,
                   [this](const auto& all) { return configure(all); }) {}

/// New options while the robot drives; throws std::invalid_argument and keeps the old ones.
std::vector<OptionDescription> LocalizationNode::configure(const Parameters& given) {
  const Parameters parameters = withCacheDir(given);
  const auto all = allOptions(parameters);
  is_preparation_current_ = false;
  if (localizer_) localizer_->configure(parameters);
  if (localizer_ && haveOtherPlaces(parameters, parameters_)) {
    const auto places = PlacesMaker::make(map_, parameters, !is_map_updated_);
    localizer_->setMap({map_.map, map_.field, places});
    places_.use(places);
  }
  parameters_ = parameters;
  options_ = liveOptions(parameters, options_);
  pose_keeper_.setRate(options_.save_pose_rate);
  return all;
}

/// What takes long of a new map, to be done in another thread with the options of now.
MapBuilder::Work LocalizationNode::preparation() {
  is_preparation_current_ = true;
  if (!localizer_) return nullptr;
  return [prepare = localizer_->preparer(), parameters = parameters_](BuiltMap& map) {
    map.ground.places = PlacesMaker::make(map.ground, parameters, !map.is_updated);
    map.prepared = prepare(map.ground);
  };
}

/// The grids of a map that changes all the time would push all others out of the cache.
void LocalizationNode::onMap(BuiltMap& map) {
  Ground& ground = map.ground;
  const bool is_prepared = map.prepared && is_preparation_current_;
  if (!is_prepared) ground.places = PlacesMaker::make(ground, parameters_, !map.is_updated);
  if (localizer_ && is_prepared) {
    localizer_->setMap(*map.prepared);
  } else if (localizer_) {
    localizer_->setMap(ground);
  } else {
    localizer_ = std::make_unique<Localizer>(parameters_, ground);
    if (prior_) start(*prior_);
  }
  places_.use(ground.places);
  map_ = {ground.map, ground.field};
  is_map_updated_ = map.is_updated;
}

bool LocalizationNode::onScan(const sensor_msgs::LaserScan& message, const LaserMount& mount,
                              const ros::SteadyTime& arrival) {
  if (!localizer_) return false;
  const ros::Time& stamp = message.header.stamp;
  std::string why;
  const auto T_odom_base = odometry_.at(stamp, &why);
  if (!T_odom_base) throw std::invalid_argument(why);
  const LaserScan laser_scan = believed(message);
  const double duration = durationOf(laser_scan);
  const auto velocity = duration > 0.0 ? odometry_.velocityDuring(stamp, duration) : BaseVelocity{};
  Scan scan = toScan(laser_scan, mount, localizer_->scanOptions(), velocity);
  if (scan.hits() + scan.no_return_bearing.size() > 0) {
    places_.prepare(scan);
  } else {
    scans_.complain("none of its " + std::to_string(message.ranges.size()) +
                    " ranges is valid: the laser is taken to be covered");
  }
  Observations observations;
  observations.scan = std::move(scan);
  addReflectors(laser_scan, mount, localizer_->scanOptions(), velocity, observations);
  last_scan_ = stamp;
  localize(*T_odom_base, std::move(observations), stamp, arrival);
  return true;
}

/// A sweep that cannot have taken so long is not undone.
LaserScan LocalizationNode::believed(const sensor_msgs::LaserScan& message) {
  LaserScan scan = toLaserScan(message);
  if (sweeps_.isPossible(withoutLeadingSlash(message.header.frame_id), scan)) return scan;
  std::ostringstream text;
  text.precision(3);
  text << "its time_increment, " << scan.time_increment << " s, makes a sweep of "
       << durationOf(scan) << " s, longer than the time between scans: it is taken for 0";
  scans_.complain(text.str());
  scan.time_increment = 0.0;
  return scan;
}

/// Without a laser, or while it is silent, landmarks and sonars are what the robot is localized by;
/// else they come with the next scan.
void LocalizationNode::onOtherSense(const ros::Time& stamp, const Pose2& T_odom_base) {
  constexpr double kSilence = 1.0;  // s, of a laser, from the first reading of another sense on
  if (last_scan_.isZero()) last_scan_ = stamp;
  const bool is_silent = std::abs((stamp - last_scan_).toSec()) > kSilence;
  if (localizer_ && (!scans_.hasTopics() || is_silent)) localize(T_odom_base, {}, stamp, {});
}

/// By a scan, if there is one, and what other senses have to add.
void LocalizationNode::localize(const Pose2& T_odom_base, Observations observations,
                                const ros::Time& stamp,
                                const std::optional<ros::SteadyTime>& scan_arrival) {
  const auto restart = tf_input_.restartBelow(options_.odom_frame_id);
  if (restart && restart->contains(stamp)) {
    throw std::invalid_argument("odometry was silent, and then started anew");
  }
  if (!odometry_watch_.goesOn(stamp, T_odom_base, restart) && answer_) {
    ROS_WARN("Odometry jumped: starting anew around the last pose");
    startAround(*answer_);
  }
  observations.stamp = stamp.toSec();
  headings_.observe(T_odom_base, observations);
  landmarks_.observe(T_odom_base, observations);
  sonars_.observe(T_odom_base, observations);
  const auto begin = std::chrono::steady_clock::now();
  const Localization answer = localizer_->update(T_odom_base, observations);
  const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - begin;
  if (answer.updated) ms_per_update_ = spent.count();

  answer_ = answer;
  requestFollowUps();
  if (answer.status != Status::kUninitialised) {
    publisher_.publish(answer, localizer_->hypotheses(), stamp, scan_arrival);
    if (answer.updated) publisher_.publishLeaders(localizer_->leaders(), stamp);
    pose_keeper_.keep({answer.T_map_base, answer.covariance}, stamp);
  }
  publisher_.publishStatus(answer, figures(stamp));
  const Match* match = scans_.hasTopics() ? localizer_->match() : nullptr;
  display_.show(answer, observations.scan, match, localizer_->places(), stamp);
  if (observations.landmarks) {
    display_.showLandmarks(landmarks_.known(), answer.T_map_base, *observations.landmarks, stamp);
  }
  localizer_->searchOn();
}

}  // namespace adaptive_localization
