// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "adaptive_localization/core/belief.hpp"
#include "adaptive_localization/core/particles.hpp"
#include "adaptive_localization/map/occupancy_grid.hpp"

namespace adaptive_localization {

/// A belief over poses of base in map, as a histogram: cells of so many metres along the map's
/// lattice, over what of it is known and half a metre around, and layers of one heading each.
///
/// A motion moves it exactly: all cells of a layer have the same heading, so the layer's grid moves
/// as a whole and keeps what is less than a cell as its offset; the headings of all layers turn
/// together. Nothing is spread by rounding, whatever the number of updates.
class PoseHistogram {
 public:
  /// Heading layers are 2 pi / headings apart.
  PoseHistogram(std::shared_ptr<const OccupancyGrid> map, double cell, int headings);

  /// Cells of one for such a map, in all layers.
  static double countCells(const OccupancyGrid& map, double cell, int headings);

  double cell() const { return cell_; }
  double turn() const { return turn_; }  // between layers, rad

  /// Uniform over the map's free cells.
  void spread();
  /// A Gaussian; its mean is a cell's centre. Off the map: as spread().
  void set(const Gaussian2& gaussian);
  /// Weighted poses; the heaviest is a cell's centre. All off the map: as spread().
  void set(const Particles& particles);

  /// Moves all by the same motion, T_previous_current, and blurs by its noise: a covariance over
  /// (x, y, theta) in the frame of the previous pose, of which the variances along the map's axes
  /// are taken. What leaves the map is lost; noise beyond 1 m^2 or 1 rad^2 counts as that.
  void move(const Pose2& motion, const Eigen::Matrix3d& noise);

  /// Adds a share of the whole, uniform over the free cells.
  void mix(double share);

  /// Cells that hold at least this share of the fullest one, and something.
  std::vector<std::uint32_t> cellsAbove(double share) const;
  /// Their poses, with the logarithms of what they hold.
  Particles poses(const std::vector<std::uint32_t>& cells) const;
  /// They hold this from now on, all others nothing.
  void assign(const std::vector<std::uint32_t>& cells, const Eigen::ArrayXd& mass);

 private:
  /// Columns and rows outside of which no layer holds anything.
  struct Window {
    int left, right, bottom, top;  // first and last
  };
  struct Layer {
    Eigen::Vector2d offset{0.0, 0.0};  // of its cells, m, at most half a cell
    bool is_empty{true};
  };

  int layers() const { return static_cast<int>(layers_.size()); }
  Layer& layerAt(int k) { return layers_[static_cast<std::size_t>(k)]; }
  const Layer& layerAt(int k) const { return layers_[static_cast<std::size_t>(k)]; }
  std::size_t cellsInLayer() const {
    return static_cast<std::size_t>(std::ptrdiff_t{width_} * height_);
  }
  double headingOf(int layer) const;  // in lattice coordinates
  std::size_t at(int layer, int row, int column) const {
    return static_cast<std::size_t>((std::ptrdiff_t{layer} * height_ + row) * width_ + column);
  }
  Eigen::Vector2d centre(int layer, int row, int column) const;
  bool isFree(int layer, int row, int column) const;
  void clear(const Pose2& T_map_centre);
  void widen(int by);
  void add(const Pose2& T_lattice_base, double mass);
  void erase(int layer);
  void shift(int layer, int columns, int rows);
  void blurAlong(int layer, bool along_x, double variance);
  void blurHeadings(double variance);
  std::vector<float> copyOf(int layer) const;
  void addBeside(const std::vector<float>& from, const Eigen::Vector2d& offset, float share,
                 int to);

  std::shared_ptr<const OccupancyGrid> map_;
  Eigen::Vector2d corner_;  // of all cells, in lattice coordinates
  double cell_, turn_;
  int width_, height_;
  double turned_{0.0};  // of all layers, rad, at most half a turn_
  int first_{0};        // heading of layer 0, in turns
  std::vector<Layer> layers_;
  std::vector<float> mass_;  // by layer, row and column
  Window window_{0, 0, 0, 0};
};

}  // namespace adaptive_localization
