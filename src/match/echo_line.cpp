// SPDX-License-Identifier: BSD-3-Clause
#include "echo_line.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "adaptive_localization/core/pose2.hpp"

namespace adaptive_localization {
namespace {

using Vector = Eigen::Vector2d;

constexpr double kSoft = 5.0 * kPi / 180.0;  // beyond a cone's side, rad
constexpr double kSurest = 0.1;              // deviation of a direction that is sure enough, rad

/// Across a line, and along it.
struct Axes {
  explicit Axes(double alpha)
      : normal(std::cos(alpha), std::sin(alpha)), along(-normal.y(), normal.x()) {}
  Vector normal, along;
};

/// What is observed of (rho, alpha), from (0, alpha).
struct Row {
  Vector a;              // Jacobian
  double rest;           // observed - expected
  double variance;       // by the sonar
  Eigen::RowVector3d g;  // Jacobian by what odometry did since
  Eigen::Matrix3d drift;

  double drifted() const { return g * drift * g.transpose(); }
  double weight() const { return 1.0 / (variance + drifted()); }
};
using Rows = std::vector<Row>;

Rows rowsOf(const std::vector<SonarEcho>& echoes, double alpha) {
  const Axes axes(alpha);
  Rows rows;
  rows.reserve(echoes.size());
  for (const SonarEcho& echo : echoes) {
    const double place = axes.along.dot(echo.position);
    rows.push_back({{1.0, -place},
                    axes.normal.dot(echo.position) + echo.range,
                    echo.range_std * echo.range_std,
                    {axes.normal.x(), axes.normal.y(), -place},
                    echo.drift});
  }
  return rows;
}

Eigen::Matrix2d informationOf(const Rows& rows) {
  Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
  for (const Row& row : rows) information += row.weight() * row.a * row.a.transpose();
  return information;
}

/// (rho, what is to be added to alpha).
Vector solve(const Rows& rows) {
  Vector pull = Vector::Zero();
  for (const Row& row : rows) pull += row.weight() * row.rest * row.a;
  return informationOf(rows).inverse() * pull;
}

/// By how much the echoes are noisier than they should be, in variance; at least 1.
double excessOf(const Rows& rows, const Vector& solution) {
  double sum = 0.0;
  for (const Row& row : rows) {
    const double off = row.rest - row.a.dot(solution);
    sum += off * off * row.weight();
  }
  return std::max(1.0, sum / (static_cast<double>(rows.size()) - 2.0));
}

Eigen::Matrix2d covarianceOf(const Rows& rows, double excess) {
  const Eigen::Matrix2d inverse = informationOf(rows).inverse();
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  Eigen::Matrix<double, 2, 3> older = Eigen::Matrix<double, 2, 3>::Zero();  // sum of m g
  for (const Row& row : rows) {
    const Vector m = inverse * row.a * row.weight();
    const Eigen::Matrix2d shared = older * row.drift * row.g.transpose() * m.transpose();
    covariance += m * (excess * row.variance + row.drifted()) * m.transpose();
    covariance += shared + shared.transpose();
    older += m * row.g;
  }
  return covariance;
}

}  // namespace

double gapBetween(const SonarEcho& echo, double rho, double alpha) {
  return rho - Axes(alpha).normal.dot(echo.position) - echo.range;
}

bool looksAt(const SonarEcho& echo, double alpha) {
  return std::abs(wrapAngle(alpha - echo.course)) < echo.half_view + kSoft;
}

std::optional<ScanLine> lineTouching(const std::vector<SonarEcho>& echoes, double alpha) {
  constexpr int kRounds = 3;
  if (echoes.size() < 3) return std::nullopt;
  for (int round = 0; round < kRounds; ++round) {
    alpha = wrapAngle(alpha + solve(rowsOf(echoes, alpha)).y());
    const bool is_in_all = std::all_of(echoes.begin(), echoes.end(),
                                       [&](const SonarEcho& echo) { return looksAt(echo, alpha); });
    if (!is_in_all) return std::nullopt;
  }
  const Rows rows = rowsOf(echoes, alpha);
  const Vector solution = solve(rows);

  ScanLine line;
  line.rho = solution.x();
  line.alpha = alpha;
  line.covariance = covarianceOf(rows, excessOf(rows, solution));
  const bool is_sure = line.covariance(1, 1) < kSurest * kSurest;
  const bool is_covariance = line.covariance(0, 0) > 0.0 && line.covariance.determinant() > 0.0;
  if (!is_sure || !is_covariance || !std::isfinite(line.rho)) return std::nullopt;

  const Axes axes(alpha);
  const auto [first, last] = std::minmax_element(
      echoes.begin(), echoes.end(), [&](const SonarEcho& a, const SonarEcho& b) {
        return axes.along.dot(a.position) < axes.along.dot(b.position);
      });
  line.a = line.rho * axes.normal + axes.along.dot(first->position) * axes.along;
  line.b = line.rho * axes.normal + axes.along.dot(last->position) * axes.along;
  return line;
}

}  // namespace adaptive_localization
