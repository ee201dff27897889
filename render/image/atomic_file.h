// SPDX-License-Identifier: MIT
// Files that appear whole under their final name, or not at all.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

#include "render/result.h"

namespace polhode {

/// Writes to a temporary file in the same folder, then renames it over `path`. On failure the temporary file is
/// gone, `path` is as it was, and the error names path and reason. Survives EINTR and short writes.
Status write_file_atomically(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);

/// Flushes the file system that holds `folder` to disk (syncfs): call once after the last file of an export.
Status sync_folder(const std::filesystem::path& folder);

}  // namespace polhode
