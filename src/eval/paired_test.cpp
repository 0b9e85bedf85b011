// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/eval/paired_test.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace adaptive_localization {
namespace {

/// Partner less value, where they differ.
std::vector<int> differences(const std::vector<int>& values, const std::vector<int>& partners) {
  std::vector<int> found;
  for (std::size_t i = 0; i < std::min(values.size(), partners.size()); ++i) {
    if (values[i] != partners[i]) found.push_back(partners[i] - values[i]);
  }
  return found;
}

}  // namespace

double signTest(int wins, int losses) {
  const int n = wins + losses;
  double p = 0.0;
  for (int k = std::max(0, wins); k <= n; ++k) {
    p += std::exp(std::lgamma(n + 1.0) - std::lgamma(k + 1.0) - std::lgamma(n - k + 1.0) -
                  n * std::log(2.0));
  }
  return std::min(1.0, p);
}

double signTestOfLess(const std::vector<int>& values, const std::vector<int>& partners) {
  const auto found = differences(values, partners);
  const auto wins = std::count_if(found.begin(), found.end(), [](int d) { return d > 0; });
  return signTest(static_cast<int>(wins), static_cast<int>(found.size()) - static_cast<int>(wins));
}

double signedRankTestOfLess(const std::vector<int>& values, const std::vector<int>& partners) {
  auto found = differences(values, partners);
  if (found.empty()) return 1.0;
  std::sort(found.begin(), found.end(), [](int a, int b) { return std::abs(a) < std::abs(b); });
  const auto n = static_cast<double>(found.size());
  double in_favour = 0.0;
  double variance = n * (n + 1.0) * (2.0 * n + 1.0) / 24.0;
  for (std::size_t begin = 0, end = 0; begin < found.size(); begin = end) {
    while (end < found.size() && std::abs(found[end]) == std::abs(found[begin])) ++end;
    const double rank = 0.5 * static_cast<double>(begin + 1 + end);  // the mean of those tied
    for (std::size_t i = begin; i < end; ++i) in_favour += found[i] > 0 ? rank : 0.0;
    const auto tied = static_cast<double>(end - begin);
    variance -= (tied * tied * tied - tied) / 48.0;
  }
  const double z = (in_favour - n * (n + 1.0) / 4.0 - 0.5) / std::sqrt(variance);
  return 0.5 * std::erfc(z / std::sqrt(2.0));
}

}  // namespace adaptive_localization
