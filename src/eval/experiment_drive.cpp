// SPDX-License-Identifier: BSD-3-Clause
#include "experiment_drive.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace adaptive_localization {
namespace {

constexpr std::uint64_t kEvents = 100;  // stream of randomness, none of the simulation's
constexpr double kSoon = Simulation::kStep / 2.0;

SimulationOptions optionsOf(const ExperimentCase& of_case, int seed) {
  SimulationOptions options = SimulationOptions::from(of_case.simulation);
  options.seed = seed;
  options.start = "random";
  return options;
}

Site siteOf(const ExperimentSite& site, const ExperimentCase& of_case) {
  Site result = site.site;
  if (of_case.route) result.route = *of_case.route;
  return result;
}

bool isIn(const std::vector<Bounds>& regions, const Eigen::Vector2d& point) {
  return regions.empty() || std::any_of(regions.begin(), regions.end(), [&](const Bounds& region) {
           return region.contains(point);
         });
}

}  // namespace

ExperimentDrive::ExperimentDrive(const ExperimentSite& site, const ExperimentCase& of_case,
                                 int seed)
    : free_space_(site.free_space),
      simulation_(siteOf(site, of_case), optionsOf(of_case, seed)),
      rng_(Rng(static_cast<std::uint64_t>(seed)).split(kEvents)),
      duration_(of_case.duration),
      scan_period_(1.0 / SimulationOptions::from(of_case.simulation).scan_rate),
      has_mission_(SimulationOptions::from(of_case.simulation).drive_by == "estimate") {
  for (const auto& event : of_case.events) {
    const double step = event.every > 0.0 ? event.every : std::numeric_limits<double>::infinity();
    for (double at = event.at; at < duration_; at += step) {
      due_.push_back({event, at, rng_.uniform()});
    }
  }
  std::stable_sort(due_.begin(), due_.end(),
                   [](const Due& a, const Due& b) { return a.at < b.at; });
  putAtStart(of_case);
}

/// At one for which there is what shall be told of it.
void ExperimentDrive::putAtStart(const ExperimentCase& of_case) {
  constexpr int kTries = 100;
  for (int i = 0; i < kTries; ++i) {
    simulation_.kidnap(draw(of_case.start));
    const std::optional<Pose2> told = of_case.told ? draw(*of_case.told) : truth();
    if (!told) continue;
    told_ = *told;
    return;
  }
  const WrongStart& told = *of_case.told;
  const double off_by = told.shift ? told.shift->norm() : told.off_by;
  throw std::invalid_argument("no place where the robot could stand " + std::to_string(off_by) +
                              " m from where it stands");
}

Pose2 ExperimentDrive::draw(const Spot& place) {
  if (place.pose) return checked(*place.pose);
  constexpr int kTries = 10000;
  const Eigen::Vector2d here(truth().x, truth().y);
  for (int i = 0; i < kTries; ++i) {
    const Eigen::Vector2d spot = free_space_->sample(rng_);
    if (!isIn(place.regions, spot) || (spot - here).norm() < place.farther_than) continue;
    return {spot.x(), spot.y(), wrapAngle(rng_.uniform(place.yaw_low, place.yaw_high))};
  }
  throw std::invalid_argument("no place where the robot can stand in the regions given for it, " +
                              std::to_string(place.farther_than) + " m or more from where it was");
}

/// A place where the robot cannot stand, nor within a step, is a mistake.
const Pose2& ExperimentDrive::checked(const Pose2& pose) const {
  constexpr double kNear = 0.5;  // m
  const Eigen::Vector2d spot(pose.x, pose.y);
  if ((free_space_->nearest(spot) - spot).norm() <= kNear) return pose;
  std::ostringstream text;
  text << "place of the robot: got " << pose.x << ", " << pose.y
       << ", expected one where it can stand";
  throw std::invalid_argument(text.str());
}

std::optional<Pose2> ExperimentDrive::draw(const WrongStart& told) {
  if (told.pose) return told.pose;
  constexpr int kTries = 1000;
  for (int i = 0; i < kTries; ++i) {
    const double direction = rng_.uniform(-kPi, kPi);
    const Eigen::Vector2d along(std::cos(direction), std::sin(direction));
    const Eigen::Vector2d shift = told.shift ? std::copysign(1.0, direction) * *told.shift
                                             : Eigen::Vector2d(told.off_by * along);
    const Eigen::Vector2d spot = Eigen::Vector2d(truth().x, truth().y) + shift;
    if (!shift.isZero() && !free_space_->contains(spot)) continue;
    return Pose2{spot.x(), spot.y(), wrapAngle(truth().theta + told.turned_by)};
  }
  return std::nullopt;
}

/// The mean since the scan before.
BaseVelocity ExperimentDrive::velocityUntil(const Pose2& T_odom_base) const {
  const Pose2 motion = between(T_odom_last_scan_, T_odom_base);
  return {motion.x / scan_period_, motion.y / scan_period_, motion.theta / scan_period_};
}

/// What is true of a scan that was taken now.
DriveScan ExperimentDrive::sight(LaserScan scan) const {
  DriveScan sight;
  sight.scan = std::move(scan);
  sight.scan.stamp = time();
  sight.T_odom_base = T_odom_wheels_ * simulation_.odometry().T_odom_base;
  sight.velocity = velocityUntil(sight.T_odom_base);
  sight.T_map_base = truth();
  if (const auto reading = headings_.headingAt(time())) sight.heading = reading->heading;
  sight.gyro = headings_.turnAt(time());
  return sight;
}

std::optional<DriveScan> ExperimentDrive::next() {
  if (second_) return std::exchange(second_, std::nullopt);
  while (time() < duration_ - kSoon) {
    const bool was_carried = carry_.has_value();
    if (!was_carried) startDueEvents();
    if (carry_) {
      DriveScan scan = carriedScan();
      scan.is_lifted = !was_carried;
      return scan;
    }
    simulation_.disturbCompass(compassError());
    Sensed sensed = simulation_.step();
    if (sensed.imu) hear(*sensed.imu);
    if (sensed.picture) picture_ = std::move(sensed.picture->sightings);
    for (const Ping& ping : sensed.pings) hear(ping);
    if (has_mission_) mission_.observe(simulation_, sensed.scan.has_value());
    if (!sensed.scan) continue;
    last_scan_ = *sensed.scan;
    DriveScan scan = sight(blocked(std::move(*sensed.scan)));
    if (sensed.second_scan) {
      second_ = sight(blocked(std::move(*sensed.second_scan)));
      second_->laser = 1;
    }
    T_odom_last_scan_ = scan.T_odom_base;
    scan.landmarks = std::exchange(picture_, std::nullopt);
    scan.sonar = heardBefore(scan.T_odom_base);
    scan.put_down = put_down_;
    put_down_.reset();
    return scan;
  }
  return std::nullopt;
}

/// Kidnaps and carries; what blocks beams or disturbs a compass is looked up scan by scan.
void ExperimentDrive::startDueEvents() {
  if (last_scan_.stamp == 0.0) return;  // nothing has begun
  const auto is_due = [&](const Due& due) {
    const bool is_move = due.event.what == ExperimentEvent::What::kKidnap ||
                         due.event.what == ExperimentEvent::What::kCarry;
    return is_move && due.at <= time() + kSoon;
  };
  for (auto due = due_.begin(); due != due_.end() && !carry_;) {
    if (!is_due(*due)) {
      ++due;
      continue;
    }
    const ExperimentEvent event = due->event;
    due = due_.erase(due);
    start(event);
  }
}

void ExperimentDrive::start(const ExperimentEvent& event) {
  const Pose2 T_map_before = truth();
  const Pose2 T_odom_base = T_odom_wheels_ * simulation_.odometry().T_odom_base;
  simulation_.kidnap(draw(event.to));
  if (event.what == ExperimentEvent::What::kKidnap) {
    put_down_ = time();
  } else {
    carry_ = Carry{T_odom_base, wrapAngle(truth().theta - T_map_before.theta), time(),
                   time() + event.duration, event.is_garbage};
  }
}

DriveScan ExperimentDrive::carriedScan() {
  carryGyroscope();
  carried_ += scan_period_;
  const double share = std::min(1.0, (time() - carry_->from) / (carry_->until - carry_->from));
  DriveScan scan;
  scan.scan = carriedReadings();
  scan.T_odom_base = carry_->T_odom_base * Pose2{0.0, 0.0, carry_->turn * share};
  T_odom_last_scan_ = scan.T_odom_base;
  scan.gyro = headings_.turnAt(time());
  if (time() >= carry_->until - kSoon) putDown();
  return scan;
}

void ExperimentDrive::putDown() {
  const Pose2 T_odom_base = carry_->T_odom_base * Pose2{0.0, 0.0, carry_->turn};
  T_odom_wheels_ = T_odom_base * inverse(simulation_.odometry().T_odom_base);
  put_down_ = time();
  carry_.reset();
  pings_.clear();
}

}  // namespace adaptive_localization
