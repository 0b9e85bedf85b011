// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "map/ray_caster.hpp"
#include "map/wall_vote.hpp"
#include "observation/likelihood_field.hpp"

namespace adaptive_localization {

/// Likelihood field for a map with thick walls. Where they were painted from a plan, a laser sees
/// their faces; where they come from scans that were laid over each other inexactly, it sees what
/// is in their middles. A field of whole walls lets a pose slide by half their depth either way. So
/// hits are measured from faces or middles as soon as scans have told which, and until then from
/// the walls.
class ThickWallsField : public ObservationModel {
 public:
  ThickWallsField(const ObservationOptions& options, std::shared_ptr<const OccupancyGrid> map,
                  std::shared_ptr<const DistanceField> field);

  double score(const Observations& observations, const Particles& particles,
               Eigen::Ref<Eigen::ArrayXd> log_likelihood) const override;

 private:
  const LikelihoodField& field() const;
  double evidenceFrom(const Scan& scan, const Particles& particles) const;

  RayCaster ray_caster_;
  std::shared_ptr<const DistanceField> walls_;
  LikelihoodField by_walls_, by_faces_, by_middles_;
  mutable WallVote vote_;
};

}  // namespace adaptive_localization
