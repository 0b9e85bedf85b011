// SPDX-License-Identifier: BSD-3-Clause
#include "eval/start.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <iomanip>
#include <sstream>
#include <stdexcept>

namespace adaptive_localization {
namespace {

bool hasReference(const LogScan& scan) {
  return scan.T_map_base.has_value();
}

Pose2 firstReference(Log& log) {
  const auto first = std::find_if(log.scans.begin(), log.scans.end(), hasReference);
  if (first == log.scans.end()) {
    throw std::invalid_argument(
        "--start truth: no reference at any scan; give one with --truth or --truth-topic");
  }
  if (const auto early = first - log.scans.begin(); early > 0) {
    log.warnings.push_back(std::to_string(early) +
                           " scans before the reference begins are not used");
  }
  log.scans.erase(log.scans.begin(), first);
  return *log.scans.front().T_map_base;
}

std::string poseText(const Pose2& pose) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(3) << '(' << pose.x << ", " << pose.y << ") m, "
       << std::setprecision(1) << pose.theta * 180.0 / kPi << " deg";
  return text.str();
}

/// From where to where a map goes, in its frame.
std::string extentText(const Lattice& lattice) {
  const double width = lattice.width() * lattice.resolution();
  const double height = lattice.height() * lattice.resolution();
  Eigen::AlignedBox2d box;
  for (const Pose2& corner :
       {Pose2{}, Pose2{width, 0.0, 0.0}, Pose2{0.0, height, 0.0}, Pose2{width, height, 0.0}}) {
    const Pose2 corner_map = lattice.origin() * corner;
    box.extend(Eigen::Vector2d(corner_map.x, corner_map.y));
  }
  std::ostringstream text;
  text << std::fixed << std::setprecision(3) << "x from " << box.min().x() << " to "
       << box.max().x() << " m, y from " << box.min().y() << " to " << box.max().y() << " m";
  return text.str();
}

bool isReference(const std::string& start) {
  return start.empty() || start == "truth";
}

}  // namespace

Pose2 toPose(const std::string& argument, const std::string& text, const std::string& expected) {
  std::istringstream fields(text);
  Pose2 pose;
  char comma1{}, comma2{}, rest{};
  const bool is_read =
      static_cast<bool>(fields >> pose.x >> comma1 >> pose.y >> comma2 >> pose.theta);
  if (!is_read || comma1 != ',' || comma2 != ',' || fields >> rest || !isFinite(pose)) {
    throw std::invalid_argument(argument + ": got '" + text + "', expected " + expected);
  }
  return {pose.x, pose.y, wrapAngle(pose.theta)};
}

Prior startPrior(const std::string& start, const StartOptions& options, Log& log) {
  const bool has_reference = std::any_of(log.scans.begin(), log.scans.end(), hasReference);
  if (start == "global" || (start.empty() && !has_reference)) return Anywhere{};
  if (isReference(start)) return options.around(firstReference(log));
  return options.around(toPose("--start", start, "truth, global or X,Y,YAW in m and rad"));
}

std::string startText(const std::string& start, const Prior& prior) {
  const auto* told = std::get_if<Gaussian2>(&prior);
  if (!told) return "anywhere on the map";
  return "at " + poseText(told->mean) + (isReference(start) ? ", as the reference says" : "");
}

void checkStart(const std::string& start, const Prior& prior, const OccupancyGrid& map) {
  const auto* told = std::get_if<Gaussian2>(&prior);
  if (!told || map.lattice().contains(map.lattice().cellAt({told->mean.x, told->mean.y}))) return;
  const std::string what =
      isReference(start) ? "--start truth: the reference begins" : "--start: got a pose";
  throw std::invalid_argument(what + " at " + poseText(told->mean) +
                              ", expected one on the map: " + extentText(map.lattice()));
}

}  // namespace adaptive_localization
