// SPDX-License-Identifier: MIT
// Texts and colours as HTML, XML and SVG take them.
#pragma once

#include "base/color.h"

#include <string>
#include <string_view>

namespace polhode {

/// For text and for attributes in double quotes: & < > " ' become references, so no text can end either.
/// What XML does not have, control characters and U+FFFE and U+FFFF, becomes a blank, or U+FFFD.
std::string escaped(std::string_view utf8);

/// "#b04a00", without the opacity.
std::string hex(const Color& color);

}  // namespace polhode
