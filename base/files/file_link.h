// SPDX-License-Identifier: MIT
// Files that appear whole under a name by a second name for bytes that are there already.
#pragma once

#include "base/files/atomic_file.h"

namespace polhode {

/// `path` becomes another name of the file `same`, in the same folder, at once and in place of what it was.
/// On failure `path` is as it was; not every file system has second names.
Status link_file_atomically(FileOps& files, const std::filesystem::path& same,
                            const std::filesystem::path& path);

/// Writes a file unless one of that name is there: true if it was made, and then by this process alone,
/// however many try at once (in a shared folder too). It and its name are on disk when it returns. Never
/// half-written; on failure nothing is left. Where files cannot have second names, two that try in the same
/// instant may both be told that they made it.
Result<bool> create_file_atomically(FileOps& files, const std::filesystem::path& path,
                                    std::span<const std::uint8_t> bytes);

}  // namespace polhode
