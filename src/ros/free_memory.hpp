// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace adaptive_localization {

/// Bytes that this process can still take: what the machine has available, and what the limit on
/// its address space leaves. Infinite where the system does not tell (Linux does).
double freeMemory();

/// From now on, blocks of more than 4 MB that are freed go back to the system at once. glibc alone
/// would raise that size to the largest block ever freed, and keep room for a map that is gone.
/// Call it before there are threads.
void returnFreedBlocks();

}  // namespace adaptive_localization
