// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>
#include <new>
#include <string>

namespace adaptive_localization {

/// What went wrong, in words. To be called while an exception is being handled, of whatever type:
/// plug-ins may throw anything.
inline std::string errorText() {
  try {
    throw;
  } catch (const std::bad_alloc&) {
    return "there is not enough memory";
  } catch (const std::exception& error) {
    return error.what();
  } catch (...) {
    return "something was thrown that is no std::exception";
  }
}

}  // namespace adaptive_localization
