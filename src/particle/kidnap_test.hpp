// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "adaptive_localization/core/options.hpp"
#include "adaptive_localization/map/distance_field.hpp"
#include "adaptive_localization/map/occupancy_grid.hpp"
#include "particle/exploration.hpp"

namespace adaptive_localization {

struct KidnapOptions {
  double kidnap_mean_abs_error{0.0};
  double kidnap_arm_spread{0.0};
  int kidnap_arm_particles{0};
  double local_share{0.7};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("kidnap_mean_abs_error", kidnap_mean_abs_error, kNotNegative, "m",
           "Kidnapping threshold (xi): mean range error per beam of the best particle above which "
           "a scan is not explained; 0: recovery decides instead.");
    option("kidnap_arm_spread", kidnap_arm_spread, kNotNegative, "m",
           "The kidnapping test starts when the mean distance of particles from their mean falls "
           "below this; 0: at once.");
    option("kidnap_arm_particles", kidnap_arm_particles, kWhole, "",
           "The kidnapping test starts when there are fewer particles than this; 0: at once.");
    option("local_share", local_share, kProbability, "",
           "Share of the particles that stay when a kidnapping is detected (alpha).");
  }
};

/// Test for a robot that was carried away (SAMCL, Zhang, Zapata and Lepinay 2009): with the mean
/// range error per beam of the best particle,
///
///     e(best) = (1 / I) sum_i |z_i* - z_i|,   z* by exact ray casting,
///
/// a share 1 - local_share of the next set is drawn elsewhere while e(best) >
/// kidnap_mean_abs_error, once the particles had converged.
std::unique_ptr<Exploration> kidnapTest(const KidnapOptions& options,
                                        std::shared_ptr<const OccupancyGrid> map,
                                        std::shared_ptr<const DistanceField> field = nullptr);

}  // namespace adaptive_localization
