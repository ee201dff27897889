// SPDX-License-Identifier: MIT
// The part of an export that a process makes, from what was typed.
#pragma once

#include "app/export/folder/shard.h"

#include <string>

namespace polhode {

/// "I/N" with 1 ≤ I ≤ N, or "slurm": what SLURM_ARRAY_TASK_ID, _MIN, _STEP and _COUNT say. Empty: the whole.
/// @throws CommandError usage
Shard shard_from(const std::string& typed);

}  // namespace polhode
