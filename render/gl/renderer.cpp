// SPDX-License-Identifier: MIT
#include "render/gl/renderer.h"

#include "render/gl/flat_pass.h"
#include "render/gl/framebuffer.h"
#include "render/gl/geometry.h"
#include "render/gl/shader.h"
#include "render/gl/shader_sources.h"
#include "render/gl/sheet_pass.h"
#include "render/gl/stream.h"
#include "render/scene/palette.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <list>

namespace polhode {
namespace {

using Mat4 = Eigen::Matrix4d;

std::array<float, 3> floats(const Vec3& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

void set_mat4(const Program& program, const char* name, const Mat4& m) {
  const Eigen::Matrix4f f = m.cast<float>();
  program.set_mat4(name, std::span<const float, 16>(f.data(), 16));
}
void set_mat3(const Program& program, const char* name, const Mat3& m) {
  const Eigen::Matrix3f f = m.cast<float>();
  program.set_mat3(name, std::span<const float, 9>(f.data(), 9));
}

/// What every shader of a pane needs to know about the camera.
struct Viewpoint {
  Mat4 view_projection;
  Mat4 ray;  ///< clip (x, y, 1, 1) to a direction in the view's frame
  Vec3 eye;
  Vec3 light;  ///< unit, towards the key light: over the viewer's left shoulder
  double sunk_below;
};

Viewpoint viewpoint_of(const Pane& pane, double aspect) {
  const Mat4 view = pane.camera.view(), projection = pane.camera.projection(aspect);
  Mat4 turn = view;
  turn.topRightCorner<3, 1>().setZero();
  const Vec3 right = view.block<1, 3>(0, 0).transpose(), up = view.block<1, 3>(1, 0).transpose(),
             back = view.block<1, 3>(2, 0).transpose();
  const Vec3 light = (-0.45 * right + 0.75 * up + 0.42 * back + Vec3(0.0, 0.0, 0.35)).normalized();

  double sunk_below = -std::numeric_limits<double>::max();
  for (const Floor& floor : pane.list.floors)
    if (pane.camera.eye.z() > floor.z) sunk_below = floor.z - 1e-3;
  return {projection * view, (projection * turn).inverse(), pane.camera.eye, light, sunk_below};
}

/// From the view's frame to the space where the ellipsoid is the unit ball.
Mat3 to_ball(const GlassEllipsoid& e) {
  return e.semi_axes.cwiseInverse().asDiagonal() * e.rotation.toRotationMatrix().transpose();
}

/// Clip-space height of the floor's far end, where it has faded: nothing of it is seen above.
double floor_top(const Viewpoint& at, double floor_z) {
  constexpr double kFadeEnd = 7.5;  // as in floor.frag
  if (at.eye.z() <= floor_z) return 1.0;
  const Vec3 far_end = Vec3(-at.eye.x(), -at.eye.y(), 0.0).normalized() * kFadeEnd + Vec3(0.0, 0.0, floor_z);
  const Eigen::Vector4d clip = at.view_projection * far_end.homogeneous();
  return clip.w() > 0.0 ? std::clamp(clip.y() / clip.w(), -1.0, 1.0) : 1.0;
}

/// What a figure is drawn in. Lines and solids need several samples a pixel. The rest has analytic edges
/// and one sample: half the cost. `fine` is what is averaged into the picture; nothing without
/// supersampling.
struct Canvas {
  Size size;
  Quality quality;
  Framebuffer layer;
  std::optional<Framebuffer> fine;
  Framebuffer picture;
};

double samples_of(Size size, const Quality& quality) {
  return static_cast<double>(size.width) * size.height * std::max(1, quality.samples) *
         quality.supersampling * quality.supersampling;
}

class GlRenderer final : public Renderer {
 public:
  static Result<std::unique_ptr<Renderer>> create(const Gl& gl);

  Result<Image> draw(const Figure& figure, Size size, const Background& background,
                     const Quality& quality) override;
  Result<Image> draw(const Sheet& sheet, std::span<const Inset> insets, Size size,
                     const Background& background) override;
  const Fonts& fonts() const override { return *flat_.fonts; }
  int most_samples() const override { return limits(gl()).samples; }
  std::string driver() const override { return driver_name(gl()); }

 private:
  struct Programs {
    Program backdrop, floor, glass, tube, mesh, composite, average;
  };
  struct FlatPasses {
    std::unique_ptr<const Fonts> fonts;
    std::unique_ptr<GlyphPass> type;
    std::unique_ptr<FlatPass> figure;
    std::unique_ptr<SheetPass> sheet;
  };
  // The table lives on the heap because programs and streams keep a reference to it.
  GlRenderer(std::unique_ptr<const Gl> gl, Programs programs, FlatPasses flat)
      : gl_(std::move(gl)),
        programs_(std::move(programs)),
        flat_(std::move(flat)),
        tubes_(*gl_, {3, 3, 4, 3}),
        meshes_(*gl_, {3, 3, 4}),
        nothing_(*gl_, {}) {}

  const Gl& gl() const { return *gl_; }
  const Canvas& canvas() const { return canvases_.front(); }
  Result<Canvas> make_canvas(Size size, const Quality& quality) const;
  Status prepare(Size size, const Quality& quality);
  void start();
  void draw_figure(const Figure& figure, const Background& background);
  Status draw_inset(const Inset& inset);
  Result<Image> read_picture(const Framebuffer& picture, const Background& background);
  struct Shown {
    std::array<int, 4> viewport;  ///< x, y, width, height, px from the lower left
    Viewpoint at;
  };
  Shown show(const Pane& pane, Size size) const;
  void draw_layer(const Figure& figure);
  void draw_picture(const Figure& figure, const Background& background);
  void average();
  void clear(const Background& background);
  void draw_studio(const std::array<int, 4>& viewport, int fineness);
  void lay_over(GLuint texture, int x, int y);
  void draw_floor(const Pane& pane, const Viewpoint& at, const Background& background);
  void draw_glass(const Pane& pane, const Viewpoint& at, bool front);
  void draw_lines_and_solids(const Pane& pane, const Viewpoint& at);

  std::unique_ptr<const Gl> gl_;
  Programs programs_;
  FlatPasses flat_;
  VertexStream tubes_, meshes_, nothing_;
  std::list<Canvas> canvases_;  ///< the one in use first
  std::optional<Framebuffer> page_;
};

Color sky_of(const Background& background) {
  switch (background.kind) {
    case Background::Kind::paper:
      return color_from_hex(0xFBFAF6);
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

/// Text stays readable on any backdrop: light halo on light, and on transparent, dark on dark.
Color halo_of(const Background& background) {
  if (background.kind == Background::Kind::studio) return color_from_hex(0xF4F5F7, 0.88F);
  const Color sky = sky_of(background);
  return sky.a > 0.0F ? Color{sky.r, sky.g, sky.b, 0.9F} : color_from_hex(0xFFFFFF, 0.85F);
}

void remove_premultiplication(Image& image) {
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    const int a = image.rgba[i + 3];
    if (a == 0 || a == 255) continue;
    for (std::size_t k = 0; k < 3; ++k)
      image.rgba[i + k] = static_cast<std::uint8_t>(std::min(255, (image.rgba[i + k] * 255 + a / 2) / a));
  }
}

Result<Canvas> GlRenderer::make_canvas(Size size, const Quality& quality) const {
  const Size fine_size{size.width * quality.supersampling, size.height * quality.supersampling};
  auto layer = Framebuffer::create(gl(), fine_size, quality.samples);
  if (!layer) return failure(layer.error());
  auto picture = Framebuffer::create(gl(), size, 0);
  if (!picture) return failure(picture.error());
  Canvas made{size, quality, std::move(layer).value(), std::nullopt, std::move(picture).value()};
  if (quality.supersampling > 1) {
    auto fine = Framebuffer::create(gl(), fine_size, 0);
    if (!fine) return failure(fine.error());
    made.fine = std::move(fine).value();
  }
  return made;
}

/// Puts a canvas of this size and quality first. Some are kept, because figures of a few sizes take turns in
/// the pages of a film.
Status GlRenderer::prepare(Size size, const Quality& quality) {
  const auto found = std::find_if(canvases_.begin(), canvases_.end(),
                                  [&](const Canvas& c) { return c.size == size && c.quality == quality; });
  if (found != canvases_.end()) {
    canvases_.splice(canvases_.begin(), canvases_, found);
    return success();
  }
  constexpr double kKept = 64e6;  // samples; a page at 3840 x 2160 and its figures
  double total = samples_of(size, quality);
  for (const Canvas& c : canvases_) total += samples_of(c.size, c.quality);
  for (; total > kKept && !canvases_.empty(); canvases_.pop_back())
    total -= samples_of(canvases_.back().size, canvases_.back().quality);
  auto made = make_canvas(size, quality);
  if (!made) return failure(made.error());
  canvases_.push_front(std::move(made).value());
  return success();
}

/// To the colour of the sky; what is drawn over an opaque one leaves its alpha at 1.
void GlRenderer::clear(const Background& background) {
  const Color sky = sky_of(background);
  gl().ClearColor(sky.r * sky.a, sky.g * sky.a, sky.b * sky.a, sky.a);
  gl().Clear(GL_COLOR_BUFFER_BIT);
}

void GlRenderer::draw_studio(const std::array<int, 4>& viewport, int fineness) {
  const Program& p = programs_.backdrop;
  p.use();
  p.set("u_viewport_origin", static_cast<float>(viewport[0]), static_cast<float>(viewport[1]));
  p.set("u_viewport_size", static_cast<float>(viewport[2]), static_cast<float>(viewport[3]));
  p.set("u_fineness", static_cast<float>(fineness));
  gl().Disable(GL_BLEND);
  nothing_.draw_without_vertices(GL_TRIANGLES, 3);
  gl().Enable(GL_BLEND);
}

void GlRenderer::draw_floor(const Pane& pane, const Viewpoint& at, const Background& background) {
  if (pane.list.floors.empty()) return;
  const Floor& floor = pane.list.floors.front();
  const Program& p = programs_.floor;
  p.use();
  set_mat4(p, "u_ray", at.ray);
  p.set("u_eye", floats(at.eye));
  p.set("u_light", floats(at.light));
  p.set("u_floor_z", static_cast<float>(floor.z));
  p.set("u_grid", static_cast<float>(floor.grid));
  if (is_dark(halo_of(background))) {
    p.set("u_near", 0.17F, 0.19F, 0.22F);
    p.set("u_far", 0.145F, 0.16F, 0.185F);
    p.set("u_line", 0.33F, 0.37F, 0.43F);
  } else {
    p.set("u_near", 0.800F, 0.830F, 0.865F);
    p.set("u_far", 0.86F, 0.88F, 0.905F);
    p.set("u_line", 0.60F, 0.66F, 0.72F);
  }
  p.set("u_fineness", static_cast<float>(canvas().quality.supersampling));
  p.set("u_ball", pane.list.ellipsoids.empty() ? 0.0F : 1.0F);
  if (!pane.list.ellipsoids.empty()) {
    const GlassEllipsoid& e = pane.list.ellipsoids.front();
    set_mat3(p, "u_to_ball", to_ball(e));
    p.set("u_ball_center", floats(e.center));
    const float dim = is_dark(halo_of(background)) ? 0.35F : 1.0F;  // a mirror image on a dark floor
    p.set("u_tint", dim * e.tint.r, dim * e.tint.g, dim * e.tint.b);
  }
  p.set("u_bounds", -1.0F, -1.0F, 1.0F, static_cast<float>(floor_top(at, floor.z)));
  nothing_.draw_without_vertices(GL_TRIANGLE_STRIP, 4);
}

void GlRenderer::draw_glass(const Pane& pane, const Viewpoint& at, bool front) {
  const Program& p = programs_.glass;
  p.use();
  set_mat4(p, "u_ray", at.ray);
  set_mat4(p, "u_view_projection", at.view_projection);
  p.set("u_eye", floats(at.eye));
  p.set("u_light", floats(at.light));
  p.set("u_front", front ? 1.0F : 0.0F);
  p.set("u_fineness", static_cast<float>(canvas().quality.supersampling));
  if (front)
    gl().Enable(GL_DEPTH_TEST);
  else
    gl().Disable(GL_DEPTH_TEST);
  gl().DepthMask(GL_FALSE);
  for (const GlassEllipsoid& e : pane.list.ellipsoids) {
    set_mat3(p, "u_to_ball", to_ball(e));
    p.set("u_center", floats(e.center));
    p.set("u_tint", e.tint.r, e.tint.g, e.tint.b);
    p.set("u_graticule", e.graticule ? 1.0F : 0.0F);
    const auto b = outline_bounds(e, at.view_projection);
    p.set("u_bounds", static_cast<float>(b[0]), static_cast<float>(b[1]), static_cast<float>(b[2]),
          static_cast<float>(b[3]));
    nothing_.draw_without_vertices(GL_TRIANGLE_STRIP, 4);
  }
  gl().DepthMask(GL_TRUE);
}

void GlRenderer::draw_lines_and_solids(const Pane& pane, const Viewpoint& at) {
  const PaneGeometry geometry = make_geometry(pane.list);
  gl().Enable(GL_DEPTH_TEST);
  const auto prepare_program = [&](const Program& p) {
    p.use();
    set_mat4(p, "u_view_projection", at.view_projection);
    p.set("u_eye", floats(at.eye));
    p.set("u_light", floats(at.light));
    p.set("u_sunk_below", static_cast<float>(at.sunk_below));
  };
  prepare_program(programs_.mesh);
  meshes_.draw(geometry.solid);
  prepare_program(programs_.tube);
  tubes_.draw(geometry.tubes);
  draw_glass(pane, at, true);
  // Seen through, and hiding nothing: what is translucent comes last and leaves no depth.
  gl().DepthMask(GL_FALSE);
  prepare_program(programs_.tube);
  tubes_.draw(geometry.faded_tubes);
  prepare_program(programs_.mesh);
  meshes_.draw(geometry.translucent);
  gl().DepthMask(GL_TRUE);
}

GlRenderer::Shown GlRenderer::show(const Pane& pane, Size size) const {
  const int x0 = static_cast<int>(std::lround(pane.x * size.width));
  const int x1 = static_cast<int>(std::lround((pane.x + pane.width) * size.width));
  const int y0 = static_cast<int>(std::lround((1.0 - pane.y - pane.height) * size.height));
  const int y1 = static_cast<int>(std::lround((1.0 - pane.y) * size.height));
  const std::array<int, 4> viewport = {x0, y0, std::max(1, x1 - x0), std::max(1, y1 - y0)};
  gl().Viewport(viewport[0], viewport[1], viewport[2], viewport[3]);
  return {viewport, viewpoint_of(pane, static_cast<double>(viewport[2]) / viewport[3])};
}

/// Lines, solids and the glass in front of them: what hides one another.
void GlRenderer::draw_layer(const Figure& figure) {
  const Framebuffer& layer = canvas().layer;
  layer.bind();
  gl().ClearColor(0, 0, 0, 0);
  gl().DepthMask(GL_TRUE);
  gl().Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  for (const Pane& pane : figure.panes) {
    const Shown shown = show(pane, layer.size());
    draw_lines_and_solids(pane, shown.at);
  }
  layer.resolve();
}

/// From the back to the front: backdrop and floor, far side of the glass, the layer, text.
void GlRenderer::draw_picture(const Figure& figure, const Background& background) {
  const Framebuffer& picture = canvas().picture;
  const Framebuffer& drawn = canvas().fine ? *canvas().fine : picture;
  drawn.bind();
  clear(background);
  for (const Pane& pane : figure.panes) {
    const Shown shown = show(pane, drawn.size());
    if (background.kind == Background::Kind::studio)
      draw_studio(shown.viewport, canvas().quality.supersampling);
    draw_floor(pane, shown.at, background);
    draw_glass(pane, shown.at, false);
  }
  gl().Viewport(0, 0, drawn.size().width, drawn.size().height);
  lay_over(canvas().layer.texture(), 0, 0);
  if (canvas().fine) average();
  flat_.figure->draw(figure, picture.size(), halo_of(background));
}

/// A premultiplied picture over the viewport, whose lower left corner is at (x, y).
void GlRenderer::lay_over(GLuint texture, int x, int y) {
  programs_.composite.use();
  programs_.composite.set("u_layer", 0);
  programs_.composite.set("u_corner", static_cast<float>(x), static_cast<float>(y));
  gl().BindTexture(GL_TEXTURE_2D, texture);
  nothing_.draw_without_vertices(GL_TRIANGLES, 3);
}

void GlRenderer::average() {
  canvas().picture.bind();
  gl().Disable(GL_BLEND);
  programs_.average.use();
  programs_.average.set("u_fine", 0);
  programs_.average.set("u_fineness", canvas().quality.supersampling);
  gl().BindTexture(GL_TEXTURE_2D, canvas().fine->texture());
  nothing_.draw_without_vertices(GL_TRIANGLES, 3);
  gl().Enable(GL_BLEND);
}

/// Colours are premultiplied.
void GlRenderer::start() {
  gl().Enable(GL_BLEND);
  gl().BlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

/// Into the picture of the first canvas.
void GlRenderer::draw_figure(const Figure& figure, const Background& background) {
  start();
  draw_layer(figure);
  gl().Disable(GL_DEPTH_TEST);
  draw_picture(figure, background);
}

Result<Image> GlRenderer::draw(const Figure& figure, Size size, const Background& background,
                               const Quality& quality) {
  if (Status ready = prepare(size, quality); !ready) return failure(ready.error());
  draw_figure(figure, background);
  return read_picture(canvas().picture, background);
}

/// Over what is on the page.
Status GlRenderer::draw_inset(const Inset& inset) {
  const PixelRect& at = inset.place;
  if (Status ready = prepare({at.width, at.height}, inset.quality); !ready) return failure(ready.error());
  draw_figure(inset.figure, inset.background);
  const int bottom = page_->size().height - at.y - at.height;
  if (inset.background.kind != Background::Kind::transparent) {
    canvas().picture.copy_to(*page_, at.x, bottom);
    return success();
  }
  page_->bind();
  gl().Viewport(at.x, bottom, at.width, at.height);
  lay_over(canvas().picture.texture(), at.x, bottom);
  return success();
}

Result<Image> GlRenderer::draw(const Sheet& sheet, std::span<const Inset> insets, Size size,
                               const Background& background) {
  if (!page_ || page_->size() != size) {
    page_.reset();
    auto page = Framebuffer::create(gl(), size, 0);
    if (!page) return failure(page.error());
    page_ = std::move(page).value();
  }
  start();
  gl().Disable(GL_DEPTH_TEST);
  page_->bind();
  clear(background);
  if (background.kind == Background::Kind::studio) draw_studio({0, 0, size.width, size.height}, 1);
  flat_.sheet->draw(sheet.shapes, size);
  for (const Inset& inset : insets)
    if (Status drawn = draw_inset(inset); !drawn) return failure(drawn.error());
  page_->bind();
  flat_.sheet->draw(sheet.over_insets, size);
  flat_.type->draw(sheet.texts, size);
  return read_picture(*page_, background);
}

Result<Image> GlRenderer::read_picture(const Framebuffer& picture, const Background& background) {
  Image image = picture.read();
  if (const std::string errors = pending_errors(gl()); !errors.empty())
    return failure("OpenGL reported " + errors + " while drawing; driver: " + driver());
  if (background.kind == Background::Kind::transparent) remove_premultiplication(image);
  return image;
}

Result<std::unique_ptr<Renderer>> GlRenderer::create(const Gl& table) {
  auto gl = std::make_unique<const Gl>(table);
  auto backdrop = Program::create(*gl, "backdrop", shaders::kScreenVert, shaders::kBackdropFrag);
  if (!backdrop) return failure(backdrop.error());
  auto floor = Program::create(*gl, "floor", shaders::kRectangleVert, shaders::kFloorFrag);
  if (!floor) return failure(floor.error());
  auto glass = Program::create(*gl, "glass", shaders::kRectangleVert, shaders::kGlassFrag);
  if (!glass) return failure(glass.error());
  auto tube = Program::create(*gl, "tube", shaders::kTubeVert, shaders::kTubeFrag);
  if (!tube) return failure(tube.error());
  auto mesh = Program::create(*gl, "mesh", shaders::kMeshVert, shaders::kMeshFrag);
  if (!mesh) return failure(mesh.error());
  auto composite = Program::create(*gl, "composite", shaders::kScreenVert, shaders::kCompositeFrag);
  if (!composite) return failure(composite.error());
  auto average = Program::create(*gl, "average", shaders::kScreenVert, shaders::kAverageFrag);
  if (!average) return failure(average.error());
  auto opened = Fonts::open();
  if (!opened) return failure(opened.error());
  auto fonts = std::make_unique<const Fonts>(std::move(opened).value());
  auto type = GlyphPass::create(*gl, *fonts);
  if (!type) return failure(type.error());
  auto flat = FlatPass::create(*gl, **type, *fonts);
  if (!flat) return failure(flat.error());
  auto sheet = SheetPass::create(*gl);
  if (!sheet) return failure(sheet.error());
  FlatPasses passes{std::move(fonts), std::move(type).value(), std::move(flat).value(),
                    std::move(sheet).value()};
  Programs programs{std::move(backdrop).value(), std::move(floor).value(), std::move(glass).value(),
                    std::move(tube).value(),     std::move(mesh).value(),  std::move(composite).value(),
                    std::move(average).value()};
  return std::unique_ptr<Renderer>(new GlRenderer(std::move(gl), std::move(programs), std::move(passes)));
}

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
  if (text.size() != 7 || text[0] != '#') return std::nullopt;
  const int r = hex_pair(text.substr(1, 2)), g = hex_pair(text.substr(3, 2)), b = hex_pair(text.substr(5, 2));
  if (r < 0 || g < 0 || b < 0) return std::nullopt;
  return Background{Kind::color, color_from_hex(static_cast<unsigned>(r << 16 | g << 8 | b))};
}

Result<std::unique_ptr<Renderer>> Renderer::create(const GlContext& context) {
  auto gl = Gl::load(context);
  if (!gl) return failure(gl.error());
  return GlRenderer::create(*gl);
}

}  // namespace polhode
