// SPDX-License-Identifier: MIT
// Where two windows stand on one screen so that both are seen.
#pragma once

#include "render/image/image.h"

namespace polhode {

/// On the desktop, in its units; windows with their frames.
struct DesktopBox {
  int x = 0, y = 0;
  Size size{};
  bool operator==(const DesktopBox&) const = default;
};

struct TwoPlaces {
  DesktopBox first, second;
  bool operator==(const TwoPlaces&) const = default;
};

/// `screen`: what bars leave of it. `first`: the window that there is, which stays as it is if the screen has
/// room beside or below it for a second one as large. Else each takes a half of the screen, if that is no
/// smaller than `least`, the second from its top to its bottom; else they stand in opposite corners, and some
/// of each is seen.
TwoPlaces two_places(const DesktopBox& screen, const DesktopBox& first, Size least);

}  // namespace polhode
