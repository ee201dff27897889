// SPDX-License-Identifier: MIT
// A folder is cleared of what killed processes left unfinished in it, before others write files there: by
// write_file_atomically for its one file, by an export or a site once for its many.
#pragma once

#include <filesystem>

namespace polhode {

/// Removes the temporary files there that nobody will finish (left_behind_in, temporary_file.h). What cannot
/// be removed stays.
void remove_left_behind_in(const std::filesystem::path& folder);

}  // namespace polhode
