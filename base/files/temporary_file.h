// SPDX-License-Identifier: MIT
// Names of unfinished files: they tell who writes them, so that what a killed process left can be told from
// what another one is writing just now, on this machine or, in a shared folder, on another.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

/// Temporary files begin with this; a killed process may leave one behind.
inline constexpr const char* kTemporaryPrefix = ".polhode-";
/// So many names are tried: those that killed processes of the same number left behind are skipped.
inline constexpr int kMaxTemporaryNames = 10000;

/// ".polhode-5f3a90c1-4711-0.part": where this process runs (the boot of the machine, and the set of
/// processes that can see each other), its number, and `i`, for a process with several at once.
std::string temporary_name(int i);
bool is_temporary_name(std::string_view name);

/// Temporary files that nobody will finish: of processes that ran here and are gone, or whose number another
/// one has got, a day after they were written; of others, whose end cannot be seen from here, an hour after.
/// Sorted. A folder that cannot be read has none.
std::vector<std::filesystem::path> left_behind_in(const std::filesystem::path& folder);

}  // namespace polhode
