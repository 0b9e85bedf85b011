// SPDX-License-Identifier: BSD-3-Clause
#include "core/suggestion.hpp"

#include <algorithm>

namespace adaptive_localization {
namespace {

/// Rows of the table of distances between the beginnings of a and b, three of them at a time.
std::size_t editDistance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> before, last(b.size() + 1), now(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    now[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      now[j] = std::min({last[j] + 1, now[j - 1] + 1, changed});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) now[j] = std::min(now[j], before[j - 2] + 1);
    }
    before = last;
    last = now;
  }
  return last[b.size()];
}

}  // namespace

std::string suggestion(const std::string& written, const std::vector<std::string>& known) {
  std::size_t least = written.size() / 3 + 1;
  std::string nearest;
  for (const auto& name : known) {
    const std::size_t distance = editDistance(written, name);
    if (distance < least) {
      least = distance;
      nearest = name;
    }
  }
  return nearest.empty() ? "" : "; did you mean '" + nearest + "'?";
}

std::vector<std::string> keysOf(const std::vector<OptionDescription>& options) {
  std::vector<std::string> keys;
  for (const auto& option : options) keys.push_back(option.key);
  return keys;
}

}  // namespace adaptive_localization
