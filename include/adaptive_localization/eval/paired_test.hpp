// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace adaptive_localization {

/// How likely values in pairs are so much less than their partners by chance, if no side is better
/// (one-sided). Pairs that are equal are left out; 1 where none is left.
///
/// The sign test, by how often they are less:
///
///     p = sum_{k >= wins} C(n, k) / 2^n,   n = wins + losses
double signTestOfLess(const std::vector<int>& values, const std::vector<int>& partners);
double signTest(int wins, int losses);

/// Wilcoxon's signed-rank test, which minds by how much: W the sum of the ranks of |differences| in
/// favour, its distribution by the normal one, corrected for ties and continuity. For ten pairs and
/// more.
double signedRankTestOfLess(const std::vector<int>& values, const std::vector<int>& partners);

}  // namespace adaptive_localization
