// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace adaptive_localization {

/// Bytes that this process can still take: what the machine has available, and what the limit on
/// its address space leaves. Infinite where the system does not tell (Linux does).
double freeMemory();

}  // namespace adaptive_localization
