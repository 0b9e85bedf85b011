// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "presets.hpp"

namespace adaptive_localization {

/// What W. Araujo Neto did with every swarm (Localização de Robôs Móveis Utilizando o Novo
/// Algoritmo de Morcegos Baseado em Líderes, doctoral thesis, UFJF, Juiz de Fora 2019): 2000
/// searchers, 11 beams as far as the laser sees, the mean relative deviation, spread over the whole
/// map, a torus, until 3 per cent or for 500 iterations; the answer is the best pose x*. A fix is
/// for good until odometry has drifted away from it. Where the thesis is ambiguous: its objective
/// is signed and not summed up, ours is the mean of min(1, |z* - z| / z).
Preset sourceOfSwarms();

/// Its bats (X.-S. Yang 2010): as printed, but for the sign, with which they flee the best one.
Preset sourceOfBats();

/// Its leaders: one for 300 bats; walks are about the best of all, as its listing has them.
Preset sourceOfLeaders();

/// The particle filter that its swarms were compared with: as many particles as bats, 11 beams,
///
///     w = prod_j exp(-(z_j - z_j*)^2 / (2 sigma^2)),
///
/// and a roulette at each scan, whose draws lie about the one drawn. Their deviations are not
/// printed: 0.05 m and 0.03 rad here, as the motion's noise, which is the same, and 0.2 m for
/// sigma; a beam counts 7.4 sigma at most. The answer is the mean of the heaviest cluster, which is
/// that of all as soon as there is one.
Preset sourceOfComparedParticles();

}  // namespace adaptive_localization
