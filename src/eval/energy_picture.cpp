// SPDX-License-Identifier: BSD-3-Clause
#include "eval/energy_picture.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "canvas.hpp"

namespace adaptive_localization {
namespace {

constexpr double kSurroundings = 0.5;  // m

/// Sum and number of values for each cell of a grid, which stands for the map's cells around it.
class CellValues {
 public:
  explicit CellValues(const EnergyGrid& grid)
      : lattice_(grid.ranges().lattice()),
        spacing_(grid.ranges().spacing()),
        columns_(lattice_.width() / spacing_ + 1),
        values_(static_cast<std::size_t>(columns_ * (lattice_.height() / spacing_ + 1))) {}

  void add(const Pose2& pose, double value) {
    const Cell cell = lattice_.cellAt({pose.x, pose.y});
    if (!lattice_.contains(cell)) return;
    values_[block(cell)].sum += value;
    ++values_[block(cell)].count;
  }

  /// Replaces sums by what is to be shown.
  template <class Function>
  void show(const Function& function) {
    for (auto& value : values_) {
      if (value.count == 0) continue;
      value.sum = function(value.sum, value.count);
      low_ = std::min(low_, value.sum);
      high_ = std::max(high_, value.sum);
    }
  }
  std::optional<double> at(const Cell& cell) const {
    const Value& value = values_[block(cell)];
    return value.count > 0 ? std::optional<double>(value.sum) : std::nullopt;
  }
  double low() const { return low_; }
  double high() const { return high_; }

 private:
  struct Value {
    double sum{0.0};
    int count{0};
  };
  std::size_t block(const Cell& cell) const {
    return static_cast<std::size_t>(cell.y / spacing_ * columns_ + cell.x / spacing_);
  }

  Lattice lattice_;
  int spacing_, columns_;
  std::vector<Value> values_;
  double low_{1.0}, high_{0.0};
};

/// The colours of values from low to high.
class Scale {
 public:
  Scale(double low, double high) : low_(low), high_(high) {
    cv::Mat ramp(1, kSteps, CV_8UC1);
    for (int i = 0; i < kSteps; ++i) ramp.at<unsigned char>(i) = static_cast<unsigned char>(i);
    cv::applyColorMap(ramp, colours_, cv::COLORMAP_VIRIDIS);
  }
  cv::Vec3b operator()(double value) const {
    const double share = high_ > low_ ? (value - low_) / (high_ - low_) : 0.5;
    return colours_.at<cv::Vec3b>(static_cast<int>(std::clamp(share, 0.0, 1.0) * (kSteps - 1)));
  }
  std::vector<LegendRow> legend() const {
    std::vector<LegendRow> rows;
    for (const double value : {high_, 0.5 * (low_ + high_), low_}) {
      rows.push_back({cv::format("%.2f", value), cv::Scalar((*this)(value))});
    }
    return rows;
  }

 private:
  static constexpr int kSteps = 256;
  double low_, high_;
  cv::Mat colours_;
};

/// All that the picture is to show.
std::vector<Pose2> cellsOf(const EnergyGrid& grid) {
  std::vector<Pose2> poses;
  for (std::size_t i = 0; i < grid.ranges().size(); ++i) {
    const Eigen::Vector2d centre = grid.ranges().centre(i);
    poses.push_back({centre.x(), centre.y(), 0.0});
  }
  return poses;
}

void draw(Canvas& canvas, const OccupancyGrid& map, const CellValues& values, const Scale& scale) {
  canvas.drawMap(map);
  canvas.drawCells(map.lattice(), [&](const Cell& cell) -> std::optional<cv::Vec3b> {
    const auto value = map.isFree(cell) ? values.at(cell) : std::nullopt;
    return value ? std::optional<cv::Vec3b>(scale(*value)) : std::nullopt;
  });
}

}  // namespace

void saveEnergies(const OccupancyGrid& map, const EnergyGrid& grid, const std::string& file) {
  CellValues values(grid);
  for (std::size_t i = 0; i < grid.size(); ++i) values.add(grid.pose(i), grid.energy(i));
  values.show([](double sum, int count) { return sum / count; });
  Canvas canvas(map, cellsOf(grid), kSurroundings);
  const Scale scale(values.low(), values.high());
  draw(canvas, map, values, scale);
  canvas.drawScaleBar();
  canvas.drawLegend(scale.legend(), {grid.orientations() == 1
                                         ? "energy, the same in all headings"
                                         : "mean energy over " +
                                               std::to_string(grid.orientations()) + " headings"});
  saveImage(canvas.image(), "picture", file);
}

void saveRegion(const OccupancyGrid& map, const EnergyGrid& grid, const EnergyGrid::Region& region,
                const Pose2& T_map_base, const std::string& file) {
  CellValues values(grid);
  for (std::size_t i = region.begin; i < region.end; ++i) values.add(grid.pose(i), 0.0);
  const double all = grid.orientations();
  values.show([all](double, int count) { return count / all; });
  Canvas canvas(map, cellsOf(grid), kSurroundings);
  const Scale scale(0.0, values.high());
  draw(canvas, map, values, scale);
  const cv::Scalar red(30, 30, 220);
  canvas.drawDot(T_map_base, red);
  canvas.drawPath({T_map_base, T_map_base * Pose2{0.5, 0.0, 0.0}}, red, 3);
  canvas.drawScaleBar();
  canvas.drawLegend(scale.legend(), {"share of headings in the region of the scan (red)",
                                     std::to_string(region.size()) + " poses"});
  saveImage(canvas.image(), "picture", file);
}

}  // namespace adaptive_localization
