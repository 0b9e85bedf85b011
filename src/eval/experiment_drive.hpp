// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/heading_history.hpp"
#include "eval/experiment_site.hpp"
#include "mission_record.hpp"

namespace adaptive_localization {

/// One scan of a drive with all that is true of it.
struct DriveScan {
  LaserScan scan;
  std::size_t laser{0};  // which one took it
  Pose2 T_odom_base;
  BaseVelocity velocity;                           // by odometry, since the scan before
  std::optional<Heading> heading;                  // of the simulated compass, if there is one
  std::optional<GyroTurn> gyro;                    // and gyroscope
  std::optional<std::vector<Sighting>> landmarks;  // of the camera, if it took a picture just now
  std::vector<SonarReading> sonar;                 // since the scan before
  std::optional<Pose2> T_map_base;                 // none while the robot is off the floor
  bool is_lifted{false};                           // it was, since the scan before
  std::optional<double> put_down;                  // s, when it was put down, since the scan before
};

/// A simulated drive to which things happen. While the robot is carried its wheels stand still,
/// odometry turns with its gyro, and the laser sees a hand before it, or anything.
class ExperimentDrive {
 public:
  ExperimentDrive(const ExperimentSite& site, const ExperimentCase& of_case, int seed);

  /// The next scan; none when the time is up.
  std::optional<DriveScan> next();

  /// Where the robot is localized: what a driver that does not know the truth steers by.
  void localize(const Pose2& T_map_odom) { simulation_.localize(T_map_odom * T_odom_wheels_); }

  /// Of a driver who steers by the estimate, else empty.
  const MissionRecord& mission() const { return mission_; }

  const Pose2& truth() const { return simulation_.truth(); }  // T_map_base
  const Pose2& told() const { return told_; }                 // of the start, for T_map_base
  const std::vector<Pose2>& laserMounts() const { return simulation_.laserMounts(); }

 private:
  struct Due {
    ExperimentEvent event;
    double at;
    double first_bearing;  // of the blocked sector, as a share of the beams
  };
  struct Carry {
    Pose2 T_odom_base;  // when it was lifted
    double turn;        // rad in all
    double from, until;
    bool is_garbage;
  };

  double time() const { return simulation_.time() + carried_; }
  void putAtStart(const ExperimentCase& of_case);
  const Pose2& checked(const Pose2& pose) const;
  Pose2 draw(const Spot& place);
  std::optional<Pose2> draw(const WrongStart& told);
  BaseVelocity velocityUntil(const Pose2& T_odom_base) const;
  void hear(const ImuReading& reading);
  void carryGyroscope();
  bool isOn(const Due& due, ExperimentEvent::What what) const;
  double compassError() const;
  void startDueEvents();
  void start(const ExperimentEvent& event);
  DriveScan carriedScan();
  void putDown();
  DriveScan sight(LaserScan scan) const;
  LaserScan blocked(LaserScan scan);
  LaserScan handBefore(LaserScan scan, bool is_garbage);
  LaserScan carriedReadings();
  void hear(const Ping& ping);
  std::vector<SonarReading> heardBefore(const Pose2& T_odom_base);

  std::shared_ptr<const FreeSpace> free_space_;
  Simulation simulation_;
  Rng rng_;
  double duration_, scan_period_;
  bool has_mission_;  // the driver steers by the estimate
  std::vector<Due> due_;
  std::optional<Carry> carry_;
  double carried_{0.0};  // s in all
  HeadingHistory headings_;
  std::optional<std::vector<Sighting>> picture_;  // since the last scan
  std::vector<std::pair<Pose2, Ping>> pings_;     // since the last scan, with T_odom_base
  Pose2 T_odom_wheels_;  // odometry as told, from the wheels' own: the gyro turned while carried
  std::optional<double> put_down_;
  LaserScan last_scan_;
  std::optional<DriveScan> second_;  // the second laser's, to be told next
  Pose2 T_odom_last_scan_;
  Pose2 told_;
  MissionRecord mission_;
};

}  // namespace adaptive_localization
