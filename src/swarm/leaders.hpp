// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "swarm/swarm.hpp"

namespace adaptive_localization {

/// floor(bats / bats_per_leader), but at least `least`, and no more than there are bats.
Eigen::Index numberOfLeaders(Eigen::Index bats, int bats_per_leader, int least);

/// The best bats, best first; ties by number.
std::vector<Eigen::Index> bestBats(const Swarm& swarm, Eigen::Index count);

/// For each bat which of the leaders (numbered as given) is nearest in the first two dimensions:
/// the Voronoi partition into colonies.
std::vector<std::size_t> nearestLeaders(const Swarm& swarm,
                                        const std::vector<Eigen::Index>& leaders);

}  // namespace adaptive_localization
