// SPDX-License-Identifier: BSD-3-Clause
#include "node_choice.hpp"

#include <algorithm>

namespace adaptive_localization {
namespace {

constexpr double kPatience = 10.0;  // s, with a node that was not chosen and is gone

}  // namespace

void NodeChoice::choose(const std::string& node) {
  chosen_ = node;
  if (node.empty() || node == current_) return;
  current_ = node;
  is_there_ = false;
}

void NodeChoice::update(const std::vector<std::string>& found, double now) {
  const auto is_found = [&] {
    return std::find(found.begin(), found.end(), current_) != found.end();
  };
  const bool may_change = chosen_.empty() && !found.empty() && !is_found();
  if (may_change && (current_.empty() || now - last_there_ > kPatience)) current_ = found.front();
  is_there_ = is_found();
  if (is_there_) last_there_ = now;
}

}  // namespace adaptive_localization
