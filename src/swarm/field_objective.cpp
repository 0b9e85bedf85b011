// SPDX-License-Identifier: BSD-3-Clause
#include "swarm/field_objective.hpp"

#include <algorithm>
#include <cmath>

#include "core/parallel.hpp"

namespace adaptive_localization {

FieldObjective::FieldObjective(const Scan& scan, int hits, double truncation,
                               std::shared_ptr<const DistanceField> field)
    : field_(std::move(field)) {
  const Eigen::Index all = scan.x.size();
  const Eigen::Index count = std::min<Eigen::Index>(all, hits);
  const double cells_per_metre = 1.0 / field_->lattice().resolution();
  hits_.resize(2, count);
  Eigen::Index kept = 0;
  for (Eigen::Index k = 0; k < count; ++k) {
    const Eigen::Index j = (2 * k + 1) * all / (2 * count);
    if (!std::isfinite(scan.x[j]) || !std::isfinite(scan.y[j])) continue;
    hits_.col(kept++) << static_cast<double>(scan.x[j]), static_cast<double>(scan.y[j]);
  }
  hits_.conservativeResize(2, kept);
  hits_ *= cells_per_metre;
  truncation_ = truncation / field_->metresPerStep();
}

double FieldObjective::costAt(const Pose2& T_map_base) const {
  const Lattice& lattice = field_->lattice();
  const Pose2 pose = lattice.toLattice(T_map_base);
  const double x = pose.x / lattice.resolution(), y = pose.y / lattice.resolution();
  const double c = std::cos(pose.theta), s = std::sin(pose.theta);
  const double width = lattice.width(), height = lattice.height();
  double sum = 0.0;
  for (Eigen::Index k = 0; k < hits_.cols(); ++k) {
    const double u = x + c * hits_(0, k) - s * hits_(1, k);
    const double v = y + s * hits_(0, k) + c * hits_(1, k);
    const bool is_inside = u >= 0.0 && v >= 0.0 && u < width && v < height;
    sum += is_inside ? std::min<double>(field_->stepsTo({static_cast<int>(u), static_cast<int>(v)}),
                                        truncation_)
                     : truncation_;
  }
  return sum * field_->metresPerStep() / std::max<double>(1.0, static_cast<double>(hits_.cols()));
}

void FieldObjective::evaluate(const Eigen::ArrayXXd& positions,
                              Eigen::Ref<Eigen::ArrayXd> costs) const {
  constexpr std::size_t kPosesPerChunk = 256;
  parallelFor(static_cast<std::size_t>(positions.rows()), kPosesPerChunk, [&](const Chunk& chunk) {
    for (std::size_t k = chunk.begin; k < chunk.end; ++k) {
      const auto i = static_cast<Eigen::Index>(k);
      costs[i] = costAt({positions(i, 0), positions(i, 1), positions(i, 2)});
    }
  });
}

}  // namespace adaptive_localization
