// SPDX-License-Identifier: BSD-3-Clause
#include "map_image.hpp"

#include <QImageReader>
#include <algorithm>
#include <cstdio>
#include <optional>

#include "adaptive_localization/map/map_file_error.hpp"

namespace adaptive_localization {
namespace {

QRgb greyAt(int index, const QImage& image) {
  const int grey = index * 255 / std::max(1, image.colorCount() - 1);
  return qRgb(grey, grey, grey);
}

/// The only colour of a picture that is transparent, if all others are greys in their order; else
/// nothing.
std::optional<int> transparentGrey(const QImage& image) {
  std::optional<int> transparent;
  for (int index = 0; index < image.colorCount(); ++index) {
    const QRgb colour = image.color(index);
    const bool is_grey = colour == greyAt(index, image);
    if (!is_grey && (qAlpha(colour) > 0 || transparent)) return std::nullopt;
    if (!is_grey) transparent = index;
  }
  return transparent;
}

/// A grey picture one of whose values is transparent comes as one with colours, that one black.
QImage greyIfGrey(QImage image) {
  const std::optional<int> transparent = transparentGrey(image);
  if (!transparent) return image;
  image.setColor(*transparent, greyAt(*transparent, image));
  return image.convertToFormat(QImage::Format_Grayscale8);
}

}  // namespace

bool openFile(const std::string& name, QFile& file) {
  std::FILE* const handle = std::fopen(name.c_str(), "rb");
  return handle != nullptr && file.open(handle, QFile::ReadOnly, QFile::AutoCloseHandle);
}

QImage readMapImage(const std::string& name) {
  using Reason = MapFileError::Reason;
  QFile file;
  if (!openFile(name, file)) {
    throw MapFileError(Reason::kMissing, "image '" + name + "' cannot be opened");
  }
  QImageReader reader(&file);
  const QImage image = greyIfGrey(reader.read());
  if (image.isNull()) {
    throw MapFileError(Reason::kImage, "image '" + name + "' is no image, expected PGM, PNG or " +
                                           "the like: " + reader.errorString().toStdString());
  }
  if (image.format() == QImage::Format_Grayscale8) return image;
  return image.convertToFormat(image.hasAlphaChannel() ? QImage::Format_RGBA8888
                                                       : QImage::Format_RGB888);
}

}  // namespace adaptive_localization
