// SPDX-License-Identifier: BSD-3-Clause
#include "carmen_line.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

namespace adaptive_localization {
namespace {

constexpr int kMostBeams = 100000;
constexpr double kShortestRange = 0.05;  // m

/// The fields of a line, taken one after the other.
class Fields {
 public:
  explicit Fields(const std::string& line) : line_(line) {}

  std::string text(const std::string& name) {
    std::string field;
    if (!(line_ >> field)) throw std::invalid_argument("ends before '" + name + "'");
    return field;
  }

  double number(const std::string& name) {
    const std::string field = text(name);
    char* end = nullptr;
    const double value = std::strtod(field.c_str(), &end);
    if (*end != '\0' || !std::isfinite(value)) {
      throw std::invalid_argument(name + ": got '" + field.substr(0, 40) + "', expected a number");
    }
    return value;
  }

  int count(const std::string& name, int most) {
    const double value = number(name);
    if (value < 0 || value > most || value != std::floor(value)) {
      throw std::invalid_argument(name + ": got " + std::to_string(value) +
                                  ", expected a whole number up to " + std::to_string(most));
    }
    return static_cast<int>(value);
  }

  Pose2 pose(const std::string& name) {
    const double x = number(name + " x");
    const double y = number(name + " y");
    return {x, y, wrapAngle(number(name + " theta"))};
  }

 private:
  std::istringstream line_;
};

std::vector<float> readRanges(Fields& fields, int beams) {
  if (beams == 0) throw std::invalid_argument("has no beams");
  std::vector<float> ranges;
  for (int i = 0; i < beams; ++i) ranges.push_back(static_cast<float>(fields.number("range")));
  return ranges;
}

/// FLASER n r1..rn, laser pose, robot pose (odometry), stamp, host, logger's time.
/// 180 and 181 beams lie a degree apart, 360 and 361 half a degree.
void readFlaser(Fields& fields, LogScan& result) {
  LaserScan& scan = result.scan;
  const int beams = fields.count("number of beams", kMostBeams);
  scan.ranges = readRanges(fields, beams);
  scan.angle_min = -0.5 * kPi;
  scan.angle_increment = kPi / std::max(1, beams - beams % 2);
  fields.pose("laser");
  result.T_odom_base = fields.pose("robot");
  scan.stamp = fields.number("stamp");
}

/// ROBOTLASER1 type, start angle, field of view, increment, max range, accuracy, remission mode,
/// n r1..rn, m e1..em, laser pose, robot pose, two velocities, three safety numbers, stamp, host,
/// logger's time.
void readRobotLaser(Fields& fields, LogScan& result) {
  LaserScan& scan = result.scan;
  fields.number("laser type");
  scan.angle_min = fields.number("start angle");
  fields.number("field of view");
  scan.angle_increment = fields.number("angular resolution");
  scan.range_max = fields.number("maximum range");
  fields.number("accuracy");
  fields.number("remission mode");
  scan.ranges = readRanges(fields, fields.count("number of beams", kMostBeams));
  const int remissions = fields.count("number of remissions", kMostBeams);
  for (int i = 0; i < remissions; ++i) fields.number("remission");
  fields.pose("laser");
  result.T_odom_base = fields.pose("robot");
  for (const char* name : {"tv", "rv", "forward", "side", "turn axis"}) fields.number(name);
  scan.stamp = fields.number("stamp");
  if (scan.angle_increment == 0.0) throw std::invalid_argument("angular resolution is 0");
  if (scan.range_max <= kShortestRange)
    throw std::invalid_argument("maximum range is not positive");
}

}  // namespace

std::optional<LogScan> CarmenParser::parse(const std::string& line) {
  Fields fields(line);
  if (line.find_first_not_of(" \t\r") == std::string::npos || line[0] == '#') return {};
  const std::string kind = fields.text("kind");
  if (kind == "PARAM") {
    const std::string name = fields.text("name");
    readParameter(name, line);
    return {};
  }
  if (kind == "ODOM") {
    fields.pose("robot");
    for (const char* name : {"tv", "rv", "acceleration", "stamp"}) fields.number(name);
    return {};
  }
  if (kind != "FLASER" && kind != "ROBOTLASER1") return {};
  LogScan result;
  result.mount = LaserMount::level(T_base_laser_);
  result.scan.range_min = kShortestRange;
  result.scan.range_max = range_max_;
  kind == "FLASER" ? readFlaser(fields, result) : readRobotLaser(fields, result);
  if (scan_kind_.empty()) scan_kind_ = kind;
  if (kind != scan_kind_) return {};
  return result;
}

void CarmenParser::readParameter(const std::string& name, const std::string& line) {
  Fields fields(line);
  fields.text("kind");
  fields.text("name");
  if (name == "robot_frontlaser_offset") {
    T_base_laser_.x = fields.number(name);
    knows_mount_ = true;
  } else if (name == "robot_frontlaser_side_offset") {
    T_base_laser_.y = fields.number(name);
  } else if (name == "robot_frontlaser_angular_offset") {
    T_base_laser_.theta = wrapAngle(fields.number(name));
  } else if (name == "robot_front_laser_max") {
    const double range = fields.number(name);
    if (range <= kShortestRange) throw std::invalid_argument(name + " is not positive");
    range_max_ = range;
  }
}

}  // namespace adaptive_localization
