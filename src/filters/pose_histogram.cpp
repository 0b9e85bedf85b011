// SPDX-License-Identifier: BSD-3-Clause
#include "pose_histogram.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "adaptive_localization/particle/resampling.hpp"
#include "particle/gaussian_cloud.hpp"

namespace adaptive_localization {
namespace {

constexpr double kNarrowest = 0.1;  // cells: the least deviation of a Gaussian
/// In lattice coordinates, m.
Eigen::AlignedBox2d knownPart(const OccupancyGrid& map) {
  constexpr double kMargin = 0.5;  // m
  const double resolution = map.lattice().resolution();
  const CellBox known = map.known().size() > 0 ? map.known() : CellBox{0, 0, 1, 1};
  const Eigen::Vector2d first(known.x, known.y), size(known.width, known.height);
  const Eigen::Vector2d margin = Eigen::Vector2d::Constant(kMargin);
  return {resolution * first - margin, resolution * (first + size) + margin};
}

Eigen::Array2i cellsOf(const Eigen::AlignedBox2d& box, double cell) {
  return (box.sizes().array() / cell - 1e-9).ceil().cast<int>().max(1);
}

}  // namespace

PoseHistogram::PoseHistogram(std::shared_ptr<const OccupancyGrid> map, double cell, int headings)
    : map_(std::move(map)),
      corner_(knownPart(*map_).min()),
      cell_(cell),
      turn_(2.0 * kPi / headings),
      width_(cellsOf(knownPart(*map_), cell).x()),
      height_(cellsOf(knownPart(*map_), cell).y()),
      layers_(static_cast<std::size_t>(headings)),
      mass_(cellsInLayer() * layers_.size()) {
  spread();
}

double PoseHistogram::countCells(const OccupancyGrid& map, double cell, int headings) {
  return cellsOf(knownPart(map), cell).cast<double>().prod() * headings;
}

double PoseHistogram::headingOf(int layer) const {
  return (layer + first_) * turn_ + turned_;
}

Eigen::Vector2d PoseHistogram::centre(int layer, int row, int column) const {
  return corner_ + cell_ * Eigen::Vector2d(column + 0.5, row + 0.5) + layerAt(layer).offset;
}

bool PoseHistogram::isFree(int layer, int row, int column) const {
  const Eigen::Vector2d point = centre(layer, row, column);
  const Pose2 T_map_point = map_->lattice().origin() * Pose2{point.x(), point.y(), 0.0};
  return map_->isFree(map_->lattice().cellAt({T_map_point.x, T_map_point.y}));
}

/// Of everything; the next cells' centres lie so that this pose, in lattice coordinates, is one.
void PoseHistogram::clear(const Pose2& T_lattice_centre) {
  std::fill(mass_.begin(), mass_.end(), 0.0F);
  const auto rest = [this](double x) { return x - (std::floor(x / cell_) + 0.5) * cell_; };
  first_ = 0;
  turned_ = T_lattice_centre.theta - turn_ * std::round(T_lattice_centre.theta / turn_);
  for (Layer& layer : layers_) {
    layer.offset = {rest(T_lattice_centre.x - corner_.x()), rest(T_lattice_centre.y - corner_.y())};
    layer.is_empty = true;
  }
  window_ = {0, width_ - 1, 0, height_ - 1};
}

void PoseHistogram::spread() {
  clear({corner_.x() + 0.5 * cell_, corner_.y() + 0.5 * cell_, 0.0});
  std::vector<float> free(cellsInLayer());
  for (int row = 0; row < height_; ++row) {
    for (int column = 0; column < width_; ++column) {
      free[at(0, row, column)] = isFree(0, row, column) ? 1.0F : 0.0F;
    }
  }
  if (*std::max_element(free.begin(), free.end()) == 0.0F)
    std::fill(free.begin(), free.end(), 1.0F);
  for (int k = 0; k < layers(); ++k) {
    std::copy(free.begin(), free.end(), mass_.begin() + static_cast<long>(at(k, 0, 0)));
    layerAt(k).is_empty = false;
  }
}

void PoseHistogram::add(const Pose2& T_lattice_base, double mass) {
  const int turns = static_cast<int>(std::lround((T_lattice_base.theta - turned_) / turn_));
  const int k = ((turns - first_) % layers() + layers()) % layers();
  const Eigen::Vector2d place =
      (Eigen::Vector2d(T_lattice_base.x, T_lattice_base.y) - corner_ - layerAt(k).offset) / cell_;
  if (!(place.minCoeff() >= 0.0) || place.x() >= width_ || place.y() >= height_) return;
  mass_[at(k, static_cast<int>(place.y()), static_cast<int>(place.x()))] +=
      static_cast<float>(mass);
  layerAt(k).is_empty = false;
}

void PoseHistogram::set(const Gaussian2& gaussian) {
  if (!isFinite(gaussian.mean)) return spread();
  const Pose2 mean = map_->lattice().toLattice(gaussian.mean);
  clear(mean);
  Eigen::Matrix3d turned = Eigen::Matrix3d::Identity();
  turned.topLeftCorner<2, 2>() =
      Eigen::Rotation2Dd(-map_->lattice().origin().theta).toRotationMatrix();
  const Eigen::Matrix3d root = turned * squareRoot(gaussian.covariance);
  const Eigen::Vector3d step(cell_, cell_, turn_);
  const Eigen::Matrix3d covariance =
      root * root.transpose() + Eigen::Matrix3d((kNarrowest * step).cwiseAbs2().asDiagonal());
  const Eigen::Matrix3d information = covariance.inverse();
  constexpr double kWidest = 4.0;  // deviations
  const Eigen::Array3d limits(width_, height_, 0.5 * (layers() - 1));
  const Eigen::Array3i reach = (kWidest * covariance.diagonal().array().sqrt() / step.array())
                                   .ceil()
                                   .min(limits)
                                   .cast<int>();
  for (int turns = -reach[2]; turns <= reach[2]; ++turns) {
    for (int row = -reach[1]; row <= reach[1]; ++row) {
      for (int column = -reach[0]; column <= reach[0]; ++column) {
        const Eigen::Vector3d off = step.cwiseProduct(Eigen::Vector3d(column, row, turns));
        add({mean.x + off[0], mean.y + off[1], mean.theta + off[2]},
            std::exp(-0.5 * off.dot(information * off)));
      }
    }
  }
  if (cellsAbove(0.0).empty()) spread();
}

void PoseHistogram::set(const Particles& particles) {
  const Eigen::ArrayXd weights = normalisedWeights(particles.log_weight);
  Eigen::Index heaviest = 0;
  weights.maxCoeff(&heaviest);
  if (!isFinite(particles.pose(heaviest))) return spread();
  clear(map_->lattice().toLattice(particles.pose(heaviest)));
  for (Eigen::Index i = 0; i < particles.size(); ++i) {
    add(map_->lattice().toLattice(particles.pose(i)), weights[i]);
  }
  if (cellsAbove(0.0).empty()) spread();
}

void PoseHistogram::mix(double share) {
  std::vector<std::size_t> free;
  for (int layer = 0; layer < layers(); ++layer) {
    for (int row = 0; row < height_; ++row) {
      for (int column = 0; column < width_; ++column) {
        if (isFree(layer, row, column)) free.push_back(at(layer, row, column));
      }
    }
  }
  double sum = 0.0;
  for (const float mass : mass_) sum += mass;
  if (free.empty() || !(sum > 0.0)) return;
  for (float& mass : mass_) mass *= static_cast<float>((1.0 - share) / sum);
  for (const std::size_t i : free)
    mass_[i] += static_cast<float>(share / static_cast<double>(free.size()));
  for (Layer& layer : layers_) layer.is_empty = false;
  window_ = {0, width_ - 1, 0, height_ - 1};
}

std::vector<std::uint32_t> PoseHistogram::cellsAbove(double share) const {
  const float most = *std::max_element(mass_.begin(), mass_.end());
  const float least = static_cast<float>(share) * most;
  std::vector<std::uint32_t> cells;
  for (int k = 0; k < layers(); ++k) {
    if (layerAt(k).is_empty) continue;
    for (int row = window_.bottom; row <= window_.top; ++row) {
      for (int x = window_.left; x <= window_.right; ++x) {
        const std::size_t i = at(k, row, x);
        if (mass_[i] > 0.0F && mass_[i] >= least) cells.push_back(static_cast<std::uint32_t>(i));
      }
    }
  }
  return cells;
}

Particles PoseHistogram::poses(const std::vector<std::uint32_t>& cells) const {
  Particles poses(static_cast<Eigen::Index>(cells.size()));
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto layer = static_cast<int>(cells[i] / cellsInLayer());
    const auto place = static_cast<int>(cells[i] % cellsInLayer());
    const Eigen::Vector2d point = centre(layer, place / width_, place % width_);
    const auto k = static_cast<Eigen::Index>(i);
    poses.setPose(k, map_->lattice().origin() * Pose2{point.x(), point.y(), headingOf(layer)});
    poses.theta[k] = wrapAngle(poses.theta[k]);
    poses.log_weight[k] = std::log(mass_[cells[i]]);
  }
  return poses;
}

void PoseHistogram::assign(const std::vector<std::uint32_t>& cells, const Eigen::ArrayXd& mass) {
  for (int k = 0; k < layers(); ++k) {
    if (layerAt(k).is_empty) continue;
    std::fill_n(mass_.begin() + static_cast<long>(at(k, 0, 0)), cellsInLayer(), 0.0F);
    layerAt(k).is_empty = true;
  }
  window_ = {width_, -1, height_, -1};
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto held = static_cast<float>(mass[static_cast<Eigen::Index>(i)]);
    if (!(held > 0.0F)) continue;
    mass_[cells[i]] = held;
    const auto place = static_cast<int>(cells[i] % cellsInLayer());
    const int x = place % width_, y = place / width_;
    layers_[cells[i] / cellsInLayer()].is_empty = false;
    window_ = {std::min(window_.left, x), std::max(window_.right, x), std::min(window_.bottom, y),
               std::max(window_.top, y)};
  }
}

}  // namespace adaptive_localization
