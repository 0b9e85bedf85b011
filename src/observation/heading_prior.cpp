// SPDX-License-Identifier: BSD-3-Clause
#include "observation/heading_prior.hpp"

#include <algorithm>
#include <cmath>

namespace adaptive_localization {
namespace {

constexpr double kDisturbed = 0.1;  // probability
constexpr double kLeastStd = 1e-3;  // rad

/// None where somebody tells nonsense.
std::optional<Heading> headingOf(const Observations& observations) {
  const auto& heading = observations.heading;
  if (!heading || !std::isfinite(heading->theta) || !(heading->deviation >= 0.0)) return {};
  return Heading{heading->theta, std::max(kLeastStd, heading->deviation)};
}

}  // namespace

double HeadingPrior::score(const Observations& observations, const Particles& particles,
                           Eigen::Ref<Eigen::ArrayXd> log_likelihood) const {
  const auto heading = headingOf(observations);
  if (!heading) return 0.0;
  for (Eigen::Index i = 0; i < particles.size(); ++i) {
    const double off = wrapAngle(particles.theta[i] - heading->theta) / heading->deviation;
    log_likelihood[i] += std::log((1.0 - kDisturbed) * std::exp(-0.5 * off * off) + kDisturbed);
  }
  return 1.0;
}

std::vector<PoseObservation> HeadingPrior::linearized(const Observations& observations,
                                                      const Pose2& T_map_base) const {
  const auto heading = headingOf(observations);
  if (!heading) return {};
  PoseObservation seen;
  seen.innovation.setConstant(1, wrapAngle(heading->theta - T_map_base.theta));
  seen.H = Eigen::RowVector3d::UnitZ();
  seen.R.setConstant(1, 1, heading->deviation * heading->deviation);
  return {seen};
}

}  // namespace adaptive_localization
