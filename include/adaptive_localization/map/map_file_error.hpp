// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

namespace adaptive_localization {

/// What is wrong with a map's files, naming the file, the key, the value and what was expected.
class MapFileError : public std::invalid_argument {
 public:
  enum class Reason { kMissing, kMetadata, kImage };

  MapFileError(Reason reason, const std::string& what)
      : std::invalid_argument(what), reason_(reason) {}

  Reason reason() const { return reason_; }

 private:
  Reason reason_;
};

}  // namespace adaptive_localization
