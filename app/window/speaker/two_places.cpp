// SPDX-License-Identifier: MIT
#include "app/window/speaker/two_places.h"

#include <algorithm>

namespace polhode {

namespace {

int right_of(const DesktopBox& box) { return box.x + box.size.width; }
int bottom_of(const DesktopBox& box) { return box.y + box.size.height; }

bool holds(const DesktopBox& outer, const DesktopBox& inner) {
  return inner.x >= outer.x && inner.y >= outer.y && right_of(inner) <= right_of(outer) &&
         bottom_of(inner) <= bottom_of(outer);
}

}  // namespace

TwoPlaces two_places(const DesktopBox& screen, const DesktopBox& first, Size least) {
  const int width = first.size.width, height = first.size.height;
  for (const DesktopBox& beside :
       {DesktopBox{right_of(first), first.y, first.size}, DesktopBox{first.x - width, first.y, first.size},
        DesktopBox{first.x, bottom_of(first), first.size}, DesktopBox{first.x, first.y - height, first.size}})
    if (holds(screen, beside)) return {first, beside};
  const Size room = screen.size, half{room.width / 2, room.height / 2};
  const auto within = [&](int x, int y, Size most) {
    return DesktopBox{x, y, {std::min(width, most.width), std::min(height, most.height)}};
  };
  if (half.width >= least.width)
    return {within(screen.x, screen.y, {half.width, room.height}),
            {screen.x + half.width, screen.y, {half.width, room.height}}};
  if (half.height >= least.height)
    return {within(screen.x, screen.y, {room.width, half.height}),
            {screen.x, screen.y + half.height, {std::min(width, room.width), half.height}}};
  const DesktopBox one =
      within(screen.x, screen.y,
             {std::max(least.width, room.width * 4 / 5), std::max(least.height, room.height * 4 / 5)});
  return {one, {right_of(screen) - one.size.width, bottom_of(screen) - one.size.height, one.size}};
}

}  // namespace polhode
