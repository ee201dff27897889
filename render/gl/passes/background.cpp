// SPDX-License-Identifier: MIT
#include "render/gl/passes/background.h"

#include "render/palette.h"

#include <charconv>

namespace polhode {
namespace {

int hex_pair(std::string_view text) {
  int value = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, 16);
  return error == std::errc() && end == text.data() + text.size() ? value : -1;
}

}  // namespace

std::optional<Background> background_from(std::string_view text) {
  using Kind = Background::Kind;
  if (text == "studio") return Background{Kind::studio, {}};
  if (text == "paper") return Background{Kind::paper, {}};
  if (text == "white") return Background{Kind::white, {}};
  if (text == "transparent") return Background{Kind::transparent, {}};
  if (text == "transparent-dark") return Background{Kind::transparent, {}, true};
  if (text.size() != 7 || text[0] != '#') return std::nullopt;
  const int r = hex_pair(text.substr(1, 2)), g = hex_pair(text.substr(3, 2)), b = hex_pair(text.substr(5, 2));
  if (r < 0 || g < 0 || b < 0) return std::nullopt;
  return Background{Kind::color, color_from_hex(static_cast<unsigned>(r << 16 | g << 8 | b))};
}

Color sky_of(const Background& background) {
  switch (background.kind) {
    case Background::Kind::paper:
      return kPaper;
    case Background::Kind::color:
      return {background.color.r, background.color.g, background.color.b, 1.0F};
    case Background::Kind::transparent:
      return {0, 0, 0, 0};
    case Background::Kind::studio:
    case Background::Kind::white:
      break;
  }
  return {1, 1, 1, 1};
}

Color halo_of(const Background& background) {
  if (background.kind == Background::Kind::studio) return color_from_hex(0xF4F5F7, 0.88F);
  if (background.on_dark) return {kDarkGround.r, kDarkGround.g, kDarkGround.b, 0.85F};
  const Color sky = sky_of(background);
  return sky.a > 0.0F ? Color{sky.r, sky.g, sky.b, 0.9F} : color_from_hex(0xFFFFFF, 0.85F);
}

Figure on_dark_ground(Figure figure) {
  for (Pane& pane : figure.panes) {
    for (Tube& tube : pane.list.tubes)
      if (!tube.of_body) tube.color = paint_on_dark(tube.color);
    for (Wall& wall : pane.list.walls) {
      wall.line = paint_on_dark(wall.line);
      wall.ground = paint_on_dark(wall.ground);
    }
    for (Arrow& arrow : pane.list.arrows) arrow.color = paint_on_dark(arrow.color);
    for (Ball& ball : pane.list.balls) ball.color = paint_on_dark(ball.color);
    for (Mesh& mesh : pane.list.meshes)
      if (mesh.color.a < 1.0F) mesh.color = paint_on_dark(mesh.color);
  }
  return figure;
}

}  // namespace polhode
