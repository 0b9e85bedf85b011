// SPDX-License-Identifier: BSD-3-Clause
#include "plain_field.hpp"

#include <algorithm>
#include <cmath>

namespace adaptive_localization {
namespace {

constexpr double kMaxDistance = 2.0;  // m
constexpr double kHit = 0.95;
constexpr double kRandom = 0.05;
constexpr double kSigma = 0.2;  // m

}  // namespace

PlainField::PlainField(const DistanceField& field) : lattice_(field.lattice()) {
  cells_.reserve(lattice_.size());
  for (std::size_t i = 0; i < lattice_.size(); ++i) {
    cells_.push_back({0, std::min(kMaxDistance, field.at(lattice_.cell(i)))});
  }
}

void PlainField::score(const Scan& scan, std::vector<Sample>& samples) const {
  static_assert(sizeof(Cell) == 16, "as large as amcl's");
  for (auto& sample : samples) {
    double p = 1.0;
    for (Eigen::Index j = 0; j < scan.range.size(); ++j) {
      const double range = static_cast<double>(scan.range[j]);
      const double bearing = sample.theta + static_cast<double>(scan.bearing[j]);
      const double x = sample.x + range * std::cos(bearing);
      const double y = sample.y + range * std::sin(bearing);
      const int column = static_cast<int>(std::floor(x / lattice_.resolution()));
      const int row = static_cast<int>(std::floor(y / lattice_.resolution()));
      const adaptive_localization::Cell cell{column, row};
      const double d =
          lattice_.contains(cell) ? cells_[lattice_.index(cell)].distance : kMaxDistance;
      const double pz =
          kHit * std::exp(-(d * d) / (2.0 * kSigma * kSigma)) + kRandom / scan.max_range;
      p += pz * pz * pz;
    }
    sample.weight *= p;
  }
}

std::vector<PlainField::Sample> PlainField::samplesOf(const Particles& particles) {
  std::vector<Sample> samples;
  for (Eigen::Index i = 0; i < particles.size(); ++i) {
    samples.push_back({particles.x[i], particles.y[i], particles.theta[i], 1.0});
  }
  return samples;
}

}  // namespace adaptive_localization
