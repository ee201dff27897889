// SPDX-License-Identifier: MIT
// The pixels of a PNG row by row, for those who need no more of it at a time: a file of 1 MB may hold 1 GiB.
#pragma once

#include "base/result.h"
#include "render/image/image.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace polhode {

/// Reads and refuses what decode_png does, of the pixels as it comes to them. Keeps the file and one row; of
/// an interlaced picture, which we never write, all rows.
class PngRows {
 public:
  static Result<PngRows> open(std::vector<std::uint8_t> bytes);
  ~PngRows();
  PngRows(PngRows&&) noexcept;
  PngRows& operator=(PngRows&&) noexcept;

  Size size() const;
  /// The next row from the top, 8-bit RGBA; it stays valid until the next call. To be called once for each
  /// row. With the last one the rest of the file is looked at.
  Result<std::span<const std::uint8_t>> next();

 private:
  struct State;
  explicit PngRows(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace polhode
