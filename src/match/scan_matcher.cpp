// SPDX-License-Identifier: BSD-3-Clause
#include "match/scan_matcher.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "alignment.hpp"
#include "match/line_map.hpp"

namespace adaptive_localization {
namespace {

constexpr int kLeastHits = 10;       // of a scan that is matched
constexpr double kSmallStep = 1e-4;  // m: the end
constexpr double kShrink = 0.7;      // of the reach, from one iteration to the next

/// Root mean square distance of the hits from base, at least a metre.
double leverOf(const Scan& scan) {
  const double mean = static_cast<double>((scan.x.square() + scan.y.square()).mean());
  return std::isfinite(mean) ? std::max(1.0, std::sqrt(mean)) : 1.0;
}

double way(const Pose2& a, const Pose2& b, double lever) {
  return distance(a, b) + lever * std::abs(wrapAngle(a.theta - b.theta));
}

/// Turns rows that have this covariance into ones that do not depend on each other.
void makeIndependent(const Match::Square& covariance, Match& match) {
  if (match.H.rows() == 0) return;
  const Eigen::SelfAdjointEigenSolver<Match::Square> solver(covariance);
  const Match::Square turn = solver.eigenvectors().transpose();
  match.H = Match::Rows(turn * match.H);
  match.rest = Match::Vector(turn * match.rest);
  match.variance = solver.eigenvalues();
}

}  // namespace

ScanMatcher::ScanMatcher(const MatchOptions& options, std::shared_ptr<const SurfaceMap> surfaces)
    : options_(options), surfaces_(std::move(surfaces)) {
  if (options_.match_reach >= options_.match_reach_end) return;
  std::ostringstream message;
  message << "option 'match_reach': got '" << options_.match_reach
          << "', expected at least match_reach_end, which is '" << options_.match_reach_end << "'";
  throw std::invalid_argument(message.str());
}

ScanMatcher makeScanMatcher(const MatchOptions& options, SurfaceMaps& surfaces) {
  const double reach = 2.0 * options.match_reach;  // of labels: a hit's cell may be beside the wall
  if (options.line_map.empty()) {
    ScanMatcher matcher(options, surfaces.faces(reach));
    const auto middles = surfaces.middles(reach);
    if (middles) matcher.tryAlso({options, middles});
    return matcher;
  }
  const Lattice& lattice = surfaces.map().lattice();
  const auto lines = loadLineMap(options.line_map, lattice);
  return {options, std::make_shared<const SurfaceMap>(lattice, lines, reach)};
}

Match ScanMatcher::match(const Pose2& guess, const Scan& scan, const Eigen::Matrix3d& prior) const {
  const Match own = matchAlone(guess, scan, prior);
  if (!other_) return own;
  constexpr double kNoise = 0.005;  // m, of mean distances
  const Match others = other_->match(guess, scan, prior);
  vote_.add(std::log((badness(own) + kNoise) / (badness(others) + kNoise)));
  return vote_.leadOfMiddles() > 0.0 ? others : own;
}

void ScanMatcher::tryAlso(ScanMatcher other) {
  other_ = std::make_shared<const ScanMatcher>(std::move(other));
}

/// Mean distance of all hits, m, those that do not fit being as far off as others may be.
double ScanMatcher::badness(const Match& match) const {
  return match.inlier_ratio * match.mean_distance +
         (1.0 - match.inlier_ratio) * options_.match_reach_end;
}

Match ScanMatcher::matchAlone(const Pose2& guess, const Scan& scan,
                              const Eigen::Matrix3d& prior) const {
  Match match;
  match.fits.assign(static_cast<std::size_t>(scan.hits()), 0);
  if (isFinite(guess)) match.T_map_base = guess;
  if (scan.hits() < kLeastHits || !isFinite(guess)) {
    match.fault = isFinite(guess) ? MatchFault::kFewHits : MatchFault::kNoGuess;
    return match;
  }
  align(scan, prior, match);
  rate(scan, match);
  return match;
}

void ScanMatcher::align(const Scan& scan, const Eigen::Matrix3d& information, Match& match) const {
  const double lever = leverOf(scan);
  const PriorHits prior(match.T_map_base, information, hitVariance(), lever);
  MatchPairs pairs;
  double reach = options_.match_reach;
  while (match.iterations < options_.match_max_iterations) {
    pairAt(match.T_map_base, scan, reach, pairs);
    weigh(pairs, scan.hits(), reach);
    const Pose2 before = match.T_map_base;
    match.T_map_base = options_.match_metric == "line" ? stepToLines(before, pairs, lever, prior)
                                                       : stepToPoints(before, pairs);
    ++match.iterations;
    const bool is_last_reach = reach <= options_.match_reach_end;
    if (is_last_reach && way(before, match.T_map_base, lever) < kSmallStep) return;
    reach = std::max(options_.match_reach_end, kShrink * reach);
  }
}

void ScanMatcher::pairAt(const Pose2& T_map_base, const Scan& scan, double reach,
                         MatchPairs& pairs) const {
  pairs.clear();
  pairs.reserve(static_cast<std::size_t>(scan.x.size()));
  const double c = std::cos(T_map_base.theta);
  const double s = std::sin(T_map_base.theta);
  const double ends = surfaces_->lattice().resolution();  // walls are not known better
  const Eigen::Vector2d base(T_map_base.x, T_map_base.y);
  const Eigen::Vector2d sensor = T_map_base * scan.position;
  for (Eigen::Index i = 0; i < scan.x.size(); ++i) {
    const double x = scan.x[i];
    const double y = scan.y[i];
    const Eigen::Vector2d arm(c * x - s * y, s * x + c * y);
    const Surface* surface = surfaces_->hitBy(sensor, base + arm);
    if (!surface) continue;
    const Eigen::Vector2d normal = surface->normal.cast<double>();
    const Eigen::Vector2d tangent(-normal.y(), normal.x());
    const Eigen::Vector2d& middle = surface->point;
    const Eigen::Vector2d off = base + arm - middle;
    const double residual = normal.dot(off);
    const double along = tangent.dot(off);
    const double half = static_cast<double>(surface->half_length);
    if (!(std::abs(residual) < reach) || std::abs(along) > half + ends) continue;
    const Eigen::Vector2d target = middle + std::max(-half, std::min(along, half)) * tangent;
    pairs.push_back({i, arm, normal, target, residual, precisionOf(normal, base + arm - sensor)});
  }
}

/// A wall that a beam grazes is known better from it than one that it meets head-on.
double ScanMatcher::precisionOf(const Eigen::Vector2d& normal, const Eigen::Vector2d& ray) const {
  const double length = ray.squaredNorm();
  const double across = normal.dot(ray);
  const double square = length > 0.0 ? across * across / length : 1.0;  // cos^2 of incidence
  const double range = options_.match_range_std * options_.match_range_std;
  const double surface = options_.match_surface_std * options_.match_surface_std;
  return (range + surface) / (range * square + surface);
}

double ScanMatcher::hitVariance() const {
  const double range = options_.match_range_std * options_.match_range_std;
  const double surface = options_.match_surface_std * options_.match_surface_std;
  return (range + surface) / options_.match_information;
}

/// Outliers are the fewer the nearer the pose is: the kernel narrows with the reach. Where a
/// consensus is sought it is while the reach narrows, or all the way if it does not.
void ScanMatcher::weigh(MatchPairs& pairs, int hits, double reach) const {
  constexpr double kKernels = 2.0;  // in a reach
  const bool is_annealing = reach > options_.match_reach_end;
  const bool is_constant = options_.match_reach == options_.match_reach_end;
  const double scale = std::max(options_.match_kernel, is_annealing ? reach / kKernels : 0.0);
  if (options_.match_outliers == "trim") {
    keepBest(pairs, hits, scale);
  } else if (options_.match_outliers == "ransac" && (is_annealing || is_constant)) {
    keepConsensus(pairs, scale);
  } else if (options_.match_outliers != "none") {
    weighByKernel(pairs, scale);
  }
}

/// What the match is worth where it ended.
void ScanMatcher::rate(const Scan& scan, Match& match) const {
  MatchPairs pairs;
  pairAt(match.T_map_base, scan, options_.match_reach_end, pairs);
  double sum = 0.0;
  for (const MatchPair& pair : pairs) {
    match.fits[static_cast<std::size_t>(pair.hit)] = 1;
    sum += std::abs(pair.residual);
  }
  const auto count = static_cast<double>(pairs.size());
  match.inlier_ratio = count / scan.hits();
  match.mean_distance = pairs.empty() ? 0.0 : sum / count;
  weigh(pairs, scan.hits(), options_.match_reach_end);
  const double lever = leverOf(scan);
  const NormalEquations normal(pairs, lever);
  const Directions observable(normal);
  const double seen = normal.weight > 0.0 ? normal.squares / normal.weight : 0.0;
  const double variance = std::max(hitVariance(), seen / options_.match_information);
  match.H = observable.columns.transpose();
  match.H.col(2) *= lever;
  match.variance = variance * observable.hits.cwiseInverse();
  match.rest = -(observable.columns.transpose() * normal.b).cwiseQuotient(observable.hits);
  if (options_.match_metric == "point") match.rest.setZero();  // no prior held the pose back
  const Eigen::Vector3d map_std(options_.match_map_std, options_.match_map_std,
                                options_.match_map_turn_std);
  const Match::Rows shared = match.H * map_std.asDiagonal();
  Match::Square covariance = shared * shared.transpose();
  covariance.diagonal() += match.variance;
  makeIndependent(covariance, match);
  if (match.inlier_ratio < options_.match_least_inliers) {
    match.fault = MatchFault::kOutliers;
  } else if (match.H.rows() == 0) {
    match.fault = MatchFault::kSingular;
  }
}

}  // namespace adaptive_localization
