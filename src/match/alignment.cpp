// SPDX-License-Identifier: BSD-3-Clause
#include "alignment.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace adaptive_localization {
namespace {

constexpr double kLeastTelling = 2.0;   // hits that a direction needs
constexpr double kTellingShare = 0.01;  // and as a share of all
constexpr double kVaguest = 1e3;        // m, what a prior says at the least

}  // namespace

NormalEquations::NormalEquations(const MatchPairs& pairs, double lever) {
  for (const MatchPair& pair : pairs) {
    Eigen::Vector3d row = pair.row();
    row.z() /= lever;
    const double w = pair.weight * pair.precision;
    A += w * row * row.transpose();
    b += w * pair.residual * row;
    weight += pair.weight;
    squares += w * pair.residual * pair.residual;
  }
}

Directions::Directions(const NormalEquations& normal) {
  if (!normal.A.allFinite()) return;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(normal.A);
  const double least = std::max(kLeastTelling, kTellingShare * normal.weight);
  const auto count = (solver.eigenvalues().array() >= least).count();
  columns = solver.eigenvectors().rightCols(count);
  hits = solver.eigenvalues().tail(count);
}

PriorHits::PriorHits(const Pose2& guess, const Eigen::Matrix3d& information, double hit_variance,
                     double lever)
    : mean(guess), is_none(information.isZero(0.0)) {
  const Eigen::DiagonalMatrix<double, 3> scale(1.0, 1.0, 1.0 / lever);
  A = hit_variance * (scale * information * scale);
  A.diagonal().array() += hit_variance / (kVaguest * kVaguest);
}

Pose2 stepToLines(const Pose2& from, const MatchPairs& pairs, double lever,
                  const PriorHits& prior) {
  const NormalEquations normal(pairs, lever);
  Eigen::Vector3d step;
  if (prior.is_none) {
    const Directions observable(normal);
    const Match::Vector along =
        (observable.columns.transpose() * normal.b).cwiseQuotient(observable.hits);
    step = observable.columns * along;
  } else {
    const Eigen::Vector3d off(from.x - prior.mean.x, from.y - prior.mean.y,
                              lever * wrapAngle(from.theta - prior.mean.theta));
    const Eigen::LLT<Eigen::Matrix3d> all(normal.A + prior.A);
    if (all.info() != Eigen::Success) return from;  // the prior is no information
    step = all.solve(normal.b + prior.A * off);
  }
  if (!step.allFinite()) return from;
  return {from.x - step.x(), from.y - step.y(), wrapAngle(from.theta - step.z() / lever)};
}

Pose2 stepToPoints(const Pose2& from, const MatchPairs& pairs) {
  Eigen::Vector2d p_mean{0.0, 0.0}, q_mean{0.0, 0.0};
  double weight = 0.0, cross = 0.0, dot = 0.0;
  const Eigen::Vector2d base(from.x, from.y);
  for (const MatchPair& pair : pairs) {
    p_mean += pair.weight * pair.arm;
    q_mean += pair.weight * (pair.target - base);
    weight += pair.weight;
  }
  if (!(weight > 0.0)) return from;
  p_mean /= weight;
  q_mean /= weight;
  for (const MatchPair& pair : pairs) {
    const Eigen::Vector2d p = pair.arm - p_mean;
    const Eigen::Vector2d q = pair.target - base - q_mean;
    cross += pair.weight * (p.x() * q.y() - p.y() * q.x());
    dot += pair.weight * p.dot(q);
  }
  const double turn = std::atan2(cross, dot);
  const Eigen::Vector2d shift = base + q_mean - Pose2{0.0, 0.0, turn} * p_mean;
  return {shift.x(), shift.y(), wrapAngle(from.theta + turn)};
}

}  // namespace adaptive_localization
