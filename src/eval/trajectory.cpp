// SPDX-License-Identifier: BSD-3-Clause
#include "eval/trajectory.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <stdexcept>

#include "core/whole_file.hpp"

namespace adaptive_localization {
namespace {

constexpr double kSameInstant = 1e-3;  // s

std::optional<StampedPose> parseTumLine(const std::string& line) {
  std::istringstream fields(line);
  double stamp{}, x{}, y{}, z{}, qx{}, qy{}, qz{}, qw{};
  std::string rest;
  if (!(fields >> stamp >> x >> y >> z >> qx >> qy >> qz >> qw) || fields >> rest) return {};
  const double norm = std::hypot(std::hypot(qx, qy), std::hypot(qz, qw));
  const double yaw = std::atan2(2.0 * (qw * qz + qx * qy), 1.0 - 2.0 * (qy * qy + qz * qz));
  if (!std::isfinite(stamp) || !isFinite({x, y, yaw}) || std::abs(norm - 1.0) > 0.01) return {};
  return StampedPose{stamp, {x, y, wrapAngle(yaw)}};
}

bool isComment(const std::string& line) {
  const auto first = line.find_first_not_of(" \t\r");
  return first == std::string::npos || line[first] == '#';
}

}  // namespace

Pose2 interpolate(const Pose2& from, const Pose2& to, double share) {
  return {from.x + share * (to.x - from.x), from.y + share * (to.y - from.y),
          wrapAngle(from.theta + share * wrapAngle(to.theta - from.theta))};
}

Trajectory::Trajectory(std::vector<StampedPose> poses) {
  std::stable_sort(poses.begin(), poses.end(),
                   [](const StampedPose& a, const StampedPose& b) { return a.stamp < b.stamp; });
  for (const auto& pose : poses) {
    if (!poses_.empty() && poses_.back().stamp == pose.stamp) poses_.pop_back();
    poses_.push_back(pose);
  }
}

std::optional<Pose2> Trajectory::at(double stamp, double max_gap) const {
  const auto after =
      std::lower_bound(poses_.begin(), poses_.end(), stamp,
                       [](const StampedPose& pose, double wanted) { return pose.stamp < wanted; });
  const auto is_near = [&](const StampedPose& pose) {
    return std::abs(pose.stamp - stamp) <= kSameInstant;
  };
  if (after != poses_.end() && after->stamp == stamp) return after->pose;
  if (after != poses_.end() && after != poses_.begin()) {
    const auto before = after - 1;
    const double gap = after->stamp - before->stamp;
    if (gap <= max_gap) {
      return interpolate(before->pose, after->pose, (stamp - before->stamp) / gap);
    }
  }
  if (after != poses_.begin() && is_near(*(after - 1))) return (after - 1)->pose;
  if (after != poses_.end() && is_near(*after)) return after->pose;
  return {};
}

Trajectory readTum(std::istream& input, const std::string& name,
                   std::vector<std::string>& warnings) {
  std::vector<StampedPose> poses;
  std::string line;
  for (int number = 1; std::getline(input, line); ++number) {
    if (isComment(line)) continue;
    if (const auto pose = parseTumLine(line)) {
      poses.push_back(*pose);
    } else {
      warnings.push_back("'" + name + "' line " + std::to_string(number) + ": got '" +
                         line.substr(0, 60) + "', expected 'stamp x y z qx qy qz qw'; skipped");
    }
  }
  if (poses.empty()) {
    throw std::invalid_argument("trajectory '" + name +
                                "': no pose found, expected lines of 'stamp x y z qx qy qz qw'");
  }
  return Trajectory(std::move(poses));
}

Trajectory loadTum(const std::string& file, std::vector<std::string>& warnings) {
  std::ifstream input(file);
  if (!input) throw std::invalid_argument("trajectory '" + file + "': cannot be opened");
  return readTum(input, file, warnings);
}

void writeTum(const std::vector<StampedPose>& poses, std::ostream& output) {
  output << "# stamp x y z qx qy qz qw : base in map\n" << std::fixed;
  for (const auto& [stamp, pose] : poses) {
    output << std::setprecision(6) << stamp << ' ' << pose.x << ' ' << pose.y << " 0 0 0 "
           << std::setprecision(9) << std::sin(0.5 * pose.theta) << ' '
           << std::cos(0.5 * pose.theta) << '\n';
  }
}

void saveTum(const std::vector<StampedPose>& poses, const std::string& file) {
  std::ostringstream output;
  writeTum(poses, output);
  writeWholeFile(file, output.str());
}

}  // namespace adaptive_localization
