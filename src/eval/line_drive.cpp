// SPDX-License-Identifier: BSD-3-Clause
#include "eval/line_drive.hpp"

#include <Eigen/LU>
#include <cmath>
#include <cstdio>
#include <set>
#include <stdexcept>

#include "adaptive_localization/filters/builtins.hpp"
#include "core/suggestion.hpp"
#include "localizer/former_options.hpp"
#include "match/line_map.hpp"
#include "sim/rasterize.hpp"
#include "sim/simulation.hpp"

namespace adaptive_localization {
namespace {

constexpr double kStartStd = 0.05;    // m
constexpr double kStartTurn = 0.02;   // rad
constexpr double kResolution = 0.05;  // m

const double kWithin = -2.0 * std::log(0.01);  // chi-square of two degrees of freedom

[[noreturn]] void refuse(const std::string& key, const std::string& whose,
                         const std::vector<std::string>& known) {
  throw std::invalid_argument("option '" + key + "': expected one of " + whose +
                              suggestion(key, known));
}

SimulationOptions robotOf(const LineDrivePlan& plan) {
  SimulationOptions robot = SimulationOptions::from(plan.robot);
  for (const auto& key : plan.robot.unknownKeys()) {
    refuse(key, "the simulated robot", keysOf(describe(SimulationOptions{})));
  }
  if (robot.laser.lasers != 1) {
    throw std::invalid_argument("option 'lasers': got " + std::to_string(robot.laser.lasers) +
                                ", expected one, which sees the lines");
  }
  robot.world = plan.world;
  robot.drive = true;
  return robot;
}

/// Given to both filters alike.
FilterContext contextOf(const LineDrivePlan& plan, std::shared_ptr<const OccupancyGrid> map) {
  refuseFormerOptions(plan.options);
  FilterContext context{builtins(), Ground(std::move(map)), plan.options};
  context.parameters.set("ekf_landmarks", OptionValue(std::string("lines")));
  context.parameters.set("line_map", OptionValue(plan.world));
  return context;
}

class Driver {
 public:
  explicit Driver(const LineDrivePlan& plan)
      : simulation_(Simulation::load(robotOf(plan))),
        map_(std::make_shared<const OccupancyGrid>(
            rasterize(loadFloorPlan(plan.world), kResolution))),
        walls_(surfacesOf(loadFloorPlan(plan.world))),
        line_map_(walls_),
        context_(contextOf(plan, map_)),
        alone_(builtins().filters.make("ekf_icp", context_)),
        by_lines_(builtins().filters.make("ekf_icp", context_)),
        scans_(context_.parameters.read<ScanOptions>()),
        lines_(context_.parameters.read<LineOptions>()) {
    for (const auto& key : context_.parameters.unknownKeys()) {
      refuse(key, "ekf_icp", keysOf(builtins().filters.find("ekf_icp").options));
    }
    const Eigen::Vector3d deviation(kStartStd, kStartStd, kStartTurn);
    const Gaussian2 start{simulation_.truth(), deviation.cwiseAbs2().asDiagonal()};
    alone_->reset(start);
    by_lines_->reset(start);
    last_ = {simulation_.time(), 0.0, simulation_.truth(), start, start};
    T_odom_base_ = simulation_.odometry().T_odom_base;
  }

  LineDrive drive(double duration) {
    LineDrive drive{walls_, {last_}, {}, {}, {}};
    Scan scan;
    while (simulation_.time() < duration) {
      const Sensed sensed = simulation_.step();
      if (!sensed.scan) continue;
      scan = read(*sensed.scan);
      update(scan);
      drive.steps.push_back(last_);
    }
    look(scan, drive);
    return drive;
  }

 private:
  Scan read(const LaserScan& message) const {
    const Velocity velocity = simulation_.odometry().velocity;
    return toScan(message, LaserMount::level(simulation_.laserMounts().front()), scans_,
                  {velocity.forward, velocity.aside, velocity.turn});
  }

  void update(const Scan& scan) {
    const Pose2 T_odom_base = simulation_.odometry().T_odom_base;
    const Pose2 motion = between(T_odom_base_, T_odom_base);
    T_odom_base_ = T_odom_base;
    const double stamp = simulation_.time();
    Observations nothing, seen;
    nothing.stamp = seen.stamp = stamp;
    seen.scan = scan;
    const Estimate odometry = alone_->update(motion, nothing);
    const Estimate lines = by_lines_->update(motion, seen);
    last_ = {stamp, last_.driven + distance(last_.T_map_base, simulation_.truth()),
             simulation_.truth(), Gaussian2{odometry.T_map_base, odometry.covariance},
             Gaussian2{lines.T_map_base, lines.covariance}};
  }

  /// Notes which lines are in a scan that was taken where the robot is.
  void look(const Scan& scan, LineDrive& drive) const {
    const Gaussian2& belief = last_.lines;
    for (int i = 0; i < scan.hits(); ++i) {
      drive.hits.push_back(belief.mean * Eigen::Vector2d(scan.x[i], scan.y[i]));
    }
    const std::vector<ScanLine> lines = linesOf(scan, lines_);
    for (const auto& line : lines) {
      drive.seen.push_back({{belief.mean * line.a, belief.mean * line.b}});
    }
    std::set<int> matched;
    for (const auto& match : matchLines(belief.mean, belief.covariance, lines, line_map_, lines_)) {
      drive.seen[static_cast<std::size_t>(match.scan_line)].is_matched = true;
      if (matched.insert(match.map_line).second) drive.matched.push_back(match.landmark.segment);
    }
  }

  Simulation simulation_;
  std::shared_ptr<const OccupancyGrid> map_;
  std::vector<Segment> walls_;
  LineMap line_map_;
  FilterContext context_;
  std::unique_ptr<Filter> alone_, by_lines_;
  ScanOptions scans_;
  LineOptions lines_;
  LineDriveStep last_;
  Pose2 T_odom_base_;
};

nlohmann::json toJson(const Gaussian2& belief) {
  const Eigen::Matrix3d& P = belief.covariance;
  return {belief.mean.x, belief.mean.y, P(0, 0), P(0, 1), P(1, 1)};
}

nlohmann::json toJson(const Segment& segment) {
  return {segment.a.x(), segment.a.y(), segment.b.x(), segment.b.y()};
}

nlohmann::json toJson(const std::vector<Segment>& segments) {
  nlohmann::json rows = nlohmann::json::array();
  for (const Segment& segment : segments) rows.push_back(toJson(segment));
  return rows;
}

std::string rowOf(const LineDriveStep& step) {
  const double ahead = step.T_map_base.theta;
  const double aside = ahead + 0.5 * kPi;
  char text[160];
  std::snprintf(text, sizeof text, "%6.1f %6.2f %8.3f %8.3f %8.3f %8.3f %8.3f %8.3f %9.4f %9.4f\n",
                step.stamp, step.driven, distance(step.T_map_base, step.odometry.mean),
                distance(step.T_map_base, step.lines.mean), deviationAlong(step.odometry, aside),
                deviationAlong(step.lines, aside), deviationAlong(step.odometry, ahead),
                deviationAlong(step.lines, ahead), ellipseArea(step.odometry),
                ellipseArea(step.lines));
  return text;
}

}  // namespace

LineDrive driveByLines(const LineDrivePlan& plan) {
  return Driver(plan).drive(plan.duration);
}

double ellipseArea(const Gaussian2& belief) {
  const Eigen::Matrix2d P = belief.covariance.topLeftCorner<2, 2>();
  return kPi * kWithin * std::sqrt(std::max(0.0, P.determinant()));
}

double deviationAlong(const Gaussian2& belief, double angle) {
  const Eigen::Vector2d along(std::cos(angle), std::sin(angle));
  return std::sqrt(std::max(0.0, along.dot(belief.covariance.topLeftCorner<2, 2>() * along)));
}

std::string toTable(const LineDrive& drive) {
  constexpr std::size_t kParts = 10;
  std::string text =
      "   after driven      error, m        deviation across    deviation along   99 % ellipse, "
      "m2\n"
      "       s      m odometry    lines odometry    lines odometry    lines  odometry     lines\n";
  for (std::size_t i = 0; i <= kParts; ++i) {
    text += rowOf(drive.steps[(drive.steps.size() - 1) * i / kParts]);
  }
  return text;
}

nlohmann::json toJson(const LineDrive& drive) {
  nlohmann::json steps = nlohmann::json::array(), hits = steps, seen = steps;
  for (const LineDriveStep& step : drive.steps) {
    steps.push_back({{"stamp", step.stamp},
                     {"driven", step.driven},
                     {"truth", {step.T_map_base.x, step.T_map_base.y}},
                     {"odometry", toJson(step.odometry)},
                     {"lines", toJson(step.lines)}});
  }
  for (const Eigen::Vector2d& hit : drive.hits) hits.push_back({hit.x(), hit.y()});
  for (const SeenLine& line : drive.seen) {
    seen.push_back({{"segment", toJson(line.segment)}, {"is_matched", line.is_matched}});
  }
  return {{"kind", "line_drive"}, {"walls", toJson(drive.walls)},     {"steps", steps},
          {"hits", hits},         {"matched", toJson(drive.matched)}, {"seen", seen}};
}

}  // namespace adaptive_localization
