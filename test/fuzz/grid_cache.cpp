// SPDX-License-Identifier: BSD-3-Clause
// A file of the cache with any bytes, or with any arrays and the right checksum: it is made again,
// and says why.
#include "ser/grid_cache.hpp"

#include <fuzzer/FuzzedDataProvider.h>

#include <cstring>

#include "fuzz/input_file.hpp"
#include "ser/array_file.hpp"

namespace al = adaptive_localization;

namespace {

constexpr double kRange = 2.0;  // m
constexpr std::size_t kArrays = 3, kMostBytes = 100000, kKeyAt = 16;

al::OccupancyGrid smallMap() {
  const al::Lattice lattice(8, 6, 0.25, {});
  std::vector<std::int8_t> cells(lattice.size(), al::OccupancyGrid::kFree);
  for (std::size_t i = 0; i < 8; ++i) cells[i] = al::OccupancyGrid::kOccupied;
  return {lattice, cells};
}

std::string onlyFileIn(const std::string& folder) {
  return std::filesystem::directory_iterator(folder)->path().string();
}

std::uint64_t keyOf(const std::string& file) {
  std::uint64_t key = 0;
  std::ifstream stream(file, std::ios::binary);
  stream.seekg(kKeyAt);
  stream.read(reinterpret_cast<char*>(&key), sizeof(key));
  return key;
}

std::vector<std::string> arraysOf(const std::string& file) {
  const al::ArrayFile right(file, keyOf(file), kMostBytes);
  std::vector<std::string> arrays;
  for (std::size_t i = 0; i < kArrays; ++i) {
    const auto bytes = right.array<char>(i);
    arrays.emplace_back(bytes.begin(), bytes.end());
  }
  return arrays;
}

/// The right arrays, or longer or shorter ones, with some bytes that differ.
std::vector<std::string> likeThese(std::vector<std::string> arrays, FuzzedDataProvider& given) {
  for (std::string& array : arrays) {
    if (given.ConsumeBool()) array.resize(given.ConsumeIntegralInRange<std::size_t>(0, 5000));
    const std::string differences = given.ConsumeRandomLengthString(array.size());
    for (std::size_t i = 0; i < differences.size(); ++i) array[i] ^= differences[i];
  }
  return arrays;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const al::OccupancyGrid map = smallMap();
  static const std::string folder = al::inputFolder().file("cache");
  static const auto right = al::GridCache(folder, map).ranges(kRange, 1);
  static const std::string file = onlyFileIn(folder);
  static const std::uint64_t key = keyOf(file);
  static const std::vector<std::string> arrays = arraysOf(file);
  FuzzedDataProvider given(data, size);
  if (given.ConsumeBool()) {
    std::ofstream(file, std::ios::binary) << given.ConsumeRemainingBytesAsString();
  } else {
    const std::vector<std::string> others = likeThese(arrays, given);
    std::vector<al::ArrayFile::Bytes> bytes;
    for (const std::string& array : others) bytes.push_back({array.data(), array.size()});
    al::ArrayFile::write(file, key, bytes);
  }
  return al::tryToRead([] {
    if (al::GridCache(folder, map).ranges(kRange, 1)->size() != right->size()) std::abort();
  });
}
