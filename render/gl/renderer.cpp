// SPDX-License-Identifier: MIT
#include "render/gl/renderer.h"

#include "render/gl/framebuffer.h"
#include "render/gl/passes/figure_pass.h"
#include "render/gl/passes/flat_pass.h"
#include "render/gl/passes/sheet_pass.h"
#include "render/gl/shader.h"
#include "render/gl/shader_sources.h"
#include "render/gl/stream.h"
#include "render/palette.h"

#include <algorithm>
#include <cmath>
#include <list>

namespace polhode {
namespace {

/// Meshes need depth and samples; the common way does everywhere.
bool needs_layer(const Figure& figure, const Quality& quality) {
  return !quality.soft_lines || std::any_of(figure.panes.begin(), figure.panes.end(),
                                            [](const Pane& pane) { return !pane.list.meshes.empty(); });
}

/// What a figure is drawn in. `fine` is what is averaged into the picture; nothing without supersampling.
struct Canvas {
  Size size;
  Quality quality;
  std::optional<Framebuffer> layer;  ///< of figures that need one
  std::optional<Framebuffer> fine;
  Framebuffer picture;
};

Size fine_size(const Canvas& canvas) {
  return {canvas.size.width * canvas.quality.supersampling,
          canvas.size.height * canvas.quality.supersampling};
}

double pixels_of(const Canvas& canvas) {
  double pixels = 0.0;
  const auto add = [&](const Framebuffer& f) {
    pixels += (1.0 + 2.0 * f.samples()) * f.size().width * f.size().height;
  };
  add(canvas.picture);
  if (canvas.layer) add(*canvas.layer);
  if (canvas.fine) add(*canvas.fine);
  return pixels;
}

class GlRenderer final : public Renderer {
 public:
  static Result<std::unique_ptr<Renderer>> create(const Gl& gl, const Fonts& fonts);

  Result<Image> draw(const Figure& figure, Size size, const Background& background,
                     const Quality& quality) override;
  Result<Image> draw(const Sheet& sheet, std::span<const Inset> insets, Size size,
                     const Background& background) override;
  Status paint(const Sheet& sheet, std::span<const Inset> insets, const Background& background,
               const Framebuffer& page) override;
  const Fonts& fonts() const override { return fonts_; }
  int most_samples() const override { return limits(gl()).samples; }
  std::string driver() const override { return driver_name(gl()); }

 private:
  struct Passes {
    std::unique_ptr<FigurePass> figure;
    std::unique_ptr<GlyphPass> type;
    std::unique_ptr<FlatPass> flat;
    std::unique_ptr<SheetPass> sheet;
    Program average;
  };
  // The table lives on the heap because programs and streams keep a reference to it.
  GlRenderer(std::unique_ptr<const Gl> gl, const Fonts& fonts, Passes passes)
      : gl_(std::move(gl)), fonts_(fonts), passes_(std::move(passes)), nothing_(*gl_, {}) {}

  const Gl& gl() const { return *gl_; }
  const Canvas& canvas() const { return canvases_.front(); }
  Status prepare(const Figure& figure, Size size, const Quality& quality);
  Status find_canvas(Size size, const Quality& quality);
  void forget_canvases();
  void start();
  void draw_space(const Figure& figure, const Background& background);
  void draw_figure(const Figure& figure, const Background& background);
  Status draw_inset(const Inset& inset, const Framebuffer& page);
  Result<Image> read_picture(const Framebuffer& picture, const Background& background);
  void average();

  std::unique_ptr<const Gl> gl_;
  const Fonts& fonts_;
  Passes passes_;
  VertexStream nothing_;
  std::list<Canvas> canvases_;  ///< the one in use first
  std::optional<Framebuffer> page_;
};

void remove_premultiplication(Image& image) {
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    const int a = image.rgba[i + 3];
    if (a == 0 || a == 255) continue;
    for (std::size_t k = 0; k < 3; ++k)
      image.rgba[i + k] = static_cast<std::uint8_t>(std::min(255, (image.rgba[i + k] * 255 + a / 2) / a));
  }
}

/// Puts a canvas of this size and quality first. Some are kept, because figures of a few sizes take turns in
/// the pages of a film.
Status GlRenderer::find_canvas(Size size, const Quality& quality) {
  const auto found = std::find_if(canvases_.begin(), canvases_.end(),
                                  [&](const Canvas& c) { return c.size == size && c.quality == quality; });
  if (found != canvases_.end()) {
    canvases_.splice(canvases_.begin(), canvases_, found);
    return success();
  }
  forget_canvases();
  auto picture = Framebuffer::create(gl(), size, 0);
  if (!picture) return failure(picture.error());
  Canvas made{size, quality, std::nullopt, std::nullopt, std::move(picture).value()};
  if (quality.supersampling > 1) {
    auto fine = Framebuffer::create(gl(), fine_size(made), 0);
    if (!fine) return failure(fine.error());
    made.fine = std::move(fine).value();
  }
  canvases_.push_front(std::move(made));
  return success();
}

/// The last used go first, until there is room for more.
void GlRenderer::forget_canvases() {
  constexpr double kKept = 64e6;  // pixels; a page at 3840 x 2160 and its figures
  double total = 0.0;
  for (const Canvas& c : canvases_) total += pixels_of(c);
  for (; total > kKept; canvases_.pop_back()) total -= pixels_of(canvases_.back());
}

Status GlRenderer::prepare(const Figure& figure, Size size, const Quality& quality) {
  if (quality.supersampling < 1)
    return failure("A picture cannot have less than one pixel for each of its own.");
  if (quality.samples < 0 || quality.samples > most_samples())
    return failure("This OpenGL driver has at most " + std::to_string(most_samples()) + " samples a pixel.");
  if (Status found = find_canvas(size, quality); !found) return found;
  Canvas& made = canvases_.front();
  if (made.layer || !needs_layer(figure, quality)) return success();
  auto layer = Framebuffer::create(gl(), fine_size(made), quality.samples);
  if (!layer) return failure(layer.error());
  made.layer = std::move(layer).value();
  return success();
}

void GlRenderer::average() {
  canvas().picture.bind();
  gl().Disable(GL_BLEND);
  passes_.average.use();
  passes_.average.set("u_fine", 0);
  passes_.average.set("u_fineness", canvas().quality.supersampling);
  gl().BindTexture(GL_TEXTURE_2D, canvas().fine->texture());
  nothing_.draw_without_vertices(GL_TRIANGLES, 3);
  gl().Enable(GL_BLEND);
}

/// Colours are premultiplied.
void GlRenderer::start() {
  gl().Enable(GL_BLEND);
  gl().Disable(GL_DEPTH_TEST);
  gl().BlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

/// Into the picture of the first canvas, all but what is written.
void GlRenderer::draw_space(const Figure& given, const Background& background) {
  const bool is_on_dark = is_dark(halo_of(background));
  const Figure lightened = is_on_dark ? on_dark_ground(given) : Figure{};
  const Figure& figure = is_on_dark ? lightened : given;
  start();
  const Canvas& on = canvas();
  const Framebuffer& drawn = on.fine ? *on.fine : on.picture;
  const int fineness = on.quality.supersampling;
  if (on.quality.soft_lines) {
    const bool layered = needs_layer(figure, on.quality);
    passes_.figure->draw(figure, background, fineness, drawn, layered ? &*on.layer : nullptr);
  } else {
    passes_.figure->draw_by_samples(figure, background, fineness, *on.layer);
    on.layer->resolve();
    on.layer->copy_to(drawn, 0, 0);
  }
  if (on.fine) average();
}

void GlRenderer::draw_figure(const Figure& figure, const Background& background) {
  draw_space(figure, background);
  canvas().picture.bind();
  passes_.flat->draw(figure, canvas().size, halo_of(background));
}

Result<Image> GlRenderer::draw(const Figure& figure, Size size, const Background& background,
                               const Quality& quality) {
  if (Status ready = prepare(figure, size, quality); !ready) return failure(ready.error());
  draw_figure(figure, background);
  return read_picture(canvas().picture, background);
}

Size drawn_size(const Inset& inset) {
  const auto drawn = [&](int side) { return static_cast<int>(std::ceil(inset.resolution * side)); };
  return {drawn(inset.place.width), drawn(inset.place.height)};
}

/// Over what is on the page.
Status GlRenderer::draw_inset(const Inset& inset, const Framebuffer& page) {
  const PixelRect& at = inset.place;
  if (Status ready = prepare(inset.figure, drawn_size(inset), inset.quality); !ready)
    return failure(ready.error());
  const bool is_enlarged = inset.resolution < 1;
  if (is_enlarged)
    draw_space(inset.figure, inset.background);
  else
    draw_figure(inset.figure, inset.background);
  const int bottom = page.size().height - at.y - at.height;
  const auto on_page = [&] {
    page.bind();
    gl().Viewport(at.x, bottom, at.width, at.height);
  };
  if (inset.background.kind != Background::Kind::transparent) {
    canvas().picture.copy_to(page, at.x, bottom, {at.width, at.height});
  } else {
    on_page();
    passes_.figure->lay_over(canvas().picture, at.x, bottom);
  }
  if (is_enlarged) {
    on_page();
    passes_.flat->draw(inset.figure, {at.width, at.height}, halo_of(inset.background));
  }
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
  if (Status painted = paint(sheet, insets, background, *page_); !painted) return failure(painted.error());
  return read_picture(*page_, background);
}

Status GlRenderer::paint(const Sheet& sheet, std::span<const Inset> insets, const Background& background,
                         const Framebuffer& page) {
  const Size size = page.size();
  start();
  const Figure nothing{{Pane{}}, 0};  // the background alone
  passes_.figure->draw(nothing, background, 1, page, nullptr);
  passes_.sheet->draw(sheet.shapes, size);
  for (const Inset& inset : insets)
    if (Status drawn = draw_inset(inset, page); !drawn) return drawn;
  page.bind();
  passes_.sheet->draw(sheet.over_insets, size);
  passes_.type->draw(sheet.texts, size);
  return success();
}

Result<Image> GlRenderer::read_picture(const Framebuffer& picture, const Background& background) {
  Image image = picture.read();
  if (const std::string errors = pending_errors(gl()); !errors.empty())
    return failure("OpenGL reported " + errors + " while drawing; driver: " + driver());
  if (background.kind == Background::Kind::transparent) remove_premultiplication(image);
  return image;
}

Result<std::unique_ptr<Renderer>> GlRenderer::create(const Gl& table, const Fonts& fonts) {
  auto gl = std::make_unique<const Gl>(table);
  auto average = Program::create(*gl, "average", {shaders::kScreenVert}, {shaders::kAverageFrag});
  if (!average) return failure(average.error());
  auto figure = FigurePass::create(*gl);
  if (!figure) return failure(figure.error());
  auto type = GlyphPass::create(*gl, fonts);
  if (!type) return failure(type.error());
  auto flat = FlatPass::create(*gl, **type, fonts);
  if (!flat) return failure(flat.error());
  auto sheet = SheetPass::create(*gl);
  if (!sheet) return failure(sheet.error());
  Passes passes{std::move(figure).value(), std::move(type).value(), std::move(flat).value(),
                std::move(sheet).value(), std::move(average).value()};
  return std::unique_ptr<Renderer>(new GlRenderer(std::move(gl), fonts, std::move(passes)));
}

}  // namespace

Result<std::unique_ptr<Renderer>> Renderer::create(const GlContext& context, const Fonts& fonts) {
  auto gl = Gl::load(context);
  if (!gl) return failure(gl.error());
  return GlRenderer::create(*gl, fonts);
}

}  // namespace polhode
