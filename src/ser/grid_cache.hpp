// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "array_file.hpp"
#include "ser/energy_grid.hpp"

namespace adaptive_localization {

/// The ranges of a map's energy grids, read from a folder where they are, else made and put there:
/// one file for each table, named after a hash of all that it depends on.
///
/// The folder holds the eight files used last. A file that is not right is made again.
class GridCache {
 public:
  /// The map must stay. An empty folder: keeps nothing.
  GridCache(std::string folder, const OccupancyGrid& map);

  /// Throws std::invalid_argument if the map has no free cell, and Stopped.
  std::shared_ptr<const RangeTable> ranges(double max_range, int spacing,
                                           const StopToken& stop = {});

  /// Whether all that was asked for so far was in the folder.
  bool hadAll() const { return had_all_; }

  /// What is wrong with the folder and its files.
  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  std::shared_ptr<const RangeTable> readRanges(const std::string& file, std::uint64_t key,
                                               double max_range, int spacing) const;
  std::uint64_t keyOf(double max_range, int spacing) const;
  std::string fileOf(std::uint64_t key) const;
  bool isThere(const std::string& file) const;
  void write(const std::string& file, std::uint64_t key,
             const std::vector<ArrayFile::Bytes>& arrays);

  std::string folder_;
  const OccupancyGrid& map_;
  bool had_all_{true};
  std::vector<std::string> warnings_;
};

}  // namespace adaptive_localization
