// SPDX-License-Identifier: MIT
// Whether a file is, whole, the picture that it should be. Its pixels are taken on trust: what is compared is
// what the file says of itself, after every check sum in it.
#pragma once

#include "render/image/png.h"

#include <filesystem>
#include <string>

namespace polhode {

struct PictureCheck {
  enum class State {
    whole,
    missing,
    damaged,  ///< truncated, or a check sum is wrong
    another   ///< whole, but of another size or with other texts
  };
  State state = State::whole;
  std::string reason;  ///< "it is truncated or damaged after 512 bytes"
};

/// @param metadata every text of it has to be in the file, and its dpi
PictureCheck check_picture(const std::filesystem::path& file, Size size, const PngMetadata& metadata);

}  // namespace polhode
