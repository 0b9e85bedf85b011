// SPDX-License-Identifier: BSD-3-Clause
#include "eval/consistency.hpp"

#include <Eigen/Cholesky>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <stdexcept>
#include <string>

namespace adaptive_localization {

std::optional<double> normalizedError(const Pose2& estimate, const Eigen::Matrix3d& covariance,
                                      const Pose2& truth) {
  const Eigen::Vector3d error(truth.x - estimate.x, truth.y - estimate.y,
                              wrapAngle(truth.theta - estimate.theta));
  const Eigen::LLT<Eigen::Matrix3d> factor(covariance);
  if (!covariance.allFinite() || factor.info() != Eigen::Success) return std::nullopt;
  const double squared = factor.matrixL().solve(error).squaredNorm();
  if (!std::isfinite(squared)) return std::nullopt;
  return squared;
}

Band consistencyBand(int runs, double probability) {
  if (runs < 1) {
    throw std::invalid_argument("number of runs: got " + std::to_string(runs) +
                                ", expected at least 1");
  }
  if (!(probability > 0.0 && probability < 1.0)) {
    throw std::invalid_argument("probability of the band: got " + std::to_string(probability) +
                                ", expected more than 0 and less than 1");
  }
  const boost::math::chi_squared errors(3.0 * runs);
  const double tail = (1.0 - probability) / 2.0;
  return {quantile(errors, tail) / runs, quantile(complement(errors, tail)) / runs};
}

}  // namespace adaptive_localization
