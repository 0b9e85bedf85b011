// SPDX-License-Identifier: BSD-3-Clause
#include "grid_cache.hpp"

#include <xxhash.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <utility>

#include "range_blocks.hpp"

namespace adaptive_localization {
namespace {

namespace fs = std::filesystem;

constexpr const char* kExtension = ".ser_grid";
constexpr std::size_t kFilesKept = 8;
constexpr double kEdition = 5.0;  // of what is in the files: to be raised when ranges change

std::uint64_t hashOf(const std::vector<double>& values, std::uint64_t seed) {
  return XXH64(values.data(), values.size() * sizeof(double), seed);
}

/// Removes the files used longest ago, and what crashed programs left of theirs.
void tidy(const std::string& folder) {
  std::vector<std::pair<fs::file_time_type, fs::path>> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const fs::path& file = entry.path();
    if (file.filename().string().find(kExtension) == std::string::npos) continue;
    if (!ArrayFile::isPart(file)) {
      files.emplace_back(entry.last_write_time(error), file);
    } else if (ArrayFile::isAbandoned(file)) {
      fs::remove(file, error);
    }
  }
  std::sort(files.rbegin(), files.rend());
  for (std::size_t i = kFilesKept; i < files.size(); ++i) fs::remove(files[i].second, error);
}

/// Whether these are the free cells of every spacing-th column and row of the map.
bool areCellsOf(const OccupancyGrid& map, int spacing, const ConstArray<std::uint32_t>& cells) {
  std::size_t known = 0;
  for (int y = 0; y < map.lattice().height(); y += spacing) {
    for (int x = 0; x < map.lattice().width(); x += spacing) {
      if (!map.isFree({x, y})) continue;
      if (known == cells.size() || cells[known] != map.lattice().index({x, y})) return false;
      ++known;
    }
  }
  return known > 0 && known == cells.size();
}

[[noreturn]] void reject(const std::string& file) {
  throw std::runtime_error(file + ": does not hold what it should");
}

}  // namespace

GridCache::GridCache(std::string folder, const OccupancyGrid& map)
    : folder_(std::move(folder)), map_(map) {}

std::uint64_t GridCache::keyOf(double max_range, int spacing) const {
  const Lattice& lattice = map_.lattice();
  const CellBox& known = map_.known();
  const std::uint64_t cells = XXH64(map_.knownCells().data(), map_.knownCells().size(), 0);
  return hashOf(
      {kEdition, double(lattice.width()), double(lattice.height()), double(known.x),
       double(known.y), double(known.width), double(known.height), lattice.resolution(),
       lattice.origin().x, lattice.origin().y, lattice.origin().theta, max_range, double(spacing)},
      cells);
}

std::string GridCache::fileOf(std::uint64_t key) const {
  char digits[17];
  std::snprintf(digits, sizeof(digits), "%016llx", static_cast<unsigned long long>(key));
  return folder_ + "/ranges_" + digits + kExtension;
}

/// Says that the file is in use, too.
bool GridCache::isThere(const std::string& file) const {
  std::error_code error;
  if (folder_.empty() || !fs::exists(file, error)) return false;
  fs::last_write_time(file, fs::file_time_type::clock::now(), error);
  return true;
}

void GridCache::write(const std::string& file, std::uint64_t key,
                      const std::vector<ArrayFile::Bytes>& arrays) {
  had_all_ = false;
  if (folder_.empty()) return;
  std::error_code error;
  fs::create_directories(folder_, error);
  try {
    ArrayFile::write(file, key, arrays);
    tidy(folder_);
  } catch (const std::runtime_error& exception) {
    warnings_.push_back("cache_dir " + folder_ + ": cannot be written to (" + exception.what() +
                        "); energy grids are made anew at each start");
    folder_.clear();
  }
}

std::shared_ptr<const RangeTable> GridCache::readRanges(const std::string& file, std::uint64_t key,
                                                        double max_range, int spacing) const {
  constexpr std::size_t kBytesPerCell = sizeof(std::uint32_t) + kRangeStride;
  const ArrayFile arrays(file, key, sizeof(std::int32_t) + map_.countFree() * kBytesPerCell);
  const auto made_with = arrays.array<std::int32_t>(0);
  std::shared_ptr<RangeTable> table(new RangeTable(map_.lattice()));
  table->max_range_ = max_range;
  table->spacing_ = made_with[0];
  table->cells_ = arrays.array<std::uint32_t>(1);
  table->ranges_ = arrays.array<std::uint8_t>(2);
  const bool is_right = made_with.size() == 1 && made_with[0] >= 1 && made_with[0] <= spacing &&
                        areCellsOf(map_, made_with[0], table->cells_) &&
                        table->ranges_.size() == table->size() * kRangeStride;
  if (!is_right) reject(file);
  table->blocks_ = std::make_shared<const RangeBlocks>(table->lattice_, table->spacing_,
                                                       table->cells_, table->ranges_);
  return table;
}

std::shared_ptr<const RangeTable> GridCache::ranges(double max_range, int spacing,
                                                    const StopToken& stop) {
  const std::uint64_t key = folder_.empty() ? 0 : keyOf(max_range, spacing);
  const std::string file = fileOf(key);
  if (isThere(file)) {
    try {
      return readRanges(file, key, max_range, spacing);
    } catch (const std::runtime_error& error) {
      warnings_.push_back(std::string(error.what()) + "; made anew");
    }
  }
  auto table = std::make_shared<const RangeTable>(map_, max_range, spacing, stop);
  const ConstArray<std::int32_t> made_with(std::vector<std::int32_t>{table->spacing()});
  write(file, key,
        {ArrayFile::bytesOf(made_with), ArrayFile::bytesOf(table->cells_),
         ArrayFile::bytesOf(table->ranges_)});
  return table;
}

}  // namespace adaptive_localization
