// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QFile>
#include <QImage>
#include <string>

namespace adaptive_localization {

/// For reading, whatever letters the name has. By a handle: Qt would take the name in the locale's
/// encoding.
bool openFile(const std::string& name, QFile& file);

/// The picture of a map, 8 bits per channel: grey, or red, green and blue, with alpha where the
/// image has it. Throws MapFileError naming the image.
QImage readMapImage(const std::string& name);

}  // namespace adaptive_localization
