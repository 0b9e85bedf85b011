// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace adaptive_localization {

/// Which of several localization nodes is shown. Where nobody chose, that is the first found, and
/// another only once it has been gone for long: a node that is started again is still the one.
class NodeChoice {
 public:
  /// Somebody's choice, kept whether the node is there or not; empty: none.
  void choose(const std::string& node);
  const std::string& chosen() const { return chosen_; }

  /// The nodes that there are, at a time in s of a clock that only goes on.
  void update(const std::vector<std::string>& found, double now);

  /// The node to be shown; empty: none yet.
  const std::string& current() const { return current_; }

  /// Whether it was there at the last update.
  bool isThere() const { return is_there_; }

 private:
  std::string chosen_;
  std::string current_;
  bool is_there_{false};
  double last_there_{0.0};  // s
};

}  // namespace adaptive_localization
