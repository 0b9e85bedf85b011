// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "beam_paths.hpp"
#include "digital_line.hpp"
#include "sweep_map.hpp"

namespace adaptive_localization {

/// All digital lines of a bundle, swept back from the last line of the map to the first.
class BundleSweep {
 public:
  BundleSweep(const SweepMap& map, const SweepDirection& direction, int bundle);

  /// Goes back to line number t, counted along the direction, from t + 1.
  void stepTo(int t);

  /// Ranges from where obstacles are entered to half a step on; of cells where no beam comes along
  /// nothing is written.
  void write(int t, float scale, std::uint8_t* ranges) const;

 private:
  const SweepMap& map_;
  SweepDirection direction_;
  DigitalLine line_;
  BeamPaths paths_;
  std::vector<float> seen_, result_;  // one border cell at both ends, beyond which nothing is seen
};

/// Ranges from the cells of a SweepMap that are asked for in one direction: scale times the number
/// of cells travelled until half a step into the first obstacle (see RayCaster), rounded, at most
/// 255. O(cells) time, some lines of memory.
class Sweep {
 public:
  Sweep(const SweepMap& map, const SweepDirection& direction, float scale);

  /// Goes on over the lines [first, end): the last ones of the map for sense 1, then those before;
  /// or the other way round. Ranges of the k-th line among them that is asked for are written from
  /// k * length on, and those of other cells than are asked for mean nothing.
  void advance(int first, int end, std::uint8_t* ranges);

 private:
  const SweepMap& map_;
  SweepDirection direction_;
  float scale_;
  std::vector<BundleSweep> bundles_;
};

}  // namespace adaptive_localization
