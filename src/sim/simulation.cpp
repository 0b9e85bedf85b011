// SPDX-License-Identifier: BSD-3-Clause
#include "sim/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace adaptive_localization {
namespace {

/// Streams of randomness, one per part, so that more people do not change the laser's noise.
enum Stream : std::uint64_t {
  kPlaces,
  kWheels,
  kBeams,
  kWalks,
  kRoute,
  kMoreBeams,
  kImu,
  kCamera,
  kSonars
};

Pose2 parsePose(const std::string& text) {
  std::istringstream in(text);
  Pose2 pose;
  char comma_1{}, comma_2{}, more{};
  const bool read = static_cast<bool>(in >> pose.x >> comma_1 >> pose.y >> comma_2 >> pose.theta);
  if (!read || comma_1 != ',' || comma_2 != ',' || in >> more || !isFinite(pose)) {
    throw std::invalid_argument("option 'start': got '" + text +
                                "', expected x,y,yaw in metres and radians, or random");
  }
  return pose;
}

std::shared_ptr<const FreeSpace> freeSpace(const Site& site, const SimulationOptions& options) {
  constexpr double kMargin = 0.01;  // m, for steering
  return std::make_shared<const FreeSpace>(site.world, options.base.robot_radius + kMargin);
}

Eigen::Vector2d place(const Pose2& pose) {
  return {pose.x, pose.y};
}

}  // namespace

std::optional<double> Metronome::beat(double time) {
  constexpr double kSlack = 1e-9;  // s, of sums of steps
  if (next() > time + kSlack) return std::nullopt;
  const double due = next() > time - kSlack ? time : next();
  ++beats_;
  return due;
}

SimulationOptions SimulationOptions::from(const Parameters& parameters) {
  SimulationOptions options;
  options.odometry = OdometryOptions::profile(parameters.read<SimulationOptions>().profile);
  return parameters.read(options);
}

Simulation Simulation::load(const SimulationOptions& options) {
  if (options.world.empty()) {
    throw std::invalid_argument(
        "option 'world': got '', expected a world.yaml (a floor plan) or a map's YAML file");
  }
  return {loadSite(options.world, options.furniture), options};
}

Simulation::Simulation(const Site& site, const SimulationOptions& options)
    : options_(options),
      world_(site.world),
      paint_(site.paint),
      free_space_(freeSpace(site, options)),
      rng_(static_cast<std::uint64_t>(options.seed)),
      base_(options.base),
      odometry_(options.odometry, options.base.base == "omni", rng_.split(kWheels)),
      laser_mounts_(adaptive_localization::laserMounts(options.laser)),
      imu_(options.imu, rng_.split(kImu)),
      camera_(options.camera, site.landmarks, rng_.split(kCamera)),
      sonars_(options.sonars, rng_.split(kSonars)),
      people_(free_space_, options.people, rng_.split(kWalks)),
      driver_(free_space_, site.route, options.route, options.base.base == "omni",
              rng_.split(kRoute)),
      start_(chooseStart(site, options.start)),
      T_map_base_(start_),
      scans_(options.scan_rate),
      readings_(options.odom_rate),
      pictures_(options.camera.camera_rate),
      pings_(1.0 / options.sonars.sonar_period) {
  if (options.camera.camera && site.landmarks.empty()) {
    throw std::invalid_argument(
        "option 'camera': got true, expected false in a world without landmarks");
  }
  for (const Pose2& mount : laser_mounts_) {
    lasers_.emplace_back(options.laser, mount, rng_.split(lasers_.empty() ? kBeams : kMoreBeams),
                         site.landmarks);
  }
}

Pose2 Simulation::chooseStart(const Site& site, const std::string& text) {
  if (text == "random" || (text.empty() && !site.start)) return randomPose();
  const Pose2 start = text.empty() ? *site.start : parsePose(text);
  if (!free_space_->contains(place(start))) {
    throw std::invalid_argument("option 'start': got " + std::to_string(start.x) + "," +
                                std::to_string(start.y) +
                                ", expected a place where the robot can stand and drive away");
  }
  return start;
}

Pose2 Simulation::randomPose() {
  const Eigen::Vector2d spot = free_space_->sample(rng_);
  return {spot.x(), spot.y(), rng_.uniform(-kPi, kPi)};
}

void Simulation::command(const Velocity& velocity) {
  commanded_at_ = time();
  base_.command(velocity, time());
}

Sensed Simulation::step() {
  if (options_.drive) drive();
  people_.step(kStep, place(T_map_base_));
  move();
  ++ticks_;

  Sensed sensed;
  if (const auto due = readings_.beat(time())) {
    odometry_.report(*due - time());
    sensed.odometry = {*due, odometry_.pose(*due - time()), odometry_.velocity()};
  }
  if (options_.imu.imu) sensed.imu = imu_.read(time(), T_map_base_.theta, base_.velocity().turn);
  if (const auto due = pictures_.beat(time()); due && hasCamera())
    sensed.picture = takePicture(*due);
  if (const auto due = pings_.beat(time()); due && hasSonars()) sensed.pings = ping(*due);
  if (const auto due = scans_.beat(time())) scan(*due);
  if (!on_the_wire_.empty() && on_the_wire_.front().scan->stamp <= time() + kStep / 2.0) {
    sensed.scan = std::move(on_the_wire_.front().scan);
    sensed.second_scan = std::move(on_the_wire_.front().second_scan);
    on_the_wire_.pop_front();
  }
  return sensed;
}

void Simulation::drive() {
  constexpr int kTicks = 5;
  if (ticks_ % kTicks != 0 || time() - commanded_at_ <= options_.base.cmd_vel_timeout) return;
  const std::optional<Pose2> T_map_believed = believedPose();
  if (!T_map_believed) return;
  const Pose2 T_believed_map = *T_map_believed * inverse(T_map_base_);
  std::vector<Eigen::Vector2d> people = people_.places();  // as they are seen from the robot
  for (Eigen::Vector2d& person : people) person = T_believed_map * person;
  base_.command(driver_.steer(*T_map_believed, people, kTicks * kStep), time());
}

std::optional<Pose2> Simulation::believedPose() const {
  if (options_.drive_by == "truth") return T_map_base_;
  if (!T_map_odom_) return std::nullopt;
  return *T_map_odom_ * odometry_.pose();
}

/// Whether the robot would touch something there and come nearer to it.
bool Simulation::blocks(const Pose2& T_map_next) const {
  const double radius = options_.base.robot_radius;
  const double room = world_->clearance(place(T_map_next), radius);
  if (room < radius && room < world_->clearance(place(T_map_base_), radius)) return true;
  return std::any_of(people_.places().begin(), people_.places().end(), [&](const auto& person) {
    const double gap = (person - place(T_map_next)).norm();
    return gap < radius + People::kRadius && gap < (person - place(T_map_base_)).norm();
  });
}

void Simulation::move() {
  Velocity velocity = base_.step(time(), kStep);
  if (blocks(T_map_base_ * arc(velocity, kStep))) {
    base_.stop();
    velocity = base_.velocity();
  }
  T_map_base_ = T_map_base_ * arc(velocity, kStep);
  odometry_.step(velocity, kStep);
}

double Simulation::rangeTo(const Pose2& T_map_ray, double max_range) const {
  return people_.range(T_map_ray, world_->range(T_map_ray, max_range));
}

/// On the arc that is driven now.
Pose2 Simulation::poseAt(double time) const {
  return T_map_base_ * arc(base_.velocity(), time - this->time());
}

Picture Simulation::takePicture(double time) {
  return {time, camera_.sight(poseAt(time), [this](const Pose2& T_map_ray, double max_range) {
            return rangeTo(T_map_ray, max_range);
          })};
}

std::vector<Ping> Simulation::ping(double time) {
  return sonars_.ping(time, poseAt(time), [this](const Pose2& T_map_ray, double max_range) {
    return rangeTo(T_map_ray, max_range);
  });
}

void Simulation::scan(double time) {
  const auto cast = [this](const Pose2& T_map_ray, double max_range) {
    return rangeTo(T_map_ray, max_range);
  };
  const Pose2 T_map_base = poseAt(time);
  std::vector<LaserScan> scans;
  for (Laser& laser : lasers_) {
    scans.push_back(laser.scan(T_map_base, cast, base_.velocity()));
    scans.back().stamp = time + options_.laser.laser_latency;
  }
  if (scans.empty()) {  // the beat goes on
    scans.emplace_back();
    scans.back().stamp = time;
  }
  Sensed taken;
  taken.scan = std::move(scans.front());
  if (scans.size() > 1) taken.second_scan = std::move(scans.back());
  on_the_wire_.push_back(std::move(taken));
}

void Simulation::kidnap(const Pose2& T_map_base) {
  const Eigen::Vector2d spot = free_space_->nearest(place(T_map_base));
  T_map_base_ = {spot.x(), spot.y(), T_map_base.theta};
  base_.halt();
  driver_.restart();
}

void Simulation::kidnapRandom() {
  kidnap(randomPose());
}

}  // namespace adaptive_localization
