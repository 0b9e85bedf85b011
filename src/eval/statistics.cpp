// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/eval/statistics.hpp"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <cstdlib>
#include <numeric>

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

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

double mean(const std::vector<double>& values) {
  return values.empty() ? 0.0 : sum(values) / static_cast<double>(values.size());
}

double rootMeanSquare(const std::vector<double>& values) {
  return std::sqrt(mean(valuesOf(values, [](double value) { return value * value; })));
}

double deviation(const std::vector<double>& values) {
  const double middle = mean(values);
  return rootMeanSquare(valuesOf(values, [&](double value) { return value - middle; }));
}

double largest(const std::vector<double>& values) {
  return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  const double rank = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(rank);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (rank - static_cast<double>(below)) * (values[above] - values[below]);
}

Share wilson(int count, int of, double z) {
  if (of <= 0) return {};
  const double n = of, share = count / n;
  const double centre = (share + z * z / (2.0 * n)) / (1.0 + z * z / n);
  const double half =
      z / (1.0 + z * z / n) * std::sqrt(share * (1.0 - share) / n + z * z / (4.0 * n * n));
  const double low = count == 0 ? 0.0 : centre - half;  // without the rounding
  const double high = count == of ? 1.0 : centre + half;
  return {of, count, share, low, high};
}

double signTest(int wins, int losses) {
  if (wins <= 0) return 1.0;
  return cdf(complement(boost::math::binomial(wins + losses, 0.5), wins - 1));
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
