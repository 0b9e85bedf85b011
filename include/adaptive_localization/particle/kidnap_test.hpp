// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "adaptive_localization/core/options.hpp"
#include "adaptive_localization/map/occupancy_grid.hpp"
#include "adaptive_localization/particle/exploration.hpp"

namespace adaptive_localization {

struct KidnapOptions {
  double kidnap_mean_abs_error{0.16};
  double kidnap_truncation{0.25};
  double kidnap_unusual{2.0};
  int kidnap_confirm_scans{2};
  double kidnap_ratio{2.5};
  double kidnap_arm_spread{0.0};
  int kidnap_arm_particles{0};
  double local_share{0.2};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("kidnap_mean_abs_error", kidnap_mean_abs_error, kPositive, "m",
           "The best particle does not explain a scan if its mean range error per beam is above "
           "this.");
    option(
        "kidnap_truncation", kidnap_truncation, kPositive, "m",
        "A range that is wrong by more than this counts as wrong by this: what people before the "
        "laser may add.");
    option(
        "kidnap_unusual", kidnap_unusual, kNotNegative, "",
        "Nor does it if the error is this many times the usual one; 0: never mind what is usual.");
    option("kidnap_confirm_scans", kidnap_confirm_scans, Range{1, 1000}, "",
           "Scans in a row that the best particle does not explain before others are looked for.");
    option(
        "kidnap_ratio", kidnap_ratio, kNotNegative, "",
        "How many times smaller the error of a place found elsewhere must be for particles to be "
        "drawn there; 0: nothing need be found.");
    option("kidnap_arm_spread", kidnap_arm_spread, kNotNegative, "m",
           "The test is on once the mean distance of particles from their mean was below this; 0: "
           "from the start.");
    option("kidnap_arm_particles", kidnap_arm_particles, kWhole, "",
           "The test is on once there were fewer particles than this; 0: any number.");
    option("local_share", local_share, kProbability, "",
           "Share of the particles that stay when the robot seems to have been kidnapped (alpha).");
  }
};

/// Places where the observations fit, best first; empty if none is known.
using FindElsewhere = std::function<std::vector<Pose2>(const Observations&)>;

/// Test for a robot that was carried away (SAMCL; with the hypothesis test that its authors ask
/// for). With the mean range error per beam of a pose,
///
///     e(pose) = (1 / I) sum_i min(|z_i* - z_i|, c)
///
/// z* by exact ray casting and a no-return counting as max_range, a scan is unexplained if e of the
/// best particle is above kidnap_mean_abs_error or unusual. If that many scans in a row are, and a
/// place found elsewhere has an e that is kidnap_ratio times smaller, in one scan and moved by
/// odometry in the next, a share 1 - local_share of the next set is drawn elsewhere. The ratio is
/// that of the likelihoods of both places, the noise of ranges (Laplace) being unknown:
///
///     log p(scan | there) - log p(scan | here) = I log(e_here / e_there)
///
/// Where nothing better is found and nearly all beams are too short, something stands before the
/// laser: particles that explained scans before are not weighed by this one.
std::unique_ptr<Exploration> kidnapTest(const KidnapOptions& options,
                                        std::shared_ptr<const OccupancyGrid> map,
                                        FindElsewhere find);

}  // namespace adaptive_localization
