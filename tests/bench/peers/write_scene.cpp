// SPDX-License-Identifier: MIT
// write_scene FRAMES: the scene of render_bench as JSON on stdout, for the peers to draw: what stays the same
// once (curves of the body in body axes, of space in space), and for each frame attitude, arrows, labels and
// camera. Lengths are scene units, colours sRGB 0…1 with straight alpha, quaternions scalar first.
#include "render/figure/make_figure.h"
#include "tests/bench/poinsot_scene.h"

#include <nlohmann/json.hpp>

#include <charconv>
#include <cstdio>
#include <cstring>

namespace polhode::bench {
namespace {

using Json = nlohmann::ordered_json;
constexpr double kAspect = 16.0 / 9.0;

Json json_of(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
Json json_of(const Quat& q) { return {q.w(), q.x(), q.y(), q.z()}; }
Json json_of(const Color& c) { return {c.r, c.g, c.b, c.a}; }

Json json_of(const Tube& tube, const Quat& turn) {
  Json points = Json::array();
  for (const Vec3& p : tube.points) points.push_back(json_of(Vec3(turn * p)));
  return {
      {"radius", tube.radius}, {"closed", tube.closed}, {"color", json_of(tube.color)}, {"points", points}};
}

/// Frame n of the film: time and camera go on as in BM_Frame.
Pane pane_of(SceneModel& model, const CameraSpec& start, int n) {
  model.scene.camera = start;
  model.scene.camera.azimuth_rad += n * kTurnOfCamera_rad;
  return make_figure(model, n * model.rate / kFramesPerSecond, kAspect).panes.at(0);
}

/// A curve stands in space if time does not move it, else on the body.
void add_curves(const Pane& first, const Pane& later, Json& scene) {
  const Quat to_body = first.list.ellipsoids.at(0).rotation.inverse();
  scene["body_curves"] = scene["space_curves"] = Json::array();
  for (std::size_t i = 0; i < first.list.tubes.size(); ++i) {
    const Tube& tube = first.list.tubes[i];
    const bool in_space = tube.points == later.list.tubes.at(i).points;
    scene[in_space ? "space_curves" : "body_curves"].push_back(
        json_of(tube, in_space ? Quat::Identity() : to_body));
  }
}

Json json_of(const Pane& pane) {
  const DrawList& list = pane.list;
  Json arrows = Json::array(), labels = Json::array();
  for (const Arrow& arrow : list.arrows)
    arrows.push_back({{"tail", json_of(arrow.tail)},
                      {"tip", json_of(arrow.tip)},
                      {"radius", arrow.radius},
                      {"color", json_of(arrow.color)}});
  for (const Label& label : list.labels)
    labels.push_back(
        {{"text", label.text}, {"anchor", json_of(label.anchor)}, {"color", json_of(label.color)}});
  const Camera& camera = pane.camera;
  return {{"rotation", json_of(list.ellipsoids.at(0).rotation)},
          {"eye", json_of(camera.eye)},
          {"target", json_of(camera.target)},
          {"up", json_of(camera.up)},
          {"fov_y_rad", camera.fov_y_rad},
          {"arrows", arrows},
          {"labels", labels},
          {"readout", list.readouts.at(0).lines}};
}

Json scene_of(int frames) {
  SceneModel model = make_model(poinsot_scene());
  const CameraSpec start = model.scene.camera;
  const Pane first = pane_of(model, start, 0);
  Json scene;
  scene["ellipsoid"] = {{"semi_axes", json_of(first.list.ellipsoids.at(0).semi_axes)},
                        {"color", json_of(first.list.ellipsoids.at(0).tint)}};
  scene["floor"] = {{"z", first.list.floors.at(0).z}, {"grid", first.list.floors.at(0).grid}};
  scene["ball"] = {{"radius", first.list.balls.at(0).radius},
                   {"color", json_of(first.list.balls.at(0).color)}};
  add_curves(first, pane_of(model, start, 1), scene);
  scene["frames"] = Json::array();
  for (int n = 0; n < frames; ++n) scene["frames"].push_back(json_of(pane_of(model, start, n)));
  return scene;
}

}  // namespace
}  // namespace polhode::bench

int main(int argc, char** argv) {
  int frames = 0;
  if (argc == 2) std::from_chars(argv[1], argv[1] + std::strlen(argv[1]), frames);
  if (frames < 1) {
    std::fputs("usage: write_scene FRAMES\n", stderr);
    return 2;
  }
  std::puts(polhode::bench::scene_of(frames).dump().c_str());
}
