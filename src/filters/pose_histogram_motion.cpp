// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "pose_histogram.hpp"

namespace adaptive_localization {
namespace {

constexpr double kMostNoise = 1.0;  // m^2 or rad^2

double boundedNoise(double variance) {
  return std::isfinite(variance) ? std::clamp(variance, 0.0, kMostNoise) : kMostNoise;
}

/// A box of 2 reach - 1 equal weights with what is left of them beside it, of any variance: to be
/// used once where that is small, else three times, which is nearly a Gaussian.
struct Kernel {
  Kernel(double variance, double step) {
    const double cells = variance / (step * step);  // squared
    if (!(cells > 1e-9)) return;
    passes = cells < kNarrow ? 1 : 3;
    const double v = cells / passes;
    double squares = 0.0;
    for (reach = 1; reach * (reach - 1) / 3.0 <= v; ++reach) squares += reach * reach;
    --reach;
    squares -= reach * reach;
    const double inner = 2 * reach - 1;
    const double rest = (v * inner - 2.0 * squares) / (2.0 * (reach * reach - v));
    within = static_cast<float>(1.0 / (inner + 2.0 * rest));
    edge = static_cast<float>(rest) * within;
  }

  float at(int cell) const { return std::abs(cell) == reach ? edge : within; }
  int width() const { return passes * reach; }

  static constexpr double kNarrow = 2.0 / 3.0;
  int reach{0}, passes{0};
  float within{1.0F}, edge{0.0F};
};

}  // namespace

std::vector<float> PoseHistogram::copyOf(int layer) const {
  std::vector<float> copy;
  for (int row = window_.bottom; row <= window_.top; ++row) {
    const auto line = mass_.begin() + static_cast<long>(at(layer, row, 0));
    copy.insert(copy.end(), line + window_.left, line + window_.right + 1);
  }
  return copy;
}

/// What a layer holds in the window.
void PoseHistogram::erase(int layer) {
  for (int row = window_.bottom; row <= window_.top; ++row) {
    const auto line = mass_.begin() + static_cast<long>(at(layer, row, 0));
    std::fill(line + window_.left, line + window_.right + 1, 0.0F);
  }
}

void PoseHistogram::widen(int by) {
  window_ = {std::max(0, window_.left - by), std::min(width_ - 1, window_.right + by),
             std::max(0, window_.bottom - by), std::min(height_ - 1, window_.top + by)};
}

/// Share by share to the four cells around, in a layer with another offset.
void PoseHistogram::addBeside(const std::vector<float>& from, const Eigen::Vector2d& offset,
                              float share, int to) {
  const Eigen::Array2d apart = (offset - layerAt(to).offset).array() / cell_;
  const Eigen::Array2i base = apart.floor().cast<int>();
  const Eigen::Array2f rest = (apart - apart.floor()).cast<float>();
  std::size_t i = 0;
  for (int row = window_.bottom; row <= window_.top; ++row) {
    for (int column = window_.left; column <= window_.right; ++column) {
      const float mass = share * from[i++];
      if (mass == 0.0F) continue;
      for (int k = 0; k < 4; ++k) {
        const int x = column + base.x() + (k & 1), y = row + base.y() + (k >> 1);
        if (x < 0 || x >= width_ || y < 0 || y >= height_) continue;
        mass_[at(to, y, x)] +=
            mass * (k & 1 ? rest.x() : 1.0F - rest.x()) * (k & 2 ? rest.y() : 1.0F - rest.y());
      }
    }
  }
}

/// By whole cells; the window is that of before.
void PoseHistogram::shift(int layer, int columns, int rows) {
  const std::vector<float> before = copyOf(layer);
  erase(layer);
  std::size_t i = 0;
  for (int row = window_.bottom + rows; row <= window_.top + rows; ++row) {
    for (int x = window_.left + columns; x <= window_.right + columns; ++x, ++i) {
      if (x >= 0 && x < width_ && row >= 0 && row < height_) mass_[at(layer, row, x)] = before[i];
    }
  }
}

void PoseHistogram::blurAlong(int layer, bool along_x, double variance) {
  const Kernel kernel(variance, cell_);
  const int lines = along_x ? window_.top - window_.bottom : window_.right - window_.left;
  const int cells = along_x ? window_.right - window_.left : window_.top - window_.bottom;
  const Eigen::InnerStride<> step(along_x ? 1 : width_);
  Eigen::ArrayXf before(cells + 1);
  for (int line = 0; line <= lines; ++line) {
    const std::size_t begin =
        at(layer, window_.bottom + (along_x ? line : 0), window_.left + (along_x ? 0 : line));
    Eigen::Map<Eigen::ArrayXf, Eigen::Unaligned, Eigen::InnerStride<>> after(&mass_[begin],
                                                                             cells + 1, step);
    for (int pass = 0; pass < kernel.passes; ++pass) {
      before = after;
      for (int i = 0; i <= cells; ++i) {
        float sum = 0.0F;
        const int last = std::min(cells, i + kernel.reach);
        for (int k = std::max(0, i - kernel.reach); k <= last; ++k)
          sum += kernel.at(k - i) * before[k];
        after[i] = sum;
      }
    }
  }
}

void PoseHistogram::blurHeadings(double variance) {
  const Kernel kernel(variance, turn_);
  const int reach = std::min(kernel.reach, (layers() - 1) / 2);
  for (int pass = 0; pass < kernel.passes; ++pass) {
    const std::vector<Layer> layers_before = layers_;
    std::vector<std::vector<float>> before;
    for (int k = 0; k < layers(); ++k)
      before.push_back(layerAt(k).is_empty ? std::vector<float>() : copyOf(k));
    for (int k = 0; k < layers(); ++k) {
      erase(k);
      for (int turns = -reach; turns <= reach; ++turns) {
        const auto from = static_cast<std::size_t>((k + turns + layers()) % layers());
        if (before[from].empty()) continue;
        addBeside(before[from], layers_before[from].offset, kernel.at(turns), k);
        layerAt(k).is_empty = false;
      }
    }
    widen(1);
  }
}

void PoseHistogram::move(const Pose2& motion, const Eigen::Matrix3d& noise) {
  Window all{width_, -1, height_, -1};
  for (int k = 0; k < layers(); ++k) {
    Layer& moved = layerAt(k);
    moved.offset += Eigen::Rotation2Dd(headingOf(k)) * Eigen::Vector2d(motion.x, motion.y);
    const int columns = static_cast<int>(std::lround(moved.offset.x() / cell_));
    const int rows = static_cast<int>(std::lround(moved.offset.y() / cell_));
    moved.offset -= cell_ * Eigen::Vector2d(columns, rows);
    if (moved.is_empty) continue;
    if (columns != 0 || rows != 0) shift(k, columns, rows);
    all = {std::min(all.left, std::max(0, window_.left + columns)),
           std::max(all.right, std::min(width_ - 1, window_.right + columns)),
           std::min(all.bottom, std::max(0, window_.bottom + rows)),
           std::max(all.top, std::min(height_ - 1, window_.top + rows))};
  }
  window_ = all;
  if (window_.left > window_.right || window_.bottom > window_.top) return;  // all is lost
  const Eigen::Matrix2d along = noise.topLeftCorner<2, 2>();
  widen(Kernel(boundedNoise(along.trace()), cell_).width());
  for (int k = 0; k < layers(); ++k) {
    if (layerAt(k).is_empty) continue;
    const Eigen::Matrix2d R = Eigen::Rotation2Dd(headingOf(k)).toRotationMatrix();
    const Eigen::Matrix2d turned = R * along * R.transpose();
    blurAlong(k, true, boundedNoise(turned(0, 0)));
    blurAlong(k, false, boundedNoise(turned(1, 1)));
  }
  blurHeadings(boundedNoise(noise(2, 2)));
  turned_ += wrapAngle(motion.theta);
  const double turns = std::round(turned_ / turn_);
  turned_ -= turns * turn_;
  first_ = static_cast<int>(std::fmod(first_ + turns, layers()));
}

}  // namespace adaptive_localization
