// SPDX-License-Identifier: MIT
// Whether a file is undamaged and the picture that it should be. Every check sum in it is tested, its pixels
// are unpacked, its texts are compared with what they should say, and the checksum of all its bytes with the
// one noted when it was written, where that is known. That the pixels show the right thing is taken on trust.
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
  std::string sha256;  ///< of its bytes, where it is whole
};

/// @param metadata every text of it has to be in the file, and its dpi
/// @param sha256 of its bytes when it was written; empty: not known
PictureCheck check_picture(const std::filesystem::path& file, Size size, const PngMetadata& metadata,
                           const std::string& sha256 = {});

/// What is wrong with a file of any kind that has another checksum.
inline constexpr const char* kOtherBytes = "its bytes are not those that were written";

}  // namespace polhode
