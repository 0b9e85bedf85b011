// SPDX-License-Identifier: BSD-3-Clause
#include "sonar_lines.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "observation/sonar_reading.hpp"

namespace adaptive_localization {
namespace {

constexpr std::size_t kMost = 200;          // echoes that are kept,
constexpr double kFarthestEcho = 3.0;       // m back,
constexpr double kLever = 0.5;              // m that a radian counts for
constexpr double kSamePlace = 0.02;         // m, and rad
constexpr double kStep = 2.5 * kPi / 180.;  // between directions that are tried, rad
constexpr double kAgree = 2.5;              // deviations
constexpr double kPassage = 0.5;            // m that a robot needs
constexpr std::size_t kLeastEchoes = 4;     // of a line,
constexpr double kLeastLength = 0.2;        // m

bool isSamePing(const SonarEcho& a, const SonarEcho& b) {
  return a.sonar == b.sonar && (a.position - b.position).norm() < kSamePlace &&
         std::abs(wrapAngle(a.course - b.course)) < kSamePlace;
}

}  // namespace

struct SonarLines::Guess {
  double rho, alpha;
  double support;
};

void SonarLines::move(const Pose2& motion, const Eigen::Matrix3d& noise) {
  if (!isFinite(motion) || !noise.allFinite()) return forget();
  const Pose2 back = inverse(motion);
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(-motion.theta).toRotationMatrix();
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();  // into the frame of base now
  rotation.topLeftCorner<2, 2>() = turn;
  Eigen::Matrix3d transport = rotation;  // of what odometry did before
  transport.topRightCorner<2, 1>() = turn * Eigen::Vector2d(-motion.y, motion.x);
  const double way = std::hypot(motion.x, motion.y) + kLever * std::abs(motion.theta);
  for (SonarEcho& echo : echoes_) {
    echo.position = back * echo.position;
    echo.course = wrapAngle(echo.course - motion.theta);
    echo.way += way;
    echo.drift =
        transport * echo.drift * transport.transpose() + rotation * noise * rotation.transpose();
  }
  const auto is_far = [](const SonarEcho& echo) { return !(echo.way < kFarthestEcho); };
  echoes_.erase(std::remove_if(echoes_.begin(), echoes_.end(), is_far), echoes_.end());
}

void SonarLines::hear(const std::vector<SonarReading>& readings) {
  for (const SonarReading& reading : readings) {
    if (!isUsable(reading) || !isEcho(reading)) continue;
    const Pose2& mount = reading.T_base_sonar;
    SonarEcho echo{{mount.x, mount.y},
                   wrapAngle(mount.theta),
                   reading.range,
                   reading.view / 2.0,
                   options_.line_sonar_std + shareOfRange(reading.range),
                   reading.sonar};
    const auto is_before = [&](const SonarEcho& other) { return isSamePing(other, echo); };
    echoes_.erase(std::remove_if(echoes_.begin(), echoes_.end(), is_before), echoes_.end());
    if (echoes_.size() == kMost) echoes_.erase(echoes_.begin());
    echoes_.push_back(std::move(echo));
    ++heard_;
  }
}

std::vector<ScanLine> SonarLines::takeLines() {
  std::vector<Guess> guesses;
  const std::size_t heard = std::min(std::exchange(heard_, 0), echoes_.size());
  for (std::size_t i = echoes_.size() - heard; i < echoes_.size(); ++i) {
    guesses.push_back(bestThrough(echoes_[i]));
  }
  std::stable_sort(guesses.begin(), guesses.end(),
                   [](const Guess& a, const Guess& b) { return a.support > b.support; });
  std::vector<ScanLine> lines;
  for (const Guess& guess : guesses) {
    if (auto line = take(guess.rho, guess.alpha)) lines.push_back(std::move(*line));
  }
  return lines;
}

/// That most echoes agree with.
SonarLines::Guess SonarLines::bestThrough(const SonarEcho& echo) const {
  Guess best{0.0, 0.0, -1.0};
  for (double off = -echo.half_view; off < echo.half_view + kStep; off += kStep) {
    const double alpha = wrapAngle(echo.course + std::min(off, echo.half_view));
    const double rho = -gapBetween(echo, 0.0, alpha);
    double support = 0.0;
    for (const SonarEcho& other : echoes_) {
      if (!looksAt(other, alpha)) continue;
      const double gap = gapBetween(other, rho, alpha) / (kAgree * other.range_std);
      support += std::max(0.0, 1.0 - gap * gap);
    }
    if (support > best.support) best = {rho, alpha, support};
  }
  return best;
}

/// Those that agree with a line, without a gap between that a robot could pass.
std::vector<std::size_t> SonarLines::touching(double rho, double alpha) const {
  const Eigen::Vector2d along(-std::sin(alpha), std::cos(alpha));
  std::vector<std::pair<double, std::size_t>> places;
  for (std::size_t i = 0; i < echoes_.size(); ++i) {
    const SonarEcho& echo = echoes_[i];
    const bool agrees = std::abs(gapBetween(echo, rho, alpha)) < kAgree * echo.range_std;
    if (agrees && looksAt(echo, alpha)) places.emplace_back(along.dot(echo.position), i);
  }
  std::sort(places.begin(), places.end());
  std::vector<std::size_t> longest, run;
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (k > 0 && places[k].first - places[k - 1].first > kPassage) run.clear();
    run.push_back(places[k].second);
    if (run.size() > longest.size()) longest = run;
  }
  std::sort(longest.begin(), longest.end());
  return longest;
}

/// How many echoes are of something behind a line, though a wall there faced their sonars.
std::size_t SonarLines::passing(const ScanLine& line) const {
  const Eigen::Vector2d along = (line.b - line.a).normalized();
  const auto passes = [&](const SonarEcho& echo) {
    const double place = along.dot(echo.position - line.a);
    const double gap = gapBetween(echo, line.rho, line.alpha);
    return place > 0.0 && place < line.length() && gap < -kAgree * echo.range_std &&
           looksAt(echo, line.alpha);
  };
  return static_cast<std::size_t>(std::count_if(echoes_.begin(), echoes_.end(), passes));
}

/// The line near one, whose echoes are used up then.
std::optional<ScanLine> SonarLines::take(double rho, double alpha) {
  constexpr int kRounds = 2;
  std::optional<ScanLine> line;
  std::vector<std::size_t> members;
  for (int round = 0; round < kRounds; ++round) {
    members = touching(rho, alpha);
    if (members.size() < kLeastEchoes) return std::nullopt;
    std::vector<SonarEcho> echoes;
    for (const std::size_t i : members) echoes.push_back(echoes_[i]);
    line = lineTouching(echoes, alpha);
    if (!line || line->length() < kLeastLength) return std::nullopt;
    if (passing(*line) >= members.size()) return std::nullopt;
    rho = line->rho;
    alpha = line->alpha;
  }
  for (auto i = members.rbegin(); i != members.rend(); ++i) {
    echoes_.erase(echoes_.begin() + static_cast<std::ptrdiff_t>(*i));
  }
  return line;
}

}  // namespace adaptive_localization
