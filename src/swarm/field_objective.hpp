// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "adaptive_localization/core/scan.hpp"
#include "adaptive_localization/map/distance_field.hpp"
#include "swarm/objective.hpp"

namespace adaptive_localization {

/// How badly a scan fits poses (x, y, theta) of base in map, by the distances d of its hits h from
/// the map's walls:
///
///     F = (1 / H) sum_h min(d(T_map_base h), c)
///
/// Smooth, and little things that are in the way of a beam do no harm; but it does not mind walls
/// that a beam would have to pass, so it is for places near the right one.
class FieldObjective : public Objective {
 public:
  /// With so many hits at the most, evenly spread, and c in m.
  FieldObjective(const Scan& scan, int hits, double truncation,
                 std::shared_ptr<const DistanceField> field);

  void evaluate(const Eigen::ArrayXXd& positions, Eigen::Ref<Eigen::ArrayXd> costs) const override;

 private:
  double costAt(const Pose2& T_map_base) const;

  Eigen::Matrix2Xd hits_;  // in base, cells
  double truncation_;      // steps of the field
  std::shared_ptr<const DistanceField> field_;
};

}  // namespace adaptive_localization
