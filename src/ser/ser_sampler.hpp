// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "particle/pose_sampler.hpp"
#include "ser/places.hpp"

namespace adaptive_localization {

/// Uniform over the Similar Energy Region (SAMCL, step "draw N_G samples from the SER"): the cells
/// and headings at which a scan would have the energy of the one just taken, inside of each cell
/// and half a heading step to both sides. All free space where the region is empty and where there
/// is no energy grid yet.
class SerSampler : public PoseSampler {
 public:
  /// Throws std::invalid_argument if the map has no free cell.
  SerSampler(std::shared_ptr<Places> places, std::shared_ptr<const OccupancyGrid> map);

  bool condition(const Observations& observations) override;
  Pose2 draw(Rng& rng) const override;

  bool isEmpty() const { return region_.isEmpty(); }

 private:
  std::shared_ptr<Places> places_;
  FreeSpaceSampler free_space_;
  std::shared_ptr<const EnergyGrid> grid_;
  EnergyGrid::Region region_;
};

}  // namespace adaptive_localization
