// SPDX-License-Identifier: BSD-3-Clause
// A program that tracks a robot through a log, without ROS.
//
//     01_track_log MAP.yaml LOG.clf X Y YAW [KEY=VALUE]...
//
// X, Y and YAW (m, rad) are the pose at the first scan. LOG.clf is one of CARMEN's with lines
// FLASER. Prints stamp, x, y, yaw, status and confidence for each scan. Every option of
// doc/options.md that is not the node's can be set; the node does the same with the messages of a
// robot.
#include <fstream>
#include <iostream>
#include <sstream>

#include "adaptive_localization/localizer/localizer.hpp"
#include "adaptive_localization/map/map_io.hpp"

namespace al = adaptive_localization;

namespace {

constexpr int kArguments = 6;

struct LoggedScan {
  al::LaserScan scan;
  al::Pose2 T_odom_laser;
};

/// FLASER n r_1 .. r_n  laser's x y theta  robot's x y theta  stamp host stamp; the n ranges go
/// from right to left over 180 degrees.
std::optional<LoggedScan> parse(const std::string& line) {
  std::istringstream text(line);
  std::string word;
  std::size_t count = 0;
  if (!(text >> word >> count) || word != "FLASER" || count < 2 || count > 10000)
    return std::nullopt;
  LoggedScan logged;
  logged.scan.angle_min = -al::kPi / 2.0;
  logged.scan.angle_increment = al::kPi / static_cast<double>(count % 2 ? count - 1 : count);
  logged.scan.range_max = 50.0;
  logged.scan.ranges.resize(count);
  for (float& range : logged.scan.ranges) text >> range;
  al::Pose2& laser = logged.T_odom_laser;
  al::Pose2 robot;
  text >> laser.x >> laser.y >> laser.theta >> robot.x >> robot.y >> robot.theta;
  if (!(text >> logged.scan.stamp)) return std::nullopt;
  return logged;
}

void track(const std::string& map, const std::string& log, const al::Pose2& start,
           const al::Parameters& parameters) {
  al::Localizer localizer(parameters, std::make_shared<const al::OccupancyGrid>(al::loadMap(map)));
  for (const std::string& key : localizer.unknownKeys()) {
    throw std::invalid_argument("option '" + key + "' is unknown");
  }
  al::Gaussian2 prior;  // al::Anywhere{} would have the robot looked for all over the map
  prior.mean = start;
  prior.covariance.diagonal() << 0.1, 0.1, 0.05;
  localizer.reset(prior);

  std::ifstream lines(log);
  if (!lines) throw std::invalid_argument("log '" + log + "': cannot be read");
  for (std::string line; std::getline(lines, line);) {
    const auto logged = parse(line);
    if (!logged) continue;
    al::Observations observations;
    observations.stamp = logged->scan.stamp;
    observations.scan = al::toScan(logged->scan, al::LaserMount{}, localizer.scanOptions());
    const al::Localization answer = localizer.update(logged->T_odom_laser, observations);
    const al::Pose2& pose = answer.T_map_base;
    std::cout << observations.stamp << ' ' << pose.x << ' ' << pose.y << ' ' << pose.theta << ' '
              << al::toText(answer.status) << ' ' << answer.confidence << '\n';
    localizer.searchOn();  // for a lost robot, while there is time until the next scan
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < kArguments) {
    std::cerr << "usage: 01_track_log MAP.yaml LOG.clf X Y YAW [KEY=VALUE]...\n";
    return 1;
  }
  try {
    al::Parameters parameters;
    for (int i = kArguments; i < argc; ++i) {
      const std::string text = argv[i];
      const auto sign = text.find('=');
      if (sign == std::string::npos)
        throw std::invalid_argument("got '" + text + "', expected KEY=VALUE");
      parameters.set(text.substr(0, sign), text.substr(sign + 1));
    }
    std::cout.precision(12);
    track(argv[1], argv[2], {std::stod(argv[3]), std::stod(argv[4]), std::stod(argv[5])},
          parameters);
  } catch (const std::exception& error) {
    std::cerr << "01_track_log: " << error.what() << '\n';
    return 1;
  }
}
