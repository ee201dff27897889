// SPDX-License-Identifier: MIT
// A file, whole, in memory.
#pragma once

#include "base/result.h"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace polhode {

/// The largest picture we write has 1 GiB of pixels.
inline constexpr std::uintmax_t kMaxPictureBytes = std::uintmax_t{5} << 28;

/// The bytes of a regular file (never waits for a pipe) of at most `most` bytes. The error is the reason
/// alone, without the file's name.
Result<std::vector<std::uint8_t>> read_file_bytes(const std::filesystem::path& path,
                                                  std::uintmax_t most = kMaxPictureBytes);

}  // namespace polhode
