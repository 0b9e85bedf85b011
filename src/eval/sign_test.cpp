// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/eval/sign_test.hpp"

#include <algorithm>
#include <cmath>

namespace adaptive_localization {

double signTest(int wins, int losses) {
  const int n = wins + losses;
  double p = 0.0;
  for (int k = std::max(0, wins); k <= n; ++k) {
    p += std::exp(std::lgamma(n + 1.0) - std::lgamma(k + 1.0) - std::lgamma(n - k + 1.0) -
                  n * std::log(2.0));
  }
  return std::min(1.0, p);
}

double signTestOfLess(const std::vector<int>& values, const std::vector<int>& of_others) {
  int wins = 0, losses = 0;
  for (std::size_t i = 0; i < std::min(values.size(), of_others.size()); ++i) {
    wins += values[i] < of_others[i] ? 1 : 0;
    losses += values[i] > of_others[i] ? 1 : 0;
  }
  return signTest(wins, losses);
}

}  // namespace adaptive_localization
