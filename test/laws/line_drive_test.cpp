// SPDX-License-Identifier: BSD-3-Clause
// A Kalman filter that knows nothing but odometry and the walls that it recognises, on simulated
// drives: it stays where the robot is, and is as sure as it should be. The odometry has noise but
// no bias, as that is no noise; nor has the laser.
#include <gmock/gmock.h>

#include <Eigen/LU>
#include <cmath>

#include "../../src/match/pose_kalman.hpp"
#include "match/line_matcher.hpp"
#include "motion/differential_drive.hpp"
#include "sim/simulation.hpp"

namespace adaptive_localization {
namespace {

std::string worldFile(const std::string& name) {
  return SOURCE_DIR "/maps/" + name + "/world.yaml";
}

SimulationOptions driveThrough(const std::string& world, int people) {
  Parameters parameters;
  parameters.set("profile", std::string("ideal"));
  SimulationOptions options = SimulationOptions::from(parameters);
  options.world = worldFile(world);
  options.drive = true;
  options.people = people;
  options.seed = 4;
  options.laser.laser_bias = 0.0;
  options.laser.laser_noise = 0.03;
  return options;
}

/// For a map and a laser whose errors are noise alone.
LineOptions exactly() {
  LineOptions options;
  options.line_map_std = options.line_map_turn_std = 0.0;
  return options;
}

/// What a drive comes to.
struct Outcome {
  int scans{0}, matched{0};
  double mean_error{0.0}, largest_error{0.0};  // m
  double consistency{0.0};                     // mean of e^T P^-1 e, of 3 degrees of freedom
};

class LineDriver {
 public:
  /// Of the beams, a share is replaced by whatever.
  LineDriver(const SimulationOptions& options, double outliers)
      : outliers_(outliers),
        simulation_(Simulation::load(options)),
        matcher_(exactly(), surfacesOf(loadFloorPlan(options.world))),
        motion_(std::make_unique<DifferentialDrive>(MotionOptions{})) {
    const Eigen::Vector3d deviation(0.05, 0.05, 0.02);
    kalman_.reset({simulation_.truth(), deviation.cwiseAbs2().asDiagonal()});
    T_odom_base_ = simulation_.odometry().T_odom_base;
  }

  Outcome drive(double seconds) {
    Outcome outcome;
    while (simulation_.time() < seconds) {
      Sensed sensed = simulation_.step();
      if (!sensed.scan) continue;
      for (float& range : sensed.scan->ranges) {
        if (rng_.uniform() < outliers_) range = static_cast<float>(rng_.uniform(0.1, 8.0));
      }
      ++outcome.scans;
      if (update(*sensed.scan)) ++outcome.matched;
      const Pose2 off = between(simulation_.truth(), kalman_.mean());
      const Eigen::Vector3d error(kalman_.mean().x - simulation_.truth().x,
                                  kalman_.mean().y - simulation_.truth().y, off.theta);
      outcome.mean_error += error.head<2>().norm();
      outcome.largest_error = std::max(outcome.largest_error, error.head<2>().norm());
      outcome.consistency += error.dot(kalman_.covariance().inverse() * error);
    }
    outcome.mean_error /= outcome.scans;
    outcome.consistency /= outcome.scans;
    return outcome;
  }

 private:
  bool update(const LaserScan& message) {
    const OdometryReading odometry = simulation_.odometry();
    const Pose2 motion = between(T_odom_base_, odometry.T_odom_base);
    T_odom_base_ = odometry.T_odom_base;
    kalman_.predict(motion, motion_->covariance(motion));
    const BaseVelocity velocity{odometry.velocity.forward, 0.0, odometry.velocity.turn};
    const Scan scan = toScan(message, LaserMount::level(simulation_.laserMounts().front()),
                             ScanOptions{}, velocity);
    const Match match = matcher_.match(kalman_.mean(), scan, kalman_.covariance().inverse());
    if (!match.isGood()) return false;
    const PoseObservation seen = observationOf(kalman_.mean(), match);
    return kalman_.distanceOf(seen) < 16.27 && kalman_.correct(seen);
  }

  double outliers_;
  Rng rng_{3};
  Simulation simulation_;
  LineMatcher matcher_;
  std::unique_ptr<MotionModel> motion_;
  PoseKalman kalman_;
  Pose2 T_odom_base_;
};

struct Drive {
  const char* world;
  int people;
  double outliers;  // share of the beams
};
void PrintTo(const Drive& drive, std::ostream* out) {
  *out << drive.world << " with " << drive.people << " people, " << 100.0 * drive.outliers
       << " % of the beams wrong";
}

class LinesAlone : public testing::TestWithParam<Drive> {};

TEST_P(LinesAlone, KeepAKalmanFilterWhereTheRobotIs) {
  const Drive& drive = GetParam();
  const Outcome outcome =
      LineDriver(driveThrough(drive.world, drive.people), drive.outliers).drive(120.0);
  RecordProperty("mean error", std::to_string(outcome.mean_error));
  RecordProperty("largest error", std::to_string(outcome.largest_error));
  RecordProperty("consistency", std::to_string(outcome.consistency));
  EXPECT_GT(outcome.scans, 1000);
  EXPECT_GT(outcome.matched, outcome.scans * 7 / 10);
  EXPECT_LT(outcome.mean_error, 0.015);
  EXPECT_LT(outcome.largest_error, 0.1);
  EXPECT_GT(outcome.consistency, 2.0);  // 3 on average
  EXPECT_LT(outcome.consistency, 4.5);
}

INSTANTIATE_TEST_SUITE_P(Worlds, LinesAlone,
                         testing::Values(Drive{"maze", 0, 0.0}, Drive{"maze", 3, 0.0},
                                         Drive{"maze", 3, 0.2}, Drive{"maze", 0, 0.4},
                                         Drive{"corridor", 0, 0.0}, Drive{"corridor", 0, 0.4},
                                         Drive{"expansion", 2, 0.2}));

}  // namespace
}  // namespace adaptive_localization
