// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace adaptive_localization {

/// Writes a file as a whole or not at all: the old one stands until the new one is on the disk, so
/// that a full disk or a power failure leaves one of the two. What is no file, as /dev/stdout, is
/// written to as it is. Throws std::runtime_error naming the file and why it cannot be written.
void writeWholeFile(const std::string& file, const std::string& contents);

}  // namespace adaptive_localization
