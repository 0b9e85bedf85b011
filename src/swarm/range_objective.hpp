// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "adaptive_localization/core/options.hpp"
#include "adaptive_localization/core/scan.hpp"
#include "adaptive_localization/map/distance_field.hpp"
#include "adaptive_localization/map/occupancy_grid.hpp"
#include "ser/range_table.hpp"
#include "swarm/objective.hpp"

namespace adaptive_localization {

struct RangeObjectiveOptions {
  int swarm_beams{60};
  std::string swarm_error{"truncated"};

  template <class Visitor>
  void visit(Visitor&& option) {
    option("swarm_beams", swarm_beams, Range{1, 10000}, "",
           "Beams of a scan that the swarm uses, evenly spread.");
    option("swarm_error", swarm_error, Choices{"truncated", "relative"},
           "Cost that the swarm minimizes: truncated, the mean range error per beam in m; "
           "relative, the mean ratio of error to range (Araujo Neto 2019).");
  }
};

/// The largest cost of a pose.
double worstOf(const RangeObjectiveOptions& options);

/// How badly a scan fits poses (x, y, theta) of base in map, beams j of B:
///
///     truncated   F = (1 / B) sum_j min(|z_j* - z_j|, 0.25 m)
///     relative    F = (1 / B) sum_j min(1, |z_j* - z_j| / max(z_j, 0.1 m))
///
/// The latter is the mean relative deviation of the leader-based bat algorithm's source. A
/// no-return counts as the largest range. Poses whose sensor is not on free ground have the largest
/// cost.
class RangeObjective : public Objective {
 public:
  /// Ranges, read and expected, are cut off at max_range.
  RangeObjective(const RangeObjectiveOptions& options, const Scan& scan, double max_range);

  /// Whether any beam tells anything; all costs are 0 otherwise.
  bool isEmpty() const { return beams_.empty(); }

  /// The largest cost.
  double worst() const { return worst_; }

 protected:
  struct Beam {
    double bearing;  // rad, in base
    double range;    // m
  };
  double error(const Beam& beam, double expected) const;

  bool is_relative_;
  double worst_;
  double max_range_;
  Eigen::Vector2d position_;  // of the sensor, in base
  std::vector<Beam> beams_;
};

/// The expected range of a ray in the map frame, m; max_range if it meets nothing before.
using RayCast = std::function<double(const Pose2& T_map_ray, double max_range)>;

/// Over a map's cells, with its distance field in less time.
RayCast castOverCells(std::shared_ptr<const OccupancyGrid> map,
                      std::shared_ptr<const DistanceField> field = nullptr);

/// Expected ranges by ray casting: exact, and slow.
class CastObjective : public RangeObjective {
 public:
  CastObjective(const RangeObjectiveOptions& options, const Scan& scan, double max_range,
                std::shared_ptr<const OccupancyGrid> map, RayCast cast);

  void evaluate(const Eigen::ArrayXXd& positions, Eigen::Ref<Eigen::ArrayXd> costs) const override;

 private:
  double costAt(const Pose2& T_map_base) const;

  std::shared_ptr<const OccupancyGrid> map_;
  RayCast cast_;
};

/// Finds the ranges of the cell around a point.
class RangeRows {
 public:
  explicit RangeRows(std::shared_ptr<const RangeTable> table);

  /// Null where the nearest cell of the table is not free.
  const std::uint8_t* at(const Eigen::Vector2d& point_map) const;

  const RangeTable& table() const { return *table_; }

 private:
  std::shared_ptr<const RangeTable> table_;
  int width_;
  std::vector<std::uint32_t> rows_;  // of each spaced cell of the map
};

/// Expected ranges of the nearest cell and direction of a table: a hundred times as fast.
class TableObjective : public RangeObjective {
 public:
  TableObjective(const RangeObjectiveOptions& options, const Scan& scan,
                 std::shared_ptr<const RangeRows> rows);

  void evaluate(const Eigen::ArrayXXd& positions, Eigen::Ref<Eigen::ArrayXd> costs) const override;

 private:
  double costAt(const Pose2& T_map_base) const;

  std::shared_ptr<const RangeRows> rows_;
  std::vector<double> steps_;  // bearing of each beam in direction steps, in [0, 180)
  std::vector<float> errors_;  // [beam * 256 + expected range in steps]
};

}  // namespace adaptive_localization
