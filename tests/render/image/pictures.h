// SPDX-License-Identifier: MIT
// Pictures to test with.
#pragma once

#include "render/image/image.h"

#include <cstdint>

namespace polhode::test {

/// Every pixel the same.
Image uniform(Size size, std::uint8_t r, std::uint8_t g, std::uint8_t b, std::uint8_t a = 255);

/// Gradients with the noise of a rendered scene; the same for the same arguments.
Image scenic(Size size, bool opaque);

}  // namespace polhode::test
