// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace adaptive_localization {

/// Throws std::invalid_argument if a file that is to be written is one of those that are read, by
/// whatever name: it would be lost. Empty names stand for none.
void checkOutputs(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs);

}  // namespace adaptive_localization
