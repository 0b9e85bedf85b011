// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "adaptive_localization/core/belief.hpp"
#include "swarm/swarm_move.hpp"

namespace adaptive_localization {

/// Poses in the rows of x, y, heading.
Eigen::ArrayXXd columnsOf(const Particles& particles);

/// The same with headings within half a turn of this one, so that a cloud about pi is no wider than
/// it is anywhere else.
Eigen::ArrayXXd columnsAround(double heading, const Particles& particles);

/// Twice as wide as such positions are, but no wider than a turn.
SearchSpace spaceAround(const Eigen::ArrayXXd& positions);

/// So many of the rows, evenly spread; all of them if there are no more.
Eigen::ArrayXXd thinned(const Eigen::ArrayXXd& rows, Eigen::Index count);

/// Each bat where it is and as likely as its cost says.
Particles particlesOf(const Swarm& swarm);

/// The places where the bats are, no surer than a swarm can tell.
Estimate estimateOf(const Particles& bats);

/// Those that lead the swarm.
Particles leadersOf(const Swarm& swarm, const Particles& bats, const LeaderOptions& options);

/// Moves that remember the best place of each searcher stand on these now.
void stepBackToBest(Swarm& swarm);

}  // namespace adaptive_localization
