// SPDX-License-Identifier: MIT
#include "app/web/live_api.h"

#include "app/web/live_figure.h"
#include "app/web/live_json.h"
#include "render/gl/context/webgl_context.h"

#include <emscripten/emscripten.h>

#include <exception>
#include <string>
#include <utility>

using namespace polhode;  // of this file alone: functions of C have no namespace

namespace {

/// The one figure of the module, the last refusal, and what was said last.
struct Module {
  LiveFigure figure;
  std::string message, said;
};
Module& module() {
  static Module the_module;
  return the_module;
}

/// Nothing that is thrown leaves this file.
template <class Act>
bool guarded(Act&& act) {
  Module& m = module();
  m.message.clear();
  m.figure.begin_call();
  try {
    act();
  } catch (const BudgetSpent&) {
    m.message = "This motion takes longer to compute than a page should.";
  } catch (const std::exception& error) {
    m.message = error.what();
  }
  return m.message.empty();
}

template <class Act>
int changed(Act&& act) {
  return guarded([&] {
    if (const Status done = act(); !done) module().message = done.error();
  })
             ? 1
             : 0;
}

template <class Say>
const char* said(Say&& say) {
  Module& m = module();
  const std::string message = m.message;  // words refuse nothing: that of the call before stays
  m.said = "null";
  guarded([&] { m.said = say(message); });
  if (m.message.empty()) m.message = message;
  return m.said.c_str();
}

}  // namespace

extern "C" {

EMSCRIPTEN_KEEPALIVE int polhode_open_lesson(const char* text, const char* file_name) {
  return changed([&] { return module().figure.open_lesson(text, file_name); });
}
EMSCRIPTEN_KEEPALIVE int polhode_open_scene(const char* scene_toml, const char* own_body_toml) {
  return changed([&] { return module().figure.open_scene(scene_toml, own_body_toml); });
}
EMSCRIPTEN_KEEPALIVE int polhode_show(int stage, int step) {
  if (stage < 1 || step < 1) stage = step = 0;  // which no lesson has
  return changed(
      [&] { return module().figure.show(static_cast<std::size_t>(stage), static_cast<std::size_t>(step)); });
}
EMSCRIPTEN_KEEPALIVE int polhode_show_stage(const char* stage_id, int step) {
  return changed([&] {
    return module().figure.show(std::string_view(stage_id), static_cast<std::size_t>(step < 1 ? 0 : step));
  });
}
EMSCRIPTEN_KEEPALIVE int polhode_attach(const char* selector) {
  return changed([&]() -> Status {
    module().figure.detach();
    auto context = context_of_canvas(selector);
    if (!context) return failure(context.error());
    return module().figure.attach(std::move(context).value());
  });
}
EMSCRIPTEN_KEEPALIVE void polhode_detach() {
  guarded([] { module().figure.detach(); });
}

EMSCRIPTEN_KEEPALIVE int polhode_height_for(int width) {
  int height = 0;
  guarded([&] { height = module().figure.height_for(width); });
  return height;
}
EMSCRIPTEN_KEEPALIVE int polhode_draw(int width, int height, int what, double resolution) {
  return changed([&] {
    const auto picture = what == POLHODE_SLIDE ? LiveFigure::Picture::slide : LiveFigure::Picture::figure;
    return module().figure.draw({width, height}, picture, resolution);
  });
}
EMSCRIPTEN_KEEPALIVE void polhode_set_theme(int dark) {
  guarded([&] { module().figure.set_theme(dark != 0 ? Theme::dark : Theme::paper); });
}

EMSCRIPTEN_KEEPALIVE void polhode_set_playing(int playing) {
  guarded([&] { module().figure.set_playing(playing != 0); });
}
EMSCRIPTEN_KEEPALIVE int polhode_advance(double seconds) {
  bool moves = false;
  guarded([&] { moves = module().figure.advance(seconds); });
  return moves ? 1 : 0;
}
EMSCRIPTEN_KEEPALIVE int polhode_set_time(double t_s) {
  return changed([&] { return module().figure.set_time(t_s); });
}
EMSCRIPTEN_KEEPALIVE void polhode_set_speed(double speed) {
  guarded([&] { module().figure.set_speed(speed); });
}

EMSCRIPTEN_KEEPALIVE int polhode_pointer(int kind, double x, double y, double reach) {
  auto on = FigureHand::On::nothing;
  const bool done = guarded([&] {
    LiveFigure& figure = module().figure;
    if (kind == POLHODE_DOWN) on = figure.point_down({x, y}, reach);
    if (kind == POLHODE_MOVE) on = figure.point_move({x, y}, reach);
    if (kind == POLHODE_UP) figure.point_up();
    if (kind == POLHODE_DOUBLE) figure.point_twice();
  });
  if (done) module().message = module().figure.refused_drag();
  return on == FigureHand::On::omega ? 2 : on == FigureHand::On::figure ? 1 : 0;
}
EMSCRIPTEN_KEEPALIVE void polhode_zoom(double notches) {
  guarded([&] { module().figure.zoom(notches); });
}
EMSCRIPTEN_KEEPALIVE void polhode_turn(double dx, double dy) {
  guarded([&] { module().figure.turn(dx, dy); });
}
EMSCRIPTEN_KEEPALIVE int polhode_key(const char* key) {
  return changed([&] { return module().figure.press_key(key); });
}

EMSCRIPTEN_KEEPALIVE void polhode_begin_change() {
  guarded([] { module().figure.begin_change(); });
}
EMSCRIPTEN_KEEPALIVE int polhode_set_omega(double w1, double w2, double w3) {
  return changed([&] { return module().figure.set_omega({w1, w2, w3}); });
}
EMSCRIPTEN_KEEPALIVE int polhode_set_attitude(double w, double x, double y, double z) {
  return changed([&] { return module().figure.set_attitude(Quat(w, x, y, z)); });
}
EMSCRIPTEN_KEEPALIVE int polhode_set_moments(double I1, double I2, double I3) {
  return changed([&] { return module().figure.set_moments({I1, I2, I3}); });
}
EMSCRIPTEN_KEEPALIVE int polhode_set_body(const char* name) {
  return changed([&] { return module().figure.set_body(name); });
}
EMSCRIPTEN_KEEPALIVE int polhode_vary(int number, double value) {
  return changed([&] { return module().figure.vary(static_cast<std::size_t>(number), value); });
}
EMSCRIPTEN_KEEPALIVE int polhode_set_method(const char* name, double step) {
  return changed([&] { return module().figure.set_method(name, step); });
}
EMSCRIPTEN_KEEPALIVE int polhode_show_overlay(const char* name, int shown) {
  return changed([&] { return module().figure.show_overlay(name, shown != 0); });
}
EMSCRIPTEN_KEEPALIVE int polhode_set_camera(double azimuth_rad, double elevation_rad, double zoom) {
  return changed([&] { return module().figure.set_camera(azimuth_rad, elevation_rad, zoom); });
}
EMSCRIPTEN_KEEPALIVE int polhode_undo() {
  return changed([] { return module().figure.undo(); });
}
EMSCRIPTEN_KEEPALIVE int polhode_reset() {
  return changed([] { return module().figure.reset(); });
}
EMSCRIPTEN_KEEPALIVE void polhode_light(const char* id) {
  guarded([&] { module().figure.light(id); });
}

EMSCRIPTEN_KEEPALIVE const char* polhode_message() { return module().message.c_str(); }
EMSCRIPTEN_KEEPALIVE const char* polhode_state() {
  return said([](const std::string& message) { return state_json(module().figure, message); });
}
EMSCRIPTEN_KEEPALIVE const char* polhode_choices() {
  return said([](const std::string&) { return choices_json(module().figure); });
}
EMSCRIPTEN_KEEPALIVE const char* polhode_words() {
  return said([](const std::string&) { return words_json(module().figure); });
}

}  // extern "C"
