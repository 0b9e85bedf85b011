// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace adaptive_localization {

/// The one-sided sign test for pairs: how likely at least so many of them fall in favour of the
/// first by chance, if none of both is better,
///
///     p = sum_{k >= wins} C(n, k) / 2^n,   n = wins + losses
///
/// Pairs that are equal are left out. 1 where none is left.
double signTest(int wins, int losses);

/// The same for values in pairs, where less is better.
double signTestOfLess(const std::vector<int>& values, const std::vector<int>& of_others);

}  // namespace adaptive_localization
