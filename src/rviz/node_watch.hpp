// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "node_choice.hpp"
#include "node_graph.hpp"
#include "node_link.hpp"

namespace adaptive_localization {

/// Looks for localization nodes once a second and keeps a link to the one that is shown, in a
/// thread of its own: the master may take its time.
class NodeWatch {
 public:
  /// What is known by now. Whoever has a link gives it back soon: the next one waits for that.
  struct Seen {
    bool is_master_there{false};
    std::vector<std::string> nodes;  // found at the last look
    std::string chosen;              // by somebody; empty: none
    std::string current;             // shown; empty: none
    bool is_current_there{false};
    std::shared_ptr<NodeLink> link;  // none while there is nothing to hear
    std::string trouble;             // why there is no link, in words
  };

  NodeWatch();
  /// Waits for the master's answer, if it is being asked.
  ~NodeWatch();

  Seen seen() const;

  /// Shows this node from now on; empty: whichever there is.
  void choose(const std::string& node);

 private:
  void run();
  void look();
  void relink(const LocalizationNames* names);

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  bool is_over_{false};
  bool is_asked_{false};  // to look at once
  NodeChoice choice_;
  Seen seen_;
  std::thread thread_;
};

}  // namespace adaptive_localization
