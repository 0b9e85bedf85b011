// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/picture.hpp"
#include "sim/camera.hpp"
#include "sim/imu.hpp"
#include "sim/laser.hpp"
#include "sim/people.hpp"
#include "sim/route_follower.hpp"
#include "sim/sonars.hpp"
#include "sim/wheel_odometry.hpp"

namespace adaptive_localization {

/// All options of a simulated Pioneer 3-DX; the parts' options are read from the same flat keys.
struct SimulationOptions {
  std::string world;
  std::string start;
  std::string profile{"nominal"};
  int seed{1};
  bool drive{false};
  std::string drive_by{"truth"};
  bool furniture{false};
  int people{0};
  double scan_rate{10.0};
  double odom_rate{10.0};
  DriveBaseOptions base;
  OdometryOptions odometry;
  LaserOptions laser;
  ImuOptions imu;
  CameraOptions camera;
  SonarsOptions sonars;
  RouteOptions route;

  template <class Visitor>
  void visit(Visitor&& option) {
    option("world", world, Choices{}, "A world.yaml (a floor plan) or a map's YAML file.");
    option("start", start, Choices{},
           "x,y,yaw, or random; empty: the floor plan's start, random where it has none.");
    option("profile", profile, Choices{"ideal", "nominal", "bad"},
           "How good the wheel odometry is: the defaults of the odom_ options.");
    option("seed", seed, Range{0, 2147483647}, "", "Same seed and same commands, same readings.");
    option("drive", drive, "Drive the route; a command takes over for cmd_vel_timeout.");
    option("drive_by", drive_by, Choices{"truth", "estimate"},
           "What the driver steers by: where the robot is, or where it is localized; while nothing "
           "localizes it, it stands.");
    option("furniture", furniture, "Put up the floor plan's furniture, which no map shows.");
    option("people", people, Range{0, 1000}, "", "People walking about, whom no map shows.");
    option("scan_rate", scan_rate, Range{0.1, 100}, "Hz", "Laser scans per second.");
    option("odom_rate", odom_rate, Range{0.1, 100}, "Hz", "Odometry readings per second.");
    base.visit(option);
    odometry.visit(option);
    laser.visit(option);
    imu.visit(option);
    camera.visit(option);
    sonars.visit(option);
    route.visit(option);
  }

  /// Reads the options, the profile's first. Throws std::invalid_argument naming key and value.
  static SimulationOptions from(const Parameters& parameters);
};

struct OdometryReading {
  double stamp{0.0};  // s
  Pose2 T_odom_base;
  Velocity velocity;
};

/// What came from the sensors in one step.
struct Sensed {
  std::optional<LaserScan> scan;         // of the first laser; of none, without a laser: no ranges
  std::optional<LaserScan> second_scan;  // of the second one, with the same stamp
  std::optional<OdometryReading> odometry;
  std::optional<ImuReading> imu;
  std::optional<Picture> picture;
  std::vector<Ping> pings;
};

/// When something that comes at a rate is due: k / rate, k = 1, 2 and so on, s.
class Metronome {
 public:
  explicit Metronome(double rate) : rate_(rate) {}

  double next() const { return static_cast<double>(beats_ + 1) / rate_; }

  /// The instant that is due at a time, once.
  std::optional<double> beat(double time);

 private:
  double rate_;  // Hz
  std::int64_t beats_{0};
};

/// A world with a robot in it, in steps of 10 ms of simulated time, which starts at 0. What comes
/// between two steps is read off the arc that the robot drives. Everything random comes from the
/// seed: same options and same commands, same bits.
class Simulation {
 public:
  static constexpr double kStep = 0.01;  // s

  /// Throws std::invalid_argument naming the option when robot or start do not fit the world.
  Simulation(const Site& site, const SimulationOptions& options);

  /// A simulation of the world that the options name.
  static Simulation load(const SimulationOptions& options);

  void command(const Velocity& velocity);

  /// Where the robot is localized: what the driver steers by from now on if drive_by says so.
  void localize(const Pose2& T_map_odom) { T_map_odom_ = T_map_odom; }

  Sensed step();

  double time() const { return static_cast<double>(ticks_) * kStep; }
  const Pose2& truth() const { return T_map_base_; }  // T_map_base
  const Velocity& velocity() const { return base_.velocity(); }
  OdometryReading odometry() const { return {time(), odometry_.pose(), odometry_.velocity()}; }
  const std::vector<Eigen::Vector2d>& people() const { return people_.places(); }
  const std::vector<Pose2>& laserMounts() const { return laser_mounts_; }  // T_base_laser of each
  const Paint& paint() const { return paint_; }
  const RouteFollower& driver() const { return driver_; }

  bool hasImu() const { return options_.imu.imu; }
  bool hasCamera() const { return options_.camera.camera; }
  bool hasSonars() const { return options_.sonars.sonars; }

  /// What a ping tells, from where its sonar is on the robot.
  SonarReading reading(const Ping& ping) const { return sonars_.reading(ping); }

  /// Turns what the compass tells by an angle in rad, from now on.
  void disturbCompass(double angle) { imu_.disturb(angle); }

  /// The robot is lifted and put down: its wheels do not turn. Where it cannot stand, it is put
  /// at the nearest place where it can and that it can leave.
  void kidnap(const Pose2& T_map_base);
  void kidnapRandom();

  /// Carries the robot back to its start; odometry goes on.
  void reset() { kidnap(start_); }

 private:
  Pose2 chooseStart(const Site& site, const std::string& text);
  Pose2 randomPose();
  void drive();
  std::optional<Pose2> believedPose() const;
  void move();
  bool blocks(const Pose2& T_map_next) const;
  void scan(double time);
  Picture takePicture(double time);
  std::vector<Ping> ping(double time);
  Pose2 poseAt(double time) const;
  double rangeTo(const Pose2& T_map_ray, double max_range) const;

  SimulationOptions options_;
  std::shared_ptr<const World> world_;
  Paint paint_;
  std::shared_ptr<const FreeSpace> free_space_;
  Rng rng_;
  DriveBase base_;
  WheelOdometry odometry_;
  std::vector<Pose2> laser_mounts_;
  std::vector<Laser> lasers_;
  Imu imu_;
  Camera camera_;
  Sonars sonars_;
  People people_;
  RouteFollower driver_;
  Pose2 start_;
  Pose2 T_map_base_;
  std::optional<Pose2> T_map_odom_;  // as it is localized
  std::int64_t ticks_{0};
  double commanded_at_{-1e9};
  Metronome scans_, readings_, pictures_, pings_;
  std::deque<Sensed> on_the_wire_;  // scans taken but not yet delivered
};

}  // namespace adaptive_localization
