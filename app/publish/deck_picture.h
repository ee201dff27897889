// SPDX-License-Identifier: MIT
// The pictures of a deck: PNG files that are passed on as they are.
#pragma once

#include "render/image/png_chunks.h"

#include <filesystem>

namespace polhode {

/// The chunks point into the bytes, and move with them.
struct DeckPicture {
  std::vector<std::uint8_t> bytes;
  PngChunks png;
};

/// Reads and checks a file. The error names it.
Result<DeckPicture> read_deck_picture(const std::filesystem::path& file);

}  // namespace polhode
