// SPDX-License-Identifier: MIT
// Comparison of two PNG files by the golden rule, in little memory however large the pictures are.
#pragma once

#include "base/result.h"
#include "render/image/compare.h"

#include <filesystem>

namespace polhode {

struct FileComparison {
  Comparison found;
  Size a, b;
};

/// What compare_images finds. Both files are read to their end, whatever is found.
Result<FileComparison> compare_png_files(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace polhode
