// SPDX-License-Identifier: MIT
#include "render/typeset/glyph_outline.h"

#include <hb.h>

#include <memory>

namespace polhode {

namespace {

struct FuncsDeleter {
  void operator()(hb_draw_funcs_t* funcs) const { hb_draw_funcs_destroy(funcs); }
};

/// In the units of the font.
std::vector<OutlineStep>& steps_in(void* data) { return *static_cast<std::vector<OutlineStep>*>(data); }

void move_to(hb_draw_funcs_t*, void* data, hb_draw_state_t*, float x, float y, void*) {
  steps_in(data).push_back({OutlineStep::Kind::move, {Vec2(0, 0), Vec2(0, 0), Vec2(x, y)}});
}

void line_to(hb_draw_funcs_t*, void* data, hb_draw_state_t*, float x, float y, void*) {
  steps_in(data).push_back({OutlineStep::Kind::line, {Vec2(0, 0), Vec2(0, 0), Vec2(x, y)}});
}

void cubic_to(hb_draw_funcs_t*, void* data, hb_draw_state_t*, float x1, float y1, float x2, float y2, float x,
              float y, void*) {
  steps_in(data).push_back({OutlineStep::Kind::cubic, {Vec2(x1, y1), Vec2(x2, y2), Vec2(x, y)}});
}

void close_path(hb_draw_funcs_t*, void* data, hb_draw_state_t*, void*) {
  steps_in(data).push_back({OutlineStep::Kind::close, {Vec2(0, 0), Vec2(0, 0), Vec2(0, 0)}});
}

/// A quadratic curve comes as the cubic one that it is: HarfBuzz sees to that where nobody takes it.
hb_draw_funcs_t* pen() {
  static const std::unique_ptr<hb_draw_funcs_t, FuncsDeleter> funcs = [] {
    std::unique_ptr<hb_draw_funcs_t, FuncsDeleter> made(hb_draw_funcs_create());
    hb_draw_funcs_set_move_to_func(made.get(), move_to, nullptr, nullptr);
    hb_draw_funcs_set_line_to_func(made.get(), line_to, nullptr, nullptr);
    hb_draw_funcs_set_cubic_to_func(made.get(), cubic_to, nullptr, nullptr);
    hb_draw_funcs_set_close_path_func(made.get(), close_path, nullptr, nullptr);
    hb_draw_funcs_make_immutable(made.get());
    return made;
  }();
  return funcs.get();
}

}  // namespace

std::vector<OutlineStep> outline_of(const Fonts& fonts, Face face, std::uint32_t glyph) {
  std::vector<OutlineStep> steps;
#if HB_VERSION_ATLEAST(7, 0, 0)
  hb_font_draw_glyph(fonts.harfbuzz(face), glyph, pen(), &steps);
#else
  hb_font_get_glyph_shape(fonts.harfbuzz(face), glyph, pen(), &steps);
#endif
  const double units = fonts.units_per_em(face);
  for (OutlineStep& step : steps)
    for (Vec2& point : step.to) point /= units;
  return steps;
}

}  // namespace polhode
