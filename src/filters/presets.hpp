// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

#include "adaptive_localization/core/options.hpp"

namespace adaptive_localization {

/// Values of options where they differ from our defaults. What the presets of the sources do
/// otherwise than those is in doc/sources.md.
using Preset = std::map<std::string, OptionValue>;

/// The first one's values where both have one.
Preset operator+(Preset first, const Preset& second);

/// What A. W. Li used on his Pioneer 3-DX for mcl, kld, samcl and sa_kld (Algoritmo Híbrido
/// Auto-adaptativo para Localização em Robótica Móvel, MSc dissertation, UNIFEI, Itajubá 2016):
/// constant motion noise, 30 beams up to 10 m and ray casting, an update per odometry step. Unlike
/// there, expected ranges are without noise, resampling is systematic, not by a wheel that is
/// turned anew for each particle, and headings are averaged on the circle: the text errs there.
Preset sourceOfAll();

/// Its KLD-sampling (Fox 2001): bins of two cells of 0.15 m in x and y only.
Preset sourceOfKld();

/// Its test for kidnapping (SAMCL after Zhang, Zapata, Lepinay 2009): the largest unnormalised
/// weight 1 / sum_i |z_i* - z_i| is below 0.045 with 30 beams, and 70 % stay.
Preset sourceOfSamcl();

/// The source of ekf_icp (J. Lopes, A. Meneses, G. Carvalho, S. Taboada, Localização Indoor baseada
/// no Laser Range Finder usando o Extended Kalman Filter, IST Lisbon): point-to-point ICP, all that
/// is within a metre, no doubts.
Preset sourceOfEkfIcp();

/// Grid cells of D. Fox, W. Burgard, S. Thrun (Markov Localization for Mobile Robots in Dynamic
/// Environments, JAIR 11, 1999): 15 cm and 2 degrees, an update per scan. Unlike there, scans are
/// weighed by the likelihood field instead of tabulated beams, and cells that hold next to nothing
/// are left out for good, unless markov_anywhere keeps them.
Preset sourceOfMarkov();

/// amcl as it is shipped.
Preset stockAmcl();

}  // namespace adaptive_localization
