// SPDX-License-Identifier: BSD-3-Clause
#include "match/line_matcher.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>

namespace adaptive_localization {
namespace {

constexpr int kRounds = 2;
constexpr double kLeastInliers = 0.2;         // of a scan's hits on matched lines
constexpr int kLeastHits = 10;                // of a scan that is matched
constexpr double kReach = 0.3, kTurn = 0.15;  // m and rad, without a prior
constexpr double kVaguest = 0.5;              // m, of a direction of which lines tell something
constexpr double kLever = 3.0;                // m per rad, so that headings compare with places

/// What lines tell of the pose: information, and its product with the step to the best pose.
struct LineInformation {
  Eigen::Matrix3d information{Eigen::Matrix3d::Zero()};
  Eigen::Vector3d pull{0.0, 0.0, 0.0};

  explicit LineInformation(const std::vector<LineMatch>& matches) {
    for (const auto& match : matches) {
      const Eigen::Matrix<double, 3, 2> weighted = match.H.transpose() * match.R.inverse();
      information += weighted * match.H;
      pull += weighted * match.innovation;
    }
  }
};

/// The information that lines are looked for with: the prior's, and where it has none of a
/// direction, that of the reach without one.
Eigen::Matrix3d knownBefore(const Eigen::Matrix3d& prior) {
  constexpr double kNothing = 1e-6;  // of the information that the reach has
  const Eigen::DiagonalMatrix<double, 3> reach(kReach, kReach, kTurn);
  const Eigen::Matrix3d scaled = reach * prior * reach;
  if (!scaled.allFinite()) return prior;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scaled);
  if (solver.eigenvalues()[0] > kNothing) return prior;
  const Eigen::Array3d values = solver.eigenvalues();
  const Eigen::Vector3d mended = (values > kNothing).select(values, 1.0);
  const Eigen::Matrix3d whole =
      solver.eigenvectors() * mended.asDiagonal() * solver.eigenvectors().transpose();
  const Eigen::DiagonalMatrix<double, 3> back(1.0 / kReach, 1.0 / kReach, 1.0 / kTurn);
  return back * whole * back;
}

/// Rows over (x, y, theta) with the variance of each, and the step along them.
void solve(const LineInformation& lines, Match& match) {
  if (!lines.information.allFinite() || !lines.pull.allFinite()) return;
  const Eigen::DiagonalMatrix<double, 3> to_lever(1.0, 1.0, 1.0 / kLever);
  const Eigen::Matrix3d scaled = to_lever * lines.information * to_lever;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scaled);
  const auto count =
      (solver.eigenvalues().array() > 1.0 / (kVaguest * kVaguest)).count();  // in rising order
  const Match::Rows rows = solver.eigenvectors().rightCols(count).transpose();
  match.variance = solver.eigenvalues().tail(count).cwiseInverse();
  const Match::Vector along = match.variance.asDiagonal() * (rows * (to_lever * lines.pull));
  const Eigen::Vector3d step = to_lever * (rows.transpose() * along);
  match.H = rows * Eigen::DiagonalMatrix<double, 3>(1.0, 1.0, kLever);
  match.rest = Match::Vector::Zero(count);
  match.T_map_base = {match.T_map_base.x + step.x(), match.T_map_base.y + step.y(),
                      wrapAngle(match.T_map_base.theta + step.z())};
}

void countHits(const Scan& scan, const std::vector<ScanLine>& lines,
               const std::vector<LineMatch>& matches, Match& match) {
  int fitting = 0;
  double sum = 0.0;
  for (const auto& line_match : matches) {
    const MapLine& landmark = line_match.landmark;
    for (const int i : lines[static_cast<std::size_t>(line_match.scan_line)].hits) {
      const Eigen::Vector2d hit = match.T_map_base * Eigen::Vector2d(scan.x[i], scan.y[i]);
      sum += std::abs(landmark.normal.dot(hit) - landmark.rho);
      match.fits[static_cast<std::size_t>(i)] = 1;
      ++fitting;
    }
  }
  match.mean_distance = fitting > 0 ? sum / fitting : 0.0;
  match.inlier_ratio = static_cast<double>(fitting) / scan.hits();
}

}  // namespace

LineMatcher::LineMatcher(const LineOptions& options, const std::vector<Segment>& surfaces)
    : options_(options), map_(surfaces) {}

Match LineMatcher::match(const Pose2& guess, const Scan& scan, const Eigen::Matrix3d& prior) const {
  Match match;
  match.fits.assign(static_cast<std::size_t>(scan.hits()), 0);
  if (isFinite(guess)) match.T_map_base = guess;
  if (scan.hits() < kLeastHits || !isFinite(guess)) {
    match.fault = isFinite(guess) ? MatchFault::kFewHits : MatchFault::kNoGuess;
    return match;
  }
  const std::vector<ScanLine> lines = linesOf(scan, options_);
  const Eigen::Matrix3d known = knownBefore(prior);
  Eigen::Matrix3d covariance = known.inverse();
  std::vector<LineMatch> matches;
  for (int round = 0; round < kRounds; ++round) {
    matches = matchLines(match.T_map_base, covariance, lines, map_, options_);
    const LineInformation seen(matches);
    solve(seen, match);
    covariance = (known + seen.information).inverse();
    match.iterations = round + 1;
  }
  countHits(scan, lines, matches, match);
  if (match.inlier_ratio < kLeastInliers) {
    match.fault = MatchFault::kOutliers;
  } else if (match.H.rows() == 0) {
    match.fault = MatchFault::kSingular;
  }
  return match;
}

}  // namespace adaptive_localization
