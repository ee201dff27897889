// SPDX-License-Identifier: MIT
#include "render/image/compare_files.h"

#include "base/files/file_bytes.h"
#include "render/image/png_rows.h"

#include <algorithm>
#include <utility>

namespace polhode {

namespace {

namespace fs = std::filesystem;

Failure<std::string> cannot_read(const fs::path& path, const std::string& reason) {
  return failure("Cannot read " + path.string() + ": " + reason + ".");
}

Result<PngRows> rows_of(const fs::path& path) {
  auto bytes = read_file_bytes(path);
  if (!bytes) return cannot_read(path, bytes.error());
  auto rows = PngRows::open(std::move(*bytes));
  if (!rows) return cannot_read(path, rows.error());
  return rows;
}

}  // namespace

Result<FileComparison> compare_png_files(const fs::path& a, const fs::path& b) {
  auto rows_a = rows_of(a);
  if (!rows_a) return failure(rows_a.error());
  auto rows_b = rows_of(b);
  if (!rows_b) return failure(rows_b.error());
  FileComparison compared{{}, rows_a->size(), rows_b->size()};
  compared.found.same_size = compared.a == compared.b;
  for (int y = 0; y < std::max(compared.a.height, compared.b.height); ++y) {
    std::span<const std::uint8_t> row_a, row_b;
    if (y < compared.a.height) {
      const auto row = rows_a->next();
      if (!row) return cannot_read(a, row.error());
      row_a = *row;
    }
    if (y < compared.b.height) {
      const auto row = rows_b->next();
      if (!row) return cannot_read(b, row.error());
      row_b = *row;
    }
    if (compared.found.same_size) add_differences(row_a, row_b, compared.found);
  }
  return compared;
}

}  // namespace polhode
