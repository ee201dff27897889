// SPDX-License-Identifier: MIT
// A film of pictures that lie in files, made by ffmpeg.
#pragma once

#include "app/export/timeline.h"
#include "base/interrupt.h"
#include "base/result.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace polhode {

enum class FilmKind {
  mp4,   ///< H.264, 4:2:0: plays everywhere
  webm,  ///< VP9, with alpha where the pictures have it
  gif,   ///< 256 colours in all
  apng   ///< exact
};
/// By the name's extension; nothing for others.
std::optional<FilmKind> film_kind_of(const std::filesystem::path& file);

/// Browsers show a GIF of more frames a second slower than it says.
inline constexpr int kMostGifFrames = 50;

struct FilmRequest {
  std::filesystem::path file;                   ///< of a kind there is
  std::vector<std::filesystem::path> pictures;  ///< PNGs in the order they are shown, at least one
  FrameRate rate;
  std::int64_t frames_each = 1;  ///< for how many frames each is shown
  std::string title;             ///< in the file's metadata; not of GIFs
};

/// Sizes may differ: pictures stand in the middle of the largest width and height there are (rounded up to
/// even ones in MP4 and WebM), and their edges are repeated around them. Colours are tagged BT.709. What is
/// transparent becomes white in MP4 and GIF. `file` appears whole or not at all; folders above it are made,
/// and what killed processes left unfinished beside it goes. One picture is in memory at a time, besides what
/// ffmpeg holds.
/// `show(n)` is called before the n-th picture is read, from 0, in each pass; a GIF has two. The error says
/// why there is no film: no ffmpeg, what ffmpeg says, unreadable pictures, a full disk.
/// @throws Interrupted
Status write_film(const FilmRequest& request, const InterruptWatch& watch,
                  const std::function<void(std::int64_t)>& show);

}  // namespace polhode
