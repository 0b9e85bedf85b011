// SPDX-License-Identifier: BSD-3-Clause
#include "adaptive_localization/map/map_io.hpp"

#include <yaml-cpp/yaml.h>

#include <QImageReader>
#include <array>
#include <cstdint>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "core/whole_file.hpp"
#include "map_image.hpp"

namespace adaptive_localization {
namespace {

enum class Mode { kTrinary, kScale, kRaw };

struct MapFile {
  std::string image;
  double resolution;  // m per cell
  Pose2 origin;
  bool negate;
  double occupied_thresh;
  double free_thresh;
  Mode mode;
};

/// The value of a key that must be there. `expected` says of what kind.
template <class T>
T require(const YAML::Node& root, const std::string& key, const std::string& expected) {
  const YAML::Node node = root[key];
  if (!node) throw std::invalid_argument("'" + key + "' is missing, expected " + expected);
  try {
    return node.as<T>();
  } catch (const YAML::BadConversion&) {
    throw std::invalid_argument("'" + key + "': got '" + YAML::Dump(node) + "', expected " +
                                expected);
  }
}

void expect(bool holds, const YAML::Node& root, const std::string& key,
            const std::string& expected) {
  if (!holds) {
    throw std::invalid_argument("'" + key + "': got '" + YAML::Dump(root[key]) + "', expected " +
                                expected);
  }
}

bool readNegate(const YAML::Node& root) {
  const std::string expected = "0 or 1";
  bool truth{};
  if (root["negate"] && YAML::convert<bool>::decode(root["negate"], truth)) return truth;
  const int number = require<int>(root, "negate", expected);
  expect(number == 0 || number == 1, root, "negate", expected);
  return number == 1;
}

Mode readMode(const YAML::Node& root) {
  if (!root["mode"]) return Mode::kTrinary;
  const std::string expected = "trinary, scale or raw";
  const auto name = require<std::string>(root, "mode", expected);
  expect(name == "trinary" || name == "scale" || name == "raw", root, "mode", expected);
  return name == "raw" ? Mode::kRaw : name == "scale" ? Mode::kScale : Mode::kTrinary;
}

Pose2 readOrigin(const YAML::Node& root) {
  const std::string expected = "three finite numbers [x, y, yaw]";
  const auto numbers = require<std::vector<double>>(root, "origin", expected);
  expect(numbers.size() >= 3, root, "origin", expected);
  const Pose2 origin{numbers[0], numbers[1], numbers[2]};
  expect(isFinite(origin), root, "origin", expected);
  return origin;
}

YAML::Node readYaml(const std::string& yaml_file) {
  const std::string expected = "expected a YAML file with 'image: ...' and more";
  QFile file;
  if (openFile(yaml_file, file) && !QImageReader::imageFormat(&file).isEmpty()) {
    throw std::invalid_argument("got an image, " + expected);
  }
  const YAML::Node root = YAML::LoadFile(yaml_file);
  if (!root.IsMap()) throw std::invalid_argument("got no YAML map, " + expected);
  return root;
}

MapFile readMapFile(const std::string& yaml_file) {
  const YAML::Node root = readYaml(yaml_file);
  MapFile map;
  map.image = require<std::string>(root, "image", "the name of an image file");
  expect(!map.image.empty(), root, "image", "the name of an image file");
  map.resolution = require<double>(root, "resolution", "metres per cell");
  expect(map.resolution > 0.0 && std::isfinite(map.resolution), root, "resolution",
         "a positive number of metres per cell");
  map.origin = readOrigin(root);
  map.negate = readNegate(root);
  map.occupied_thresh = require<double>(root, "occupied_thresh", "a number in [0, 1]");
  expect(map.occupied_thresh >= 0.0 && map.occupied_thresh <= 1.0, root, "occupied_thresh",
         "a number in [0, 1]");
  map.free_thresh = require<double>(root, "free_thresh", "a number in [0, 1]");
  expect(map.free_thresh >= 0.0 && map.free_thresh <= map.occupied_thresh, root, "free_thresh",
         "a number in [0, occupied_thresh]");
  map.mode = readMode(root);
  return map;
}

/// One pixel's value as map_server gives it. `alpha` is 255 where the image has none.
std::int8_t toCell(double brightness, int alpha, const MapFile& map) {
  if (map.negate) brightness = 255.0 - brightness;
  if (map.mode == Mode::kRaw) return static_cast<std::int8_t>(static_cast<int>(brightness));
  const double occupancy = (255.0 - brightness) / 255.0;
  if (occupancy > map.occupied_thresh) return OccupancyGrid::kOccupied;
  if (occupancy < map.free_thresh) return OccupancyGrid::kFree;
  const double range = map.occupied_thresh - map.free_thresh;
  if (map.mode == Mode::kTrinary || alpha == 0 || range == 0.0) return OccupancyGrid::kUnknown;
  return static_cast<std::int8_t>(1.0 + 98.0 * (occupancy - map.free_thresh) / range);
}

/// One pixel of several channels. In trinary mode alpha counts as one more.
std::int8_t toCell(const unsigned char* pixel, int channels, const MapFile& map) {
  const bool has_alpha = channels == 4;
  const int averaged = has_alpha && map.mode != Mode::kTrinary ? channels - 1 : channels;
  const int sum = std::accumulate(pixel, pixel + averaged, 0);
  const int alpha = has_alpha ? pixel[channels - 1] : 255;
  return toCell(static_cast<double>(sum) / averaged, alpha, map);
}

/// The image's top row is the map's last.
class ImageRows {
 public:
  ImageRows(const QImage& image, const MapFile& map)
      : image_(image), map_(map), cells_(static_cast<std::size_t>(image.width())) {
    for (int grey = 0; grey < 256; ++grey) {
      of_grey_[static_cast<std::size_t>(grey)] = toCell(grey, 255, map);
    }
  }

  const std::int8_t* operator()(int row) {
    const int channels = image_.depth() / 8;
    const unsigned char* pixel = image_.constScanLine(image_.height() - 1 - row);
    for (std::int8_t& cell : cells_) {
      cell = channels == 1 ? of_grey_[*pixel] : toCell(pixel, channels, map_);
      pixel += channels;
    }
    return cells_.data();
  }

 private:
  const QImage& image_;
  const MapFile& map_;
  std::array<std::int8_t, 256> of_grey_;
  std::vector<std::int8_t> cells_;  // of one row
};

std::string besides(const std::string& yaml_file, const std::string& name) {
  if (name.front() == '/') return name;
  const auto slash = yaml_file.rfind('/');
  return slash == std::string::npos ? name : yaml_file.substr(0, slash + 1) + name;
}

/// Calls a reader with what the YAML file says, and names the file where something is wrong.
template <class Reader>
auto readMap(const std::string& yaml_file, const Reader& read) {
  const std::string about = "map file '" + yaml_file + "'";
  try {
    return read(readMapFile(yaml_file));
  } catch (const YAML::BadFile&) {
    throw MapFileError(MapFileError::Reason::kMissing, about + " cannot be opened");
  } catch (const MapFileError& error) {
    throw MapFileError(error.reason(), about + ": " + error.what());
  } catch (const std::exception& error) {
    throw MapFileError(MapFileError::Reason::kMetadata, about + ": " + error.what());
  }
}

}  // namespace

OccupancyGrid loadMap(const std::string& yaml_file) {
  return readMap(yaml_file, [&](const MapFile& map) {
    const QImage image = readMapImage(besides(yaml_file, map.image));
    const Lattice lattice(image.width(), image.height(), map.resolution, map.origin);
    return OccupancyGrid::fromRows(lattice, ImageRows(image, map));
  });
}

std::vector<std::string> filesOfMap(const std::string& yaml_file) {
  return readMap(yaml_file, [&](const MapFile& map) {
    return std::vector<std::string>{yaml_file, besides(yaml_file, map.image)};
  });
}

std::vector<std::string> filesToSave(const std::string& base) {
  return {base + ".pgm", base + ".yaml"};
}

void saveMap(const OccupancyGrid& grid, const std::string& base) {
  const Lattice& lattice = grid.lattice();
  std::ostringstream image;
  image << "P5\n" << lattice.width() << ' ' << lattice.height() << "\n255\n";
  for (int row = lattice.height() - 1; row >= 0; --row) {
    for (int column = 0; column < lattice.width(); ++column) {
      const int value = grid.at({column, row});
      const int grey = value < 0                                ? 205
                       : value <= 25                            ? 254
                       : value >= OccupancyGrid::kLeastOccupied ? 0
                                                                : 205;
      image.put(static_cast<char>(grey));
    }
  }
  std::ostringstream yaml;
  yaml.precision(15);
  const Pose2& origin = lattice.origin();
  const std::vector<std::string> files = filesToSave(base);
  const std::string name = files[0].substr(files[0].rfind('/') + 1);
  yaml << "image: " << YAML::Dump(YAML::Node(name)) << "\nresolution: " << lattice.resolution()
       << "\norigin: [" << origin.x << ", " << origin.y << ", " << origin.theta
       << "]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
  writeWholeFile(files[0], image.str());
  writeWholeFile(files[1], yaml.str());
}

}  // namespace adaptive_localization
