// SPDX-License-Identifier: BSD-3-Clause
// ekf_icp with ekf_landmarks: lines on simulated drives of a robot with sonars: the walls that they
// hear on the way keep it where the robot is, without a laser and beside one.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "adaptive_localization/filters/builtins.hpp"
#include "map/floor_plan.hpp"
#include "sim/rasterize.hpp"
#include "sim/simulation.hpp"
#include "support/pose_matchers.hpp"

namespace adaptive_localization {
namespace {

const char* const kMaze = SOURCE_DIR "/maps/maze/world.yaml";

std::unique_ptr<Filter> makeByLines() {
  static const auto map =
      std::make_shared<const OccupancyGrid>(rasterize(loadFloorPlan(kMaze), 0.05));
  FilterContext context{builtins(), map};
  context.parameters.set("ekf_landmarks", OptionValue(std::string("lines")));
  context.parameters.set("line_map", OptionValue(std::string(kMaze)));
  return builtins().filters.make("ekf_icp", context);
}

/// A drive in the maze, updated each 0.1 s by the sonars' readings, and by scans if asked to.
class SonarDriver {
 public:
  explicit SonarDriver(int seed) : simulation_(Simulation::load(optionsOf(seed))) {
    const Eigen::Vector3d deviation(0.05, 0.05, 0.02);
    filter_->reset(Gaussian2{simulation_.truth(), deviation.cwiseAbs2().asDiagonal()});
  }

  /// By how much the answers are off, m, rms; with sonars or without, and with a laser or without.
  double errorAfter(double seconds, bool has_sonars, bool has_laser) {
    double sum = 0.0;
    int updates = 0;
    while (simulation_.time() < seconds) {
      const Sensed sensed = simulation_.step();
      for (const Ping& ping : sensed.pings) hear(ping);
      if (!sensed.scan) continue;
      Observations seen;
      seen.stamp = simulation_.time();
      if (has_sonars) seen.sonar = heard();
      if (has_laser) {
        const auto mount = LaserMount::level(simulation_.laserMounts().front());
        seen.scan = toScan(*sensed.scan, mount, ScanOptions{});
      }
      const Pose2 T_odom_base = simulation_.odometry().T_odom_base;
      const Estimate estimate =
          filter_->update(between(std::exchange(T_odom_last_, T_odom_base), T_odom_base), seen);
      const double error = distance(estimate.T_map_base, simulation_.truth());
      sum += error * error;
      ++updates;
      readings_.clear();
    }
    return std::sqrt(sum / updates);
  }

  double deviation() const {
    return std::sqrt(filter_->estimate().covariance.topLeftCorner<2, 2>().trace());
  }

 private:
  static SimulationOptions optionsOf(int seed) {
    SimulationOptions options = SimulationOptions::from({});
    options.world = kMaze;
    options.drive = true;
    options.sonars.sonars = true;
    options.seed = seed;
    return options;
  }

  void hear(const Ping& ping) {
    readings_.emplace_back(simulation_.odometry().T_odom_base, simulation_.reading(ping));
  }

  /// From where base is now.
  std::vector<SonarReading> heard() const {
    std::vector<SonarReading> all;
    for (const auto& [T_odom_then, reading] : readings_) {
      all.push_back(reading);
      all.back().T_base_sonar =
          between(simulation_.odometry().T_odom_base, T_odom_then) * reading.T_base_sonar;
    }
    return all;
  }

  Simulation simulation_;
  std::unique_ptr<Filter> filter_ = makeByLines();
  std::vector<std::pair<Pose2, SonarReading>> readings_;  // T_odom_base then
  Pose2 T_odom_last_ = simulation_.odometry().T_odom_base;
};

TEST(SonarLinesOfEkfIcp, KeepItWhereTheRobotIs) {
  double worst = 0.0;
  for (int seed = 1; seed <= 5; ++seed) {
    SonarDriver driver(seed);
    worst = std::max(worst, driver.errorAfter(60.0, true, false));
    EXPECT_LT(driver.deviation(), 0.2);
  }
  RecordProperty("worst error", std::to_string(worst));
  EXPECT_LT(worst, 0.03);
}

TEST(SonarLinesOfEkfIcp, TellWhatOdometryDoesNot) {
  SonarDriver driver(1);
  driver.errorAfter(60.0, false, false);
  EXPECT_GT(driver.deviation(), 0.5);
}

TEST(SonarLinesOfEkfIcp, DoNoHarmBesideALaser) {
  const double by_laser = SonarDriver(2).errorAfter(60.0, false, true);
  EXPECT_LT(SonarDriver(2).errorAfter(60.0, true, true), by_laser + 0.005);
}

TEST(SonarLinesOfEkfIcp, AreSaneWhateverSonarsHear) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  const auto filter = makeByLines();
  Pose2 truth{0.8, 0.8, 1.57};
  filter->reset(Gaussian2{truth, Eigen::Vector3d(0.01, 0.01, 0.005).asDiagonal()});
  for (const double odd : {nan, inf, -inf, 0.0, -1.0, 1e-300, 1e12, 1e300}) {
    for (const auto member :
         {&SonarReading::range, &SonarReading::max_range, &SonarReading::view}) {
      Observations heard;
      for (int i = 0; i < 8; ++i) {
        heard.sonar.push_back({i, {0.0, 0.0, i * kPi / 4}, 0.7, 5.0, 0.52});
        if (i % 2 == 0) heard.sonar.back().*member = odd;
      }
      heard.sonar[3].T_base_sonar.x = odd;
      heard.sonar[5].T_base_sonar.theta = odd;
      ASSERT_THAT(filter->update({0.05, 0.0, 0.0}, heard), IsSaneEstimate()) << odd;
      ASSERT_THAT(filter->update({0.05, odd, odd}, heard), IsSaneEstimate()) << odd;
    }
  }
}

}  // namespace
}  // namespace adaptive_localization
