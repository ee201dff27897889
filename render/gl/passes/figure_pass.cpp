// SPDX-License-Identifier: MIT
#include "render/gl/passes/figure_pass.h"

#include "render/gl/passes/cover.h"
#include "render/gl/passes/floats.h"
#include "render/gl/passes/geometry.h"
#include "render/gl/shader_sources.h"
#include "render/palette.h"

#include <algorithm>
#include <cmath>

namespace polhode {
namespace {

constexpr double kNowhere = -1e6;  // a height, scene units; finite when counted in pixels
// What opaque things keep below the floor, seen from above. A dark floor leaves less to be seen of them.
constexpr float kSunk = 0.42F, kSunkInDark = 0.85F;
constexpr std::size_t kMostGlasses = 2;  // as in behind_glass.glsl

void set(const Program& program, const std::string& name, const Mat4& m) {
  const Eigen::Matrix4f f = m.cast<float>();
  program.set_mat4(name.c_str(), std::span<const float, 16>(f.data(), 16));
}
void set(const Program& program, const std::string& name, const Mat3& m) {
  const Eigen::Matrix3f f = m.cast<float>();
  program.set_mat3(name.c_str(), std::span<const float, 9>(f.data(), 9));
}
void set(const Program& program, const std::string& name, const Vec3& v) {
  program.set(name.c_str(), floats(v));
}
void set(const Program& program, const std::string& name, double x) {
  program.set(name.c_str(), static_cast<float>(x));
}
void set(const Program& program, const std::string& name, const Color& c) {
  program.set(name.c_str(), c.r, c.g, c.b);
}

std::array<float, 4> premultiplied(const Color& c) { return {c.r * c.a, c.g * c.a, c.b * c.a, c.a}; }

void set_glass(const Program& program, const std::string& glass, const std::string& ball,
               const GlassEllipsoid& e, const Viewpoint& at) {
  const Mat3 to_unit = to_ball(e);
  set(program, ball, to_unit);
  set(program, glass + ".eye", Vec3(to_unit * (at.eye - e.center)));
  set(program, glass + ".per_axis", Vec3(e.semi_axes.cwiseInverse()));
  set(program, glass + ".up", Vec3(to_unit.col(2)));
  set(program, glass + ".light", Vec3(to_unit * at.light));
  set(program, glass + ".tint", e.tint);
  set(program, glass + ".graticule", e.graticule);
}

struct FloorColors {
  Color near, far, line;
  float image;  ///< of the tint in the mirror
};
FloorColors floor_colors(bool dark) {
  if (dark) return {{0.17F, 0.19F, 0.22F}, {0.145F, 0.16F, 0.185F}, {0.33F, 0.37F, 0.43F}, 0.35F};
  return {{0.800F, 0.830F, 0.865F}, {0.86F, 0.88F, 0.905F}, {0.60F, 0.66F, 0.72F}, 1.0F};
}

/// Whether each pixel gets the colour of a backdrop: to clear it before is not needed.
bool covers_all(const Figure& figure, const Background& background) {
  if (figure.panes.empty()) return false;
  const Pane& pane = figure.panes.front();
  return background.kind == Background::Kind::studio && pane.x <= 0.0 && pane.y <= 0.0 && pane.width >= 1.0 &&
         pane.height >= 1.0;
}

}  // namespace

struct FigurePass::Shown {
  const Pane& pane;
  const Background& background;
  PixelArea viewport;
  Viewpoint at;
  double fineness;

  /// Nothing is seen of one edge on.
  const Floor* floor() const {
    constexpr double kEdgeOn = 1e-6;
    const auto& floors = pane.list.floors;
    if (floors.empty() || std::abs(at.eye.z() - floors.front().z) < kEdgeOn) return nullptr;
    return &floors.front();
  }
  bool from_below() const { return floor() && at.eye.z() <= floor()->z; }
  /// What is lower is below the floor.
  double level() const { return floor() ? floor()->z - 1e-3 : kNowhere; }
  /// What a thing keeps of itself there.
  float sunk() const { return is_dark(halo_of(background)) ? kSunkInDark : kSunk; }
};

FigurePass::FigurePass(const Gl& gl, Programs programs)
    : gl_(gl),
      programs_(std::move(programs)),
      tubes_(gl, {3, 3, 4, 3}),
      meshes_(gl, {3, 3, 4}),
      lines_(gl, {3, 3, 4, 4, 2, 3, 1}),
      solids_(gl, {2, 3, 3, 4, 2}),
      outlines_(gl, {2}),
      nothing_(gl, {}) {}

Result<std::unique_ptr<FigurePass>> FigurePass::create(const Gl& gl) {
  using namespace shaders;
  using Parts = std::vector<std::string_view>;
  std::string error;
  const auto make = [&](const std::string& name, const Parts& vertex,
                        const Parts& fragment) -> std::optional<Program> {
    if (!error.empty()) return std::nullopt;
    auto made = Program::create(gl, name, vertex, fragment);
    if (made) return std::move(made).value();
    error = made.error();
    return std::nullopt;
  };
  const char *const studio_sky = "#define STUDIO\n", *const ball = "#define BALL\n";
  const Parts screen = {kScreenVert}, glass = {kGlass_structGlsl, kGlassVert};

  auto studio = make("backdrop", {kSkyGlsl, kBackdropVert}, {kSkyGlsl, kNoiseGlsl, kBackdropFrag});
  const auto floors = [&](const std::string& name, const char* sky) -> std::array<std::optional<Program>, 3> {
    const char* const mirror = "#define MIRROR\n";
    const auto part = [&](const std::string& title, const char* first, const char* second) {
      return make(title, {first, second, sky, kSkyGlsl, kFloorVert},
                  {first, second, sky, kSkyGlsl, kNoiseGlsl, kFloorFrag});
    };
    return {part(name, "", ""), part("shaded " + name, ball, ""), part("mirroring " + name, ball, mirror)};
  };
  auto on_color = floors("floor", "");
  auto on_studio = floors("floor of the studio", studio_sky);
  auto from_below = floors("floor from below", "#define FROM_BELOW\n");
  auto wall = make("wall", {kWallVert}, {kWallFrag});
  auto both_sides = make("glass", glass, {kGlass_structGlsl, kGlassGlsl, kGlassFrag});
  auto far_side = make("far glass", glass, {"#define FAR_SIDE\n", kGlass_structGlsl, kGlassGlsl, kGlassFrag});
  auto near_side =
      make("near glass", glass, {"#define NEAR_SIDE\n", kGlass_structGlsl, kGlassGlsl, kGlassFrag});
  const auto in_glass = [&](const std::string& name, std::string_view vertex, std::string_view kind,
                            std::string_view fragment) -> std::array<std::optional<Program>, 3> {
    const auto behind = [&](const char* number) {
      return make(name, {number, kGlass_structGlsl, vertex},
                  {kind, number, kLightGlsl, kGlass_structGlsl, kGlassGlsl, kBehind_glassGlsl, fragment});
    };
    return {behind("#define GLASSES 0\n"), behind("#define GLASSES 1\n"), behind("#define GLASSES 2\n")};
  };
  auto line = in_glass("line", kStrokeVert, "", kStrokeFrag);
  auto line_depth = make("depth of lines", {"#define GLASSES 0\n", kStrokeVert}, {kStroke_depthFrag});
  auto cone = in_glass("cone", kSolidVert, "#define CONE\n", kSolidFrag);
  auto ball_shape = in_glass("ball", kSolidVert, "", kSolidFrag);
  auto tube = make("tube", {kTubeVert}, {kLightGlsl, kTubeFrag});
  auto mesh = make("mesh", {kMeshVert}, {kLightGlsl, kMeshFrag});
  auto layer = make("layer", screen, {kCompositeFrag});
  if (!error.empty()) return failure(error);
  const auto three_glasses = [](std::array<std::optional<Program>, 3>& made) -> std::array<Program, 3> {
    return {std::move(*made[0]), std::move(*made[1]), std::move(*made[2])};
  };
  const auto three = [](std::array<std::optional<Program>, 3>& made) -> Floors {
    return {std::move(*made[0]), std::move(*made[1]), std::move(*made[2])};
  };
  return std::unique_ptr<FigurePass>(new FigurePass(
      gl, {std::move(*studio), three(on_color), three(on_studio), three(from_below), std::move(*wall),
           std::move(*both_sides), std::move(*far_side), std::move(*near_side), std::move(*line_depth),
           three_glasses(line), three_glasses(cone), three_glasses(ball_shape), std::move(*tube),
           std::move(*mesh), std::move(*layer)}));
}

FigurePass::Shown FigurePass::show(const Pane& pane, const Framebuffer& target, const Background& background,
                                   int fineness) const {
  const auto [width, height] = target.size();
  const int x0 = static_cast<int>(std::lround(pane.x * width));
  const int x1 = static_cast<int>(std::lround((pane.x + pane.width) * width));
  const int y0 = static_cast<int>(std::lround((1.0 - pane.y - pane.height) * height));
  const int y1 = static_cast<int>(std::lround((1.0 - pane.y) * height));
  const PixelArea viewport = {x0, y0, std::max(1, x1 - x0), std::max(1, y1 - y0)};
  gl_.Viewport(viewport.x, viewport.y, viewport.width, viewport.height);
  const double aspect = static_cast<double>(viewport.width) / viewport.height;
  return {pane, background, viewport, viewpoint_of(pane.camera, aspect, viewport.height),
          static_cast<double>(fineness)};
}

void FigurePass::clear(const Background& background, GLbitfield buffers) const {
  if (buffers == 0) return;  // browsers complain of what clears nothing
  const Color sky = sky_of(background);
  gl_.ClearColor(sky.r * sky.a, sky.g * sky.a, sky.b * sky.a, sky.a);
  gl_.DepthMask(GL_TRUE);
  gl_.Clear(buffers);
}

void FigurePass::draw(const Figure& figure, const Background& background, int fineness,
                      const Framebuffer& target, const Framebuffer* layer) {
  std::vector<std::vector<PixelArea>> layered;  // of each pane
  if (layer) {
    layer->bind();
    for (const Pane& pane : figure.panes) {
      const Shown shown = show(pane, *layer, background, fineness);
      layered.push_back(cover_of(pane.list, shown.at, shown.viewport).boxes());
      draw_layer(shown, layered.back());
    }
    for (const auto& parts : layered)
      for (const PixelArea& part : parts) layer->resolve(part);
  }
  target.bind();
  const GLbitfield depth = layer ? 0 : GL_DEPTH_BUFFER_BIT;  // a layer has its own
  clear(background, covers_all(figure, background) ? depth : GL_COLOR_BUFFER_BIT | depth);
  for (std::size_t i = 0; i < figure.panes.size(); ++i) {
    const Shown shown = show(figure.panes[i], target, background, fineness);
    draw_surroundings(shown);
    if (layer) {
      draw_glass(shown, programs_.far_glass);
      lay_over(*layer, layered[i]);
    } else {
      draw_glass(shown, programs_.glass);
      draw_strokes(shown, {shown.from_below() ? 1.0F : shown.sunk(), 1.0F});
    }
    if (!shown.from_below()) continue;
    draw_floor_from_below(shown);
    if (!layer) draw_strokes(shown, {1.0F, 0.0F});
  }
}

void FigurePass::draw_by_samples(const Figure& figure, const Background& background, int fineness,
                                 const Framebuffer& target) {
  target.bind();
  clear(background, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  for (const Pane& pane : figure.panes) {
    const Shown shown = show(pane, target, background, fineness);
    draw_surroundings(shown);
    draw_glass(shown, programs_.far_glass);
    draw_solids(shown);
    if (shown.from_below()) draw_floor_from_below(shown);
  }
}

void FigurePass::lay_over(const Framebuffer& picture, int x, int y) const {
  programs_.layer.use();
  programs_.layer.set("u_layer", 0);
  programs_.layer.set("u_corner", static_cast<float>(x), static_cast<float>(y));
  gl_.BindTexture(GL_TEXTURE_2D, picture.texture());
  nothing_.draw_without_vertices(GL_TRIANGLES, 3);
}

void FigurePass::draw_floor_from_below(const Shown& shown) {
  draw_floor(shown, programs_.from_below, floor_box(shown.at, shown.floor()->z));
}

/// Backdrop and, from above, the floor; each pixel once, without blending.
void FigurePass::draw_surroundings(const Shown& shown) {
  const bool studio = shown.background.kind == Background::Kind::studio;
  const bool floor = shown.floor() && !shown.from_below();
  const ClipBox seen = floor ? floor_box(shown.at, shown.floor()->z) : ClipBox{0, 0, 0, 0};
  gl_.Disable(GL_BLEND);
  if (studio) {
    programs_.studio.use();
    set_window(programs_.studio, shown);
    for (const ClipBox& box : around(seen, {})) draw_box(programs_.studio, box);
  }
  if (floor) draw_floor(shown, studio ? programs_.on_studio : programs_.on_color, seen);
  gl_.Enable(GL_BLEND);
  draw_walls(shown);
}

/// In the order of the list, doors over their walls: walls of one room that are seen do not hide one another.
void FigurePass::draw_walls(const Shown& shown) {
  if (shown.pane.list.walls.empty()) return;
  const Program& program = programs_.wall;
  program.use();
  set(program, "u_view_projection", shown.at.view_projection);
  for (const Wall& wall : shown.pane.list.walls) {
    if (!is_seen(wall, shown.at.eye)) continue;
    set(program, "u_center", wall.center);
    set(program, "u_right", wall.right);
    set(program, "u_up", wall.up);
    const Eigen::Vector2f cells = wall.cells.cast<float>();
    program.set("u_cells", cells.x(), cells.y());
    const auto in_cells = [&](const Vec3& half, float count) {
      return static_cast<float>(0.5 * wall.radius / half.norm()) * count;
    };
    program.set("u_half_line", in_cells(wall.right, cells.x()), in_cells(wall.up, cells.y()));
    program.set("u_line", premultiplied(wall.line));
    program.set("u_ground", premultiplied(wall.ground));
    nothing_.draw_without_vertices(GL_TRIANGLE_STRIP, 4);
  }
}

/// From clip space to noise.glsl.
void FigurePass::set_window(const Program& program, const Shown& shown) {
  const auto [x, y, width, height] = shown.viewport;
  const double column = 1.0 / (16.0 * shown.fineness), row = 1.0 / shown.fineness;
  const Eigen::Vector4f window = Eigen::Vector4d(column * (x + 0.5 * width), row * (y + 0.5 * height),
                                                 0.5 * column * width, 0.5 * row * height)
                                     .cast<float>();
  program.set("u_window", window.x(), window.y(), window.z(), window.w());
}

void FigurePass::set_floor(const Program& program, const Shown& shown) {
  const Floor& floor = *shown.floor();
  const FloorColors colors = floor_colors(is_dark(halo_of(shown.background)));
  program.use();
  set_window(program, shown);
  const Color sky = sky_of(shown.background);
  program.set("u_sky", sky.r * sky.a, sky.g * sky.a, sky.b * sky.a, sky.a);
  program.set("u_step", static_cast<float>(2.0 * shown.fineness / shown.viewport.width),
              static_cast<float>(2.0 * shown.fineness / shown.viewport.height));
  set(program, "u_ray", shown.at.ray);
  set(program, "u_eye", shown.at.eye);
  set(program, "u_floor_z", floor.z);
  set(program, "u_cells", 1.0 / floor.grid);
  program.set("u_fade", static_cast<float>(kFloorFades), static_cast<float>(kFloorEnds));
  set(program, "u_near", colors.near);
  set(program, "u_far", colors.far);
  set(program, "u_line", colors.line);
  const float image = 0.92F * colors.image;
  if (!shown.pane.list.ellipsoids.empty())
    set_ball(program, shown.pane.list.ellipsoids.front(), image, shown);
}

/// What the ellipsoid does to the floor. @param image of its tint in the mirror
void FigurePass::set_ball(const Program& program, const GlassEllipsoid& e, float image, const Shown& shown) {
  const FloorForm form = floor_form(shown.at, shown.floor()->z, e, shown.floor()->grid);
  Eigen::Matrix3f columns;
  columns << form.u.cast<float>(), form.v.cast<float>(), form.to_light.cast<float>();
  program.set_array("u_from_ball", 3, std::span<const float, 9>(columns.data(), 9));
  set(program, "u_to_ball", to_ball(e));
  set(program, "u_ball_center", e.center);
  program.set("u_tint", image * e.tint.r, image * e.tint.g, image * e.tint.b);
}

/// Each part by the program that has just what is seen there.
void FigurePass::draw_floor(const Shown& shown, const Floors& programs, const ClipBox& box) {
  const auto& ellipsoids = shown.pane.list.ellipsoids;
  ClipBox shaded{0, 0, 0, 0}, mirroring{0, 0, 0, 0};
  if (!ellipsoids.empty()) {
    const FloorShading shading = floor_shading(shown.at, shown.floor()->z, ellipsoids.front());
    shaded = common(box, shading.shade);
    if (!shown.from_below()) mirroring = common(box, shading.image);
  }
  const ClipBox near = united(shaded, mirroring);
  set_floor(programs.plain, shown);
  for (const ClipBox& part : around(near, box)) draw_box(programs.plain, part);
  if (near.empty()) return;
  set_floor(programs.shaded, shown);
  for (const ClipBox& part : around(mirroring, near)) draw_box(programs.shaded, part);
  if (mirroring.empty()) return;
  set_floor(programs.mirroring, shown);
  draw_box(programs.mirroring, mirroring);
}

void FigurePass::draw_glass(const Shown& shown, const Program& program) {
  program.use();
  set(program, "u_ray", shown.at.ray);
  set(program, "u_light", shown.at.light);
  set(program, "u_fineness", shown.fineness);
  for (const GlassEllipsoid& e : shown.pane.list.ellipsoids) {
    set_glass(program, "u_glass", "u_to_ball", e, shown.at);
    Geometry<Eigen::Vector2f> fan;
    for (const Eigen::Vector2d& corner : outline_polygon(e, shown.at.view_projection)) {
      fan.vertices.push_back(corner.cast<float>());
      const auto last = static_cast<std::uint32_t>(fan.vertices.size() - 1);
      if (last >= 2) fan.indices.insert(fan.indices.end(), {0U, last - 1, last});
    }
    outlines_.draw(fan);
  }
}

/// @param strengths of what is below the floor, and above or without one
void FigurePass::draw_strokes(const Shown& shown, const std::array<float, 2>& strengths) {
  const Strokes strokes = make_strokes(shown.pane.list, shown.at.eye);
  const auto& ellipsoids = shown.pane.list.ellipsoids;
  const std::size_t glasses = std::min(ellipsoids.size(), kMostGlasses);
  for (const Program* program :
       {&programs_.line_depth, &programs_.line[0], &programs_.line[glasses], &programs_.cone[0],
        &programs_.cone[glasses], &programs_.ball[0], &programs_.ball[glasses]}) {
    program->use();
    set(*program, "u_view_projection", shown.at.view_projection);
    set(*program, "u_eye", shown.at.eye);
    set(*program, "u_right", shown.at.right);
    set(*program, "u_light", shown.at.light);
    set(*program, "u_pixel", shown.at.pixel);
    set(*program, "u_fineness", shown.fineness);
    set(*program, "u_level", shown.level());
    program->set("u_strengths", strengths);
    for (std::size_t i = 0; i < glasses; ++i) {
      const std::string index = "[" + std::to_string(i) + "]";
      set_glass(*program, "u_glass" + index, "u_to_ball" + index, ellipsoids[i], shown.at);
    }
  }
  gl_.Enable(GL_DEPTH_TEST);
  gl_.DepthFunc(GL_LEQUAL);  // what is drawn again is not hidden by itself
  lines_.upload(strokes.lines);
  solids_.upload(strokes.solids);
  draw_depth_of_whole_pixels(strokes);
  gl_.DepthMask(GL_FALSE);
  for (const Strokes::Run& run : strokes.runs) {
    program_of(run.kind, glasses).use();
    (is_line(run.kind) ? lines_ : solids_).draw_range(run.first, run.count);
  }
  gl_.DepthMask(GL_TRUE);
  gl_.DepthFunc(GL_LESS);
  gl_.Disable(GL_DEPTH_TEST);
}

/// It comes first, and alone: a soft edge hides nothing that is painted after it, out of order.
void FigurePass::draw_depth_of_whole_pixels(const Strokes& strokes) {
  gl_.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  programs_.line_depth.use();
  lines_.draw_range(0, strokes.lines.indices.size());
  for (const Strokes::Run& run : strokes.runs) {
    if (is_line(run.kind)) continue;
    const Program& program = program_of(run.kind, 0);
    program.use();
    set(program, "u_least", 0.99);
    solids_.draw_range(run.first, run.count);
    set(program, "u_least", 0.0);
  }
  gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

const Program& FigurePass::program_of(Strokes::Kind kind, std::size_t glasses) const {
  switch (kind) {
    case Strokes::Kind::line:
      return programs_.line[0];
    case Strokes::Kind::line_in_glass:
      return programs_.line[glasses];
    case Strokes::Kind::cone:
      return programs_.cone[glasses];
    case Strokes::Kind::ball:
      break;
  }
  return programs_.ball[glasses];
}

/// On those parts alone: the rest is as it was, and nobody looks at it.
void FigurePass::draw_layer(const Shown& shown, const std::vector<PixelArea>& parts) {
  gl_.Enable(GL_SCISSOR_TEST);
  for (const PixelArea& part : parts) {
    gl_.Scissor(part.x, part.y, part.width, part.height);
    clear({Background::Kind::transparent, {}}, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  }
  gl_.Disable(GL_SCISSOR_TEST);
  draw_solids(shown);
}

void FigurePass::lay_over(const Framebuffer& layer, const std::vector<PixelArea>& parts) const {
  gl_.Enable(GL_SCISSOR_TEST);
  for (const PixelArea& part : parts) {
    gl_.Scissor(part.x, part.y, part.width, part.height);
    lay_over(layer, 0, 0);
  }
  gl_.Disable(GL_SCISSOR_TEST);
}

void FigurePass::draw_near_glass(const Shown& shown) {
  const Program& program = programs_.near_glass;
  program.use();
  set(program, "u_view_projection", shown.at.view_projection);
  set(program, "u_eye", shown.at.eye);
  gl_.DepthMask(GL_FALSE);
  draw_glass(shown, program);
  gl_.DepthMask(GL_TRUE);
}

/// Lines, solids and the glass in front of them: what hides one another.
void FigurePass::draw_solids(const Shown& shown) {
  const PaneGeometry geometry = make_geometry(shown.pane.list, shown.at.eye);
  gl_.Enable(GL_DEPTH_TEST);
  const auto prepare = [&](const Program& p) {
    p.use();
    set(p, "u_view_projection", shown.at.view_projection);
    set(p, "u_eye", shown.at.eye);
    set(p, "u_light", shown.at.light);
    set(p, "u_sunk_below", shown.from_below() ? kNowhere : shown.level());
    p.set("u_sunk", shown.sunk());
  };
  prepare(programs_.mesh);
  meshes_.draw(geometry.bodies);
  prepare(programs_.tube);
  if (!geometry.bodies.indices.empty()) {  // faintly, what they hide: where arrows begin is to be seen
    gl_.DepthFunc(GL_GREATER);
    gl_.DepthMask(GL_FALSE);
    tubes_.draw(geometry.arrows_in_bodies);
    programs_.mesh.use();
    meshes_.draw(geometry.balls_in_bodies);
    programs_.tube.use();
    gl_.DepthMask(GL_TRUE);
    gl_.DepthFunc(GL_LESS);
  }
  tubes_.draw(geometry.tubes);
  programs_.mesh.use();
  meshes_.draw(geometry.solid);
  draw_near_glass(shown);
  // Seen through, and hiding nothing: what is translucent comes last and leaves no depth.
  gl_.DepthMask(GL_FALSE);
  prepare(programs_.tube);
  tubes_.draw(geometry.faded_tubes);
  prepare(programs_.mesh);
  meshes_.draw(geometry.translucent);
  gl_.DepthMask(GL_TRUE);
  gl_.Disable(GL_DEPTH_TEST);
}

/// The program is in use.
void FigurePass::draw_box(const Program& program, const ClipBox& box) {
  program.set("u_bounds", static_cast<float>(box.x0), static_cast<float>(box.y0), static_cast<float>(box.x1),
              static_cast<float>(box.y1));
  nothing_.draw_without_vertices(GL_TRIANGLE_STRIP, 4);
}

}  // namespace polhode
