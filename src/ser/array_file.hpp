// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "ser/const_array.hpp"

namespace adaptive_localization {

/// Arrays of numbers in a file, under a key that says what they were computed from. In the order of
/// bytes of the machine that wrote it, with a checksum (XXH64) of all.
class ArrayFile {
 public:
  /// Reads a file, not mapping it: somebody else may cut it short at any time. Throws
  /// std::runtime_error naming the file and what is wrong: damaged, cut short, longer than
  /// `most_bytes` of arrays, another program's, another version's, with another key.
  ArrayFile(const std::string& file, std::uint64_t key, std::size_t most_bytes);

  /// Array i. Throws std::runtime_error if there is none or it is not one of Ts.
  template <class T>
  ConstArray<T> array(std::size_t i) const {
    const Bytes& bytes = at(i, sizeof(T));
    return {memory_, reinterpret_cast<const T*>(bytes.data), bytes.size / sizeof(T)};
  }

  /// Bytes of an array, to be written.
  struct Bytes {
    const char* data;
    std::size_t size;
  };
  template <class T>
  static Bytes bytesOf(const ConstArray<T>& array) {
    return {reinterpret_cast<const char*>(array.data()), array.bytes()};
  }

  /// Writes beside the file and renames, so that there is a whole file or none, and any number of
  /// programs and threads may write it at once. Throws std::runtime_error naming the file and what
  /// is wrong.
  static void write(const std::string& file, std::uint64_t key, const std::vector<Bytes>& arrays);

  /// Whether a file is one that write() has begun to write, whoever did.
  static bool isPart(const std::string& file);

  /// Whether nobody writes such a file any more: its process is gone, or it was begun an hour ago.
  static bool isAbandoned(const std::string& part);

 private:
  const Bytes& at(std::size_t i, std::size_t size_of_item) const;
  void findArrays(std::size_t size);

  std::string file_;
  std::shared_ptr<const char[]> memory_;
  std::vector<Bytes> arrays_;
};

}  // namespace adaptive_localization
