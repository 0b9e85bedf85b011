// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace adaptive_localization {

/// From now on SIGINT and SIGTERM ask a node to stop, so that it has a last word: roscpp's own
/// handler would close the connection to the master before (ros::init_options::NoSigintHandler). A
/// second signal ends the process at once, and so does a master that does not answer to the leave
/// taking for ten seconds, less than roslaunch has; the reason is said then.
void catchStopSignals();

bool isStopRequested();

}  // namespace adaptive_localization
