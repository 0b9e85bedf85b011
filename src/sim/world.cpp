// SPDX-License-Identifier: BSD-3-Clause
#include "sim/world.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "adaptive_localization/map/distance_field.hpp"
#include "adaptive_localization/map/map_io.hpp"
#include "map/ray_caster.hpp"
#include "map/segment_index.hpp"

namespace adaptive_localization {
namespace {

struct Solid {
  Polygon polygon;
  Bounds bounds;
};

std::vector<Segment> sides(const Polygon& outline, const std::vector<Solid>& solids) {
  std::vector<Segment> segments;
  const auto add = [&](const Segment& side) { segments.push_back(side); };
  forEachSide(outline, add);
  for (const auto& solid : solids) forEachSide(solid.polygon, add);
  return segments;
}

class PolygonWorld final : public World {
 public:
  PolygonWorld(Polygon outline, std::vector<Solid> solids)
      : outline_(std::move(outline)),
        solids_(std::move(solids)),
        index_(sides(outline_, solids_)) {}

  double range(const Pose2& T_map_ray, double max_range) const override {
    return index_.range(T_map_ray, max_range);
  }

  double clearance(const Eigen::Vector2d& point, double cap) const override {
    return isSolid(point) ? 0.0 : index_.distance(point, cap);
  }

  Bounds bounds() const override { return boundsOf(outline_); }

 private:
  bool isSolid(const Eigen::Vector2d& point) const {
    if (!contains(outline_, point)) return true;
    return std::any_of(solids_.begin(), solids_.end(), [&](const Solid& solid) {
      return solid.bounds.contains(point) && contains(solid.polygon, point);
    });
  }

  Polygon outline_;
  std::vector<Solid> solids_;
  SegmentIndex index_;
};

/// For the robot unknown cells are solid: it must not drive off the map.
OccupancyGrid solidWhereNotFree(const OccupancyGrid& grid) {
  std::vector<std::int8_t> cells(grid.lattice().size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    cells[i] =
        grid.isFree(grid.lattice().cell(i)) ? OccupancyGrid::kFree : OccupancyGrid::kOccupied;
  }
  return {grid.lattice(), std::move(cells)};
}

class GridWorld final : public World {
 public:
  explicit GridWorld(std::shared_ptr<const OccupancyGrid> grid)
      : grid_(grid), caster_(grid), field_(solidWhereNotFree(*grid)) {}

  double range(const Pose2& T_map_ray, double max_range) const override {
    return caster_.range(T_map_ray, max_range);
  }

  double clearance(const Eigen::Vector2d& point, double cap) const override {
    const Lattice& lattice = grid_->lattice();
    if (!grid_->isFree(lattice.cellAt(point))) return 0.0;  // the field knows the faces of solids
    // To the nearest solid cell's centre; its side is half a cell nearer.
    return std::min(std::max(field_.between(point) - lattice.resolution() / 2.0, 0.0), cap);
  }

  Bounds bounds() const override {
    const Lattice& lattice = grid_->lattice();
    const auto& origin = lattice.origin();
    const double width = lattice.width() * lattice.resolution();
    const double height = lattice.height() * lattice.resolution();
    return boundsOf({origin * Eigen::Vector2d(0.0, 0.0), origin * Eigen::Vector2d(width, 0.0),
                     origin * Eigen::Vector2d(width, height),
                     origin * Eigen::Vector2d(0.0, height)});
  }

 private:
  std::shared_ptr<const OccupancyGrid> grid_;
  RayCaster caster_;
  DistanceField field_;
};

}  // namespace

std::shared_ptr<const World> makeWorld(const FloorPlan& plan, bool furniture) {
  std::vector<Solid> solids;
  const auto add = [&](const Polygon& polygon) { solids.push_back({polygon, boundsOf(polygon)}); };
  for (const auto& solid : solidsOf(plan)) add(solid);
  if (furniture) {
    for (const auto& piece : plan.furniture) add(piece);
  }
  return std::make_shared<PolygonWorld>(plan.outline, std::move(solids));
}

std::shared_ptr<const World> makeWorld(std::shared_ptr<const OccupancyGrid> grid) {
  return std::make_shared<GridWorld>(std::move(grid));
}

Site loadSite(const std::string& yaml_file, bool furniture) {
  bool is_map = false;
  try {
    const YAML::Node root = YAML::LoadFile(yaml_file);
    is_map = root.IsMap() && root["image"];
  } catch (const std::exception& error) {
    throw std::invalid_argument("world file '" + yaml_file + "': " + error.what());
  }
  if (is_map) {
    return {makeWorld(std::make_shared<const OccupancyGrid>(loadMap(yaml_file))), {}, {}, {}, {}};
  }
  const FloorPlan plan = loadFloorPlan(yaml_file);
  return {makeWorld(plan, furniture), plan.route, plan.start, plan.landmarks, plan.paint};
}

}  // namespace adaptive_localization
