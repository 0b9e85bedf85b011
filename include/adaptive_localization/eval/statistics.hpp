// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <functional>
#include <iterator>
#include <vector>

namespace adaptive_localization {

/// A number of each item: a member, or what a function says.
template <class Item, class Get>
std::vector<double> valuesOf(const std::vector<Item>& items, const Get& get) {
  std::vector<double> values;
  for (const auto& item : items) values.push_back(static_cast<double>(std::invoke(get, item)));
  return values;
}

/// The items of which something holds.
template <class Item, class Predicate>
std::vector<Item> those(const std::vector<Item>& items, const Predicate& holds) {
  std::vector<Item> found;
  std::copy_if(items.begin(), items.end(), std::back_inserter(found), holds);
  return found;
}

// All of these are 0 for no values.
double sum(const std::vector<double>& values);
double mean(const std::vector<double>& values);
double rootMeanSquare(const std::vector<double>& values);
double deviation(const std::vector<double>& values);  // standard, of just these values
double largest(const std::vector<double>& values);

/// The value below which a share of the values lies, interpolated linearly between ranks (type 7 of
/// Hyndman and Fan 1996, numpy's default); 0 for no values.
double quantile(std::vector<double> values, double share);

/// A share with its confidence interval.
struct Share {
  int of{0};
  int count{0};
  double value{0.0};
  double low{0.0}, high{1.0};
};

/// The Wilson score interval (Wilson 1927) at the standard normal quantile z, 1.96 for 95 %:
/// unlike the textbook interval it makes sense for few trials and for shares near 0 and 1.
Share wilson(int count, int of, double z = 1.959963984540054);

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
