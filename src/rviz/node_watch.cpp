// SPDX-License-Identifier: BSD-3-Clause
#include "node_watch.hpp"

#include <algorithm>
#include <chrono>

#include "core/error_text.hpp"
#include "master_state.hpp"

namespace adaptive_localization {
namespace {

constexpr std::chrono::seconds kPeriod(1);
constexpr std::chrono::milliseconds kMoment(5);

}  // namespace

NodeWatch::NodeWatch() : thread_([this] { run(); }) {}

NodeWatch::~NodeWatch() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_over_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

NodeWatch::Seen NodeWatch::seen() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return seen_;
}

void NodeWatch::choose(const std::string& node) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    choice_.choose(node);
    seen_.chosen = node;
    seen_.current = choice_.current();
    seen_.is_current_there = choice_.isThere();
    is_asked_ = true;
  }
  changed_.notify_all();
}

void NodeWatch::run() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (!is_over_) {
    is_asked_ = false;
    lock.unlock();
    look();
    lock.lock();
    changed_.wait_for(lock, kPeriod, [this] { return is_over_ || is_asked_; });
  }
}

void NodeWatch::look() {
  const auto graph = askMaster();
  const auto found = graph ? findLocalizations(*graph) : std::vector<LocalizationNames>();
  std::vector<std::string> nodes;
  for (const LocalizationNames& names : found) nodes.push_back(names.node);
  std::string current;
  bool was_there = false;
  LocalizationNames linked;  // to whom there is a link
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    choice_.update(nodes, steadySeconds());
    was_there = seen_.is_current_there;
    current = choice_.current();
    if (seen_.link) linked = seen_.link->names();
    seen_.is_master_there = graph.has_value();
    seen_.nodes = nodes;
    seen_.current = current;
    seen_.is_current_there = choice_.isThere();
  }
  const auto names = std::find_if(found.begin(), found.end(),
                                  [&](const auto& node) { return node.node == current; });
  if (names == found.end()) {  // one that is gone may come back
    if (!linked.node.empty() && linked.node != current) relink(nullptr);
  } else if (!was_there || !(linked == *names)) {
    relink(&*names);
  }
}

/// The old link ends before the new one begins, so that a new master hears of it as well.
void NodeWatch::relink(const LocalizationNames* names) {
  std::shared_ptr<NodeLink> link;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::swap(link, seen_.link);
    seen_.trouble.clear();
  }
  while (link.use_count() > 1) std::this_thread::sleep_for(kMoment);
  link.reset();
  if (!names) return;
  std::string trouble;
  try {
    link = std::make_shared<NodeLink>(*names);
  } catch (...) {
    trouble = errorText();
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  seen_.link = link;
  seen_.trouble = trouble;
}

}  // namespace adaptive_localization
