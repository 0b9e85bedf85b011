// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

namespace adaptive_localization {

/// A number of each item: a member, or what a function says.
template <class Item, class Get>
std::vector<double> valuesOf(const std::vector<Item>& items, const Get& get) {
  std::vector<double> values;
  for (const auto& item : items) values.push_back(static_cast<double>(std::invoke(get, item)));
  return values;
}

// All of these are 0 for no values.
double sum(const std::vector<double>& values);
double mean(const std::vector<double>& values);
double rootMeanSquare(const std::vector<double>& values);
double largest(const std::vector<double>& values);

/// The value below which a share of the values lies, interpolated linearly between ranks (type 7 of
/// Hyndman and Fan 1996, numpy's default); 0 for no values.
double quantile(std::vector<double> values, double share);

}  // namespace adaptive_localization
