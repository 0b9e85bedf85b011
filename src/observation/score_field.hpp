// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "adaptive_localization/core/particles.hpp"
#include "adaptive_localization/core/scan.hpp"
#include "adaptive_localization/map/distance_field.hpp"

namespace adaptive_localization {

/// A function of the distance to the nearest obstacle, tabulated over the map with 16 bits per
/// cell where that is near enough, and its sum over the hits of a scan for many poses at once.
///
/// Tiles of the table are made when particles are first within reach of them: on a large map a
/// robot that is tracked needs a few. Without a table each value is looked up by the cell's
/// distance: the same sums, in almost twice the time, and at once.
///
/// The sum is one of whole numbers, so it does not depend on its order: scalar code, AVX2 code and
/// any number of threads give the same bits.
class ScoreField {
 public:
  enum class Table { kKept, kNone };

  /// value(distance in metres) must be monotone; distances above max_distance, or above the reach
  /// of the distance field, count as max_distance, and so does everything outside the map.
  ScoreField(std::shared_ptr<const DistanceField> field, double max_distance,
             const std::function<double(double)>& value, Table table = Table::kKept);

  /// Sum of the values at the hits (end points in base, m) for each particle. At most
  /// kMaxHits hits. One thread at a time.
  void sum(const Eigen::ArrayXf& x, const Eigen::ArrayXf& y, const Particles& particles,
           Eigen::Ref<Eigen::ArrayXd> sums) const;

  /// For each hit, the share of particles that see it at a distance below that of the value.
  Eigen::ArrayXd shareAbove(double value, const Eigen::ArrayXf& x, const Eigen::ArrayXf& y,
                            const Particles& particles) const;

  static constexpr int kMaxHits = 32767;

  /// So many tiles there are still to be made.
  std::size_t tilesToMake() const { return to_make_; }

  /// Uses only portable instructions from now on; for tests that compare them.
  static void usePortableInstructions(bool portable);

 private:
  void makeTiles(const Eigen::ArrayXf& x, const Eigen::ArrayXf& y,
                 const Particles& particles) const;
  void sumUp(const Eigen::ArrayXf& x, const Eigen::ArrayXf& y, const Particles& particles,
             Eigen::Ref<Eigen::ArrayXd> sums) const;

  std::shared_ptr<const DistanceField> field_;
  double at_max_;
  double step_;                                        // of the value, from at_max_ on
  std::vector<std::uint16_t> by_nearness_;             // steps, by those of the distance field
  mutable std::optional<SparseGrid> table_;            // with a border of one cell
  mutable std::vector<std::uint16_t> is_made_around_;  // each tile: so many rows of tiles
  mutable std::size_t to_make_{0};                     // tiles
};

}  // namespace adaptive_localization
