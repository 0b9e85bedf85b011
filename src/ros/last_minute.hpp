// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace adaptive_localization {

/// What came in the last minute, oldest first; of more than it has room for, the newest. Takes
/// memory when it is made, none later.
template <class Item>
class LastMinute {
 public:
  explicit LastMinute(std::size_t room) : entries_(room) {}

  /// At a time in s of a clock that only goes on.
  void add(double now, const Item& item) {
    while (size_ > 0 && isOld(0, now)) drop();
    if (size_ == entries_.size()) drop();
    entries_[place(size_++)] = {now, item};
  }

  /// Calls a function with each item that is not older than a minute.
  template <class Function>
  void visit(double now, const Function& function) const {
    for (std::size_t i = 0; i < size_; ++i) {
      if (!isOld(i, now)) function(entries_[place(i)].item);
    }
  }

 private:
  struct Entry {
    double time{0.0};
    Item item{};
  };

  bool isOld(std::size_t i, double now) const { return entries_[place(i)].time < now - 60.0; }
  std::size_t place(std::size_t i) const { return (first_ + i) % entries_.size(); }
  void drop() {
    first_ = place(1);
    --size_;
  }

  std::vector<Entry> entries_;
  std::size_t first_{0};
  std::size_t size_{0};
};

}  // namespace adaptive_localization
