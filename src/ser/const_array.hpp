// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace adaptive_localization {

/// Numbers that do not change any more, in memory of their own or in a part of somebody else's, as
/// a file's. Copies share them.
template <class T>
class ConstArray {
 public:
  ConstArray() = default;

  explicit ConstArray(std::vector<T> values) {
    auto own = std::make_shared<const std::vector<T>>(std::move(values));
    data_ = own->data();
    size_ = own->size();
    owner_ = std::move(own);
  }

  /// `size` numbers at `data`, which stay there as long as somebody has the owner.
  ConstArray(std::shared_ptr<const void> owner, const T* data, std::size_t size)
      : owner_(std::move(owner)), data_(data), size_(size) {}

  const T* data() const { return data_; }
  std::size_t size() const { return size_; }
  std::size_t bytes() const { return size_ * sizeof(T); }
  bool empty() const { return size_ == 0; }
  const T* begin() const { return data_; }
  const T* end() const { return data_ + size_; }
  const T& operator[](std::size_t i) const { return data_[i]; }

 private:
  std::shared_ptr<const void> owner_;
  const T* data_{nullptr};
  std::size_t size_{0};
};

}  // namespace adaptive_localization
