// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "../bag/bag_stream.hpp"
#include "localization_node.hpp"

namespace adaptive_localization {

/// amcl's --run-from-bag: takes tf and scans from a bag instead of topics, as fast as it goes, and
/// says where the robot was at the end. Topics count with and without a leading slash, /tf_static
/// whenever it was recorded; scans are those of the node's topics or of base_scan, as amcl wants.
/// Waits for the map first. Throws std::invalid_argument saying that the bag cannot be read or is
/// damaged.
void playBag(BagStream& bag, LocalizationNode& node, const std::function<bool()>& go_on);

}  // namespace adaptive_localization
