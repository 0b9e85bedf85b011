// SPDX-License-Identifier: BSD-3-Clause
#include "eval/log_spoiler.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace adaptive_localization {
namespace {

/// The odometry told anew: `tell` takes each motion from scan to scan, and the later scan's number.
template <class Tell>
Log retell(Log log, const Tell& tell) {
  Pose2 T_odom_before;
  for (std::size_t i = 0; i < log.scans.size(); ++i) {
    Pose2& T_odom_base = log.scans[i].T_odom_base;
    const Pose2 motion = i > 0 ? between(T_odom_before, T_odom_base) : Pose2{};
    T_odom_before = T_odom_base;
    if (i > 0) T_odom_base = log.scans[i - 1].T_odom_base * tell(motion, i);
  }
  return log;
}

/// The log without the scans that are not wanted.
template <class IsWanted>
Log keep(Log log, const IsWanted& isWanted) {
  auto& scans = log.scans;
  scans.erase(std::remove_if(scans.begin(), scans.end(),
                             [&](const LogScan& scan) { return !isWanted(scan); }),
              scans.end());
  return log;
}

/// The scans in the midst of turns: where the robot turned by half a right angle within about a
/// metre.
std::vector<std::size_t> findTurns(const Log& log) {
  constexpr double kTurn = kPi / 4.0;
  constexpr double kMemory = 1.0;  // m
  std::vector<std::size_t> turns;
  double turned = 0.0;
  bool is_turning = false;
  for (std::size_t i = 1; i < log.scans.size(); ++i) {
    const Pose2 motion = between(log.scans[i - 1].T_odom_base, log.scans[i].T_odom_base);
    turned = turned * std::exp(-std::hypot(motion.x, motion.y) / kMemory) + motion.theta;
    const bool begins = !is_turning && std::abs(turned) > kTurn;
    if (begins) turns.push_back(i);
    is_turning = begins || (is_turning && std::abs(turned) > 0.5 * kTurn);
  }
  return turns;
}

/// The wheels slip to either side in the first turn and in about half of the others.
Log slip(const Log& log, double degrees, Rng& rng) {
  std::vector<double> slips(log.scans.size(), 0.0);
  const auto turns = findTurns(log);
  for (const std::size_t turn : turns) {
    const double angle = rng.uniform(2.0 / 3.0, 4.0 / 3.0) * degrees * kPi / 180.0;
    const double side = rng.uniform() < 0.5 ? -1.0 : 1.0;
    if (rng.uniform() < 0.5 || turn == turns.front()) slips[turn] = side * angle;
  }
  Log spoiled = retell(log, [&](const Pose2& motion, std::size_t i) {
    return motion * Pose2{0.0, 0.0, slips[i]};
  });
  if (turns.empty()) spoiled.warnings.push_back("no slips: the robot turns nowhere by 45 deg");
  return spoiled;
}

Log scale(const Log& log, double share, Rng&) {
  return retell(log, [&](const Pose2& motion, std::size_t) {
    return Pose2{(1.0 + share) * motion.x, (1.0 + share) * motion.y, motion.theta};
  });
}

/// But never the first, so that there is one.
Log lose(const Log& log, double share, Rng& rng) {
  int number = 0;
  return keep(log, [&](const LogScan&) { return number++ == 0 || rng.uniform() >= share; });
}

Log delay(Log log, double seconds, Rng&) {
  return restamped(std::move(log), seconds);
}

Log thin(const Log& log, double way, Rng&) {
  double since = way;  // since a scan was kept, m
  const LogScan* before = nullptr;
  std::vector<LogScan> kept;
  for (const auto& scan : log.scans) {
    if (before) since += distance(before->T_odom_base, scan.T_odom_base);
    before = &scan;
    if (since < way) continue;
    since = 0.0;
    kept.push_back(scan);
  }
  return {std::move(kept), log.warnings, log.skipped};
}

/// Mean time from scan to scan, s.
double periodOf(const std::vector<LogScan>& scans) {
  return (scans.back().scan.stamp - scans.front().scan.stamp) /
         static_cast<double>(scans.size() - 1);
}

/// Where pieces of the log begin, and its end.
std::vector<std::size_t> cut(const std::vector<LogScan>& scans, double seconds) {
  std::vector<std::size_t> ends{0};
  for (std::size_t i = 1; i < scans.size(); ++i) {
    if (scans[i].scan.stamp - scans[ends.back()].scan.stamp >= seconds) ends.push_back(i);
  }
  ends.push_back(scans.size());
  return ends;
}

/// A piece of a log after others: odometry rests while the robot is carried to where it begins, and
/// the gyroscope, which would notice, is not heard.
void append(std::vector<LogScan> piece, double period, std::vector<LogScan>& scans) {
  const LogScan first = piece.front();
  const LogScan& before = scans.empty() ? first : scans.back();
  const double later = before.scan.stamp - first.scan.stamp + (scans.empty() ? 0.0 : period);
  const Pose2 T_new_old = before.T_odom_base * inverse(first.T_odom_base);
  for (LogScan& scan : piece) {
    scan.scan.stamp += later;
    scan.T_odom_base = T_new_old * scan.T_odom_base;
    scan.gyro.reset();
    scans.push_back(std::move(scan));
  }
}

/// The robot starts where it did, and then drives the other pieces in any order.
Log carry(const Log& log, double seconds, Rng& rng) {
  if (log.scans.size() < 2) return log;
  const auto ends = cut(log.scans, seconds);
  std::vector<std::size_t> order(ends.size() - 1);
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t i = order.size() - 1; i > 1; --i) std::swap(order[i], order[1 + rng.below(i)]);
  Log carried{{}, log.warnings, log.skipped};
  for (const std::size_t piece : order) {
    const auto at = [&](std::size_t i) {
      return log.scans.begin() + static_cast<std::ptrdiff_t>(ends[i]);
    };
    append({at(piece), at(piece + 1)}, periodOf(log.scans), carried.scans);
  }
  if (order.size() < 2) carried.warnings.push_back("not carried: the log is too short");
  return carried;
}

}  // namespace

Log restamped(Log log, double seconds) {
  std::vector<StampedPose> odometry, reference;
  for (const auto& scan : log.scans) {
    odometry.push_back({scan.scan.stamp, scan.T_odom_base});
    if (scan.T_map_base) reference.push_back({scan.scan.stamp, *scan.T_map_base});
  }
  const Trajectory odom(std::move(odometry)), truth(std::move(reference));
  for (auto& scan : log.scans) {
    scan.scan.stamp += seconds;
    if (scan.T_map_base) scan.T_map_base = truth.at(scan.scan.stamp);
    if (const auto pose = odom.at(scan.scan.stamp)) scan.T_odom_base = *pose;
  }
  if (odom.empty()) return log;
  const double first = odom.poses().front().stamp, last = odom.poses().back().stamp;
  return keep(std::move(log), [&](const LogScan& scan) {
    return scan.scan.stamp >= first && scan.scan.stamp <= last;
  });
}

const Damages<Log>& logDamages() {
  static const Damages<Log> all{
      {{"slip", 7.5, {0.0, 135.0}, "deg", "odometry turns by this, a third more or less, in turns"},
       slip},
      {{"scale", 0.02, {-0.9, 1.0}, "", "odometry makes ways longer by this share"}, scale},
      {{"lost", 0.3, {0.0, 1.0}, "", "this share of the scans is missing"}, lose},
      {{"late", 0.1, {0.0, 10.0}, "s", "scans are stamped this much too late"}, delay},
      {{"thin", 1.0, {0.0, 1e6}, "m", "one scan on this much of the way"}, thin},
      {{"carried", 30.0, {1.0, 1e6}, "s", "pieces of this length in another order"}, carry}};
  return all;
}

Log spoil(const Log& log, const std::string& kind, double amount, std::uint64_t seed) {
  Log spoiled = spoilWith(logDamages(), log, kind, amount, seed);
  if (!spoiled.scans.empty() || log.scans.empty()) return spoiled;
  throw std::invalid_argument("damage '" + kind + "': no scan of the log is left");
}

}  // namespace adaptive_localization
