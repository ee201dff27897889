// SPDX-License-Identifier: MIT
// What a frame costs: CPU ms of all threads (column CPU) beside wall time, for the Poinsot scene with labels
// and a moving camera. BM_Frame is the one that counts: picture and PNG together, at most 65 ms of CPU at
// 1080p.
#include "app/export/picture_writer.h"
#include "render/figure/make_figure.h"
#include "render/gl/framebuffer.h"
#include "render/gl/renderer.h"
#include "render/image/png.h"
#include "render/typeset/paragraph.h"
#include "tests/bench/poinsot_scene.h"

#include <benchmark/benchmark.h>
#include <png.h>
#include <unistd.h>

#include <filesystem>
#include <stdexcept>

namespace polhode {
namespace {

using bench::poinsot_scene;
constexpr double kAspect = 16.0 / 9.0;

/// One context for all benchmarks of the process.
struct Studio {
  Fonts fonts = Fonts::open().value();
  std::unique_ptr<GlContext> context;
  std::unique_ptr<Renderer> renderer;

  Studio() {
    auto opened = open_context(ContextKind::any);
    if (!opened) throw std::runtime_error(opened.error());
    context = std::move(opened).value();
    auto made = Renderer::create(*context, fonts);
    if (!made) throw std::runtime_error(made.error());
    renderer = std::move(made).value();
  }
};
Studio& studio() {
  static Studio made;
  return made;
}

/// A fresh one, removed with what it holds.
struct Folder {
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("polhode-bench-" + std::to_string(::getpid()));
  Folder() { std::filesystem::create_directory(path); }
  ~Folder() { std::filesystem::remove_all(path); }
};

Size size_of(const benchmark::State& state) {
  const auto height = static_cast<int>(state.range(0));
  return {height * 16 / 9, height};
}

Image draw(const SceneModel& model, double t_s, Size size, const Quality& quality = {}) {
  auto image = studio().renderer->draw(make_figure(model, t_s, kAspect), size, {}, quality);
  if (!image) throw std::runtime_error(image.error());
  return std::move(image).value();
}

/// Picture and PNG, as `export --png fast` makes them; the camera moves.
void make_frames(benchmark::State& state, const Quality& quality, const Scene& scene = poinsot_scene()) {
  SceneModel model = make_model(scene);
  const Size size = size_of(state);
  PngEncoder encoder(PngPacking::fast);
  draw(model, 0.0, size, quality);  // shaders and buffers
  double t_s = 0.0;
  for (auto _ : state) {
    t_s += model.rate / 25.0;
    model.scene.camera.azimuth_rad += 0.01;
    benchmark::DoNotOptimize(encoder.encode(draw(model, t_s, size, quality), {}));
  }
}
void BM_Frame(benchmark::State& state) { make_frames(state, {}); }
/// With what a lesson has beyond it: ticks of rolling. At most 1.3 times as much.
void BM_FrameOfRolling(benchmark::State& state) {
  Scene scene = poinsot_scene();
  scene.show.insert(Overlay::rolling_ticks);
  make_frames(state, {}, scene);
}
/// With walls that stand on the plane. At most 1.2 times as much.
void BM_FrameInRoom(benchmark::State& state) {
  Scene scene = poinsot_scene();
  scene.show.insert(Overlay::room);
  make_frames(state, {}, scene);
}
/// The same as `export` does it: the picture before is packed and written in a second thread.
void BM_Film(benchmark::State& state) {
  SceneModel model = make_model(poinsot_scene());
  const Size size = size_of(state);
  draw(model, 0.0, size);
  const Folder folder;
  PictureWriter writer(folder.path, PngPacking::fast, Durability::rename_only);
  double t_s = 0.0;
  for (auto _ : state) {
    t_s += model.rate / 25.0;
    model.scene.camera.azimuth_rad += 0.01;
    if (!writer.put({"frame.png", draw(model, t_s, size), {}}))
      throw std::runtime_error("a frame cannot be written");
  }
  if (!writer.finish()) throw std::runtime_error("the frames cannot be written");
}
/// The common way: all by samples and a depth buffer.
void BM_FrameMsaa4(benchmark::State& state) { make_frames(state, {.samples = 4, .soft_lines = false}); }

void BM_Draw(benchmark::State& state) {
  const SceneModel model = make_model(poinsot_scene());
  const Size size = size_of(state);
  draw(model, 0.0, size);
  for (auto _ : state) benchmark::DoNotOptimize(draw(model, 1.1, size));
}

/// As libpng writes rows that it filters and packs by its default settings.
std::size_t bytes_by_default(const std::vector<std::uint8_t>& rgb, Size size) {
  png_image form{};
  form.version = PNG_IMAGE_VERSION;
  form.format = PNG_FORMAT_RGB;
  form.width = static_cast<png_uint_32>(size.width);
  form.height = static_cast<png_uint_32>(size.height);
  std::vector<std::uint8_t> bytes(rgb.size());
  png_alloc_size_t count = bytes.size();
  if (!png_image_write_to_memory(&form, bytes.data(), &count, 0, rgb.data(), 0, nullptr))
    throw std::runtime_error(form.message);
  return count;
}

/// Second argument: 0 fast, 1 small, 2 libpng's default. Counter: size against the last.
void BM_Png(benchmark::State& state) {
  const Image image = draw(make_model(poinsot_scene()), 1.1, size_of(state));
  std::vector<std::uint8_t> rgb;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4)
    rgb.insert(rgb.end(), &image.rgba[i], &image.rgba[i] + 3);
  PngEncoder encoder(state.range(1) == 1 ? PngPacking::small : PngPacking::fast);
  std::size_t bytes = 0;
  for (auto _ : state)
    bytes = state.range(1) == 2 ? bytes_by_default(rgb, image.size) : encoder.encode(image, {})->size();
  state.counters["of_default"] =
      static_cast<double>(bytes) / static_cast<double>(bytes_by_default(rgb, image.size));
}

/// The floor under every frame: clear, resolve, read back.
void BM_ClearResolveRead(benchmark::State& state) {
  const Gl gl = Gl::load(*studio().context).value();
  const Framebuffer framebuffer =
      Framebuffer::create(gl, size_of(state), static_cast<int>(state.range(1))).value();
  for (auto _ : state) {
    framebuffer.bind();
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    framebuffer.resolve();
    benchmark::DoNotOptimize(framebuffer.read());
  }
}

/// What no frame can do without: clear, read back, and the PNG of a frame.
void BM_ClearReadPng(benchmark::State& state) {
  const Gl gl = Gl::load(*studio().context).value();
  const Framebuffer framebuffer = Framebuffer::create(gl, size_of(state), 0).value();
  const Image frame = draw(make_model(poinsot_scene()), 1.1, size_of(state));
  PngEncoder encoder(PngPacking::fast);
  for (auto _ : state) {
    framebuffer.bind();
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    benchmark::DoNotOptimize(framebuffer.read());
    benchmark::DoNotOptimize(encoder.encode(frame, {}));
  }
}

/// Some 700 glyphs of text with a panel, laid out anew, as the page of a lesson has them beside its figure.
Sheet text_page() {
  std::string words;
  for (int i = 0; i < 4; ++i)
    words +=
        "The tensor changes as the body turns, so we write the rate of change with axes that turn with the "
        "body. A vector's rate in the fixed frame is its rate in the turning frame plus the turn itself. ";
  TextSpan span;
  span.source = {0, static_cast<std::uint32_t>(words.size())};
  span.text = std::move(words);
  TextStyle style;
  style.size = 23;
  style.width = 640;
  Sheet sheet;
  sheet.shapes.push_back(Area{{{60, 500}, {700, 500}, {700, 590}, {60, 590}}, color_from_hex(0xF3EEDF)});
  sheet.texts.push_back(
      {.list = set_text({{0, "", {span}}}, style, studio().renderer->fonts()).value(), .at = {72, 120}});
  return sheet;
}

/// 0: text alone, on paper; 1: the same without a background; 2: with a figure, to be compared with
/// BM_Figure.
void BM_Page(benchmark::State& state) {
  const Background background = background_from(state.range(0) == 1 ? "transparent" : "paper").value();
  std::vector<Inset> insets;
  if (state.range(0) == 2)
    insets.push_back(
        {make_figure(make_model(poinsot_scene()), 1.1, 820.0 / 640.0), {780, 0, 820, 640}, {}, {}});
  const auto draw_page = [&] {
    return studio().renderer->draw(text_page(), insets, {1600, 1000}, background).value();
  };
  draw_page();  // shaders and buffers
  for (auto _ : state) benchmark::DoNotOptimize(draw_page());
}

void BM_Figure(benchmark::State& state) {
  const Figure figure = make_figure(make_model(poinsot_scene()), 1.1, 820.0 / 640.0);
  for (auto _ : state) benchmark::DoNotOptimize(studio().renderer->draw(figure, {820, 640}, {}).value());
}

/// A page whose glyphs were never seen: each turn at another size.
void BM_PageOfNewGlyphs(benchmark::State& state) {
  double more = 0.0;
  for (auto _ : state) {
    Sheet sheet = text_page();
    more += 1.0 / 64.0;
    for (Glyph& glyph : sheet.texts[0].list.glyphs) glyph.size += more;
    benchmark::DoNotOptimize(
        studio().renderer->draw(sheet, {1600, 1000}, background_from("paper").value()).value());
  }
}

void BM_MakeModel(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(make_model(poinsot_scene()));
}

void BM_MakeFigure(benchmark::State& state) {
  const SceneModel model = make_model(poinsot_scene());
  double t_s = 0.0;
  for (auto _ : state)
    benchmark::DoNotOptimize(make_figure(model, t_s = t_s < 2.0 ? t_s + 0.01 : 0.0, kAspect));
}

constexpr auto kMs = benchmark::kMillisecond;
BENCHMARK(BM_Frame)->Arg(720)->Arg(1080)->Arg(2160)->MeasureProcessCPUTime()->UseRealTime()->Unit(kMs);
BENCHMARK(BM_FrameOfRolling)->Arg(1080)->MeasureProcessCPUTime()->UseRealTime()->Unit(kMs);
BENCHMARK(BM_FrameInRoom)->Arg(1080)->MeasureProcessCPUTime()->UseRealTime()->Unit(kMs);
BENCHMARK(BM_Film)->Arg(1080)->MeasureProcessCPUTime()->UseRealTime()->Unit(kMs);
BENCHMARK(BM_FrameMsaa4)->Arg(1080)->MeasureProcessCPUTime()->UseRealTime()->Unit(kMs);
BENCHMARK(BM_ClearReadPng)->Arg(1080)->MeasureProcessCPUTime()->UseRealTime()->Unit(kMs);
BENCHMARK(BM_Draw)->Arg(1080)->MeasureProcessCPUTime()->UseRealTime()->Unit(kMs);
BENCHMARK(BM_Png)->ArgsProduct({{1080}, {0, 1, 2}})->MeasureProcessCPUTime()->UseRealTime()->Unit(kMs);
BENCHMARK(BM_ClearResolveRead)
    ->Args({1080, 0})
    ->Args({1080, 4})
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(kMs);
BENCHMARK(BM_Page)->DenseRange(0, 2)->MeasureProcessCPUTime()->UseRealTime()->Unit(kMs);
BENCHMARK(BM_Figure)->MeasureProcessCPUTime()->UseRealTime()->Unit(kMs);
BENCHMARK(BM_PageOfNewGlyphs)->MeasureProcessCPUTime()->UseRealTime()->Unit(kMs);
BENCHMARK(BM_MakeModel)->Unit(kMs);
BENCHMARK(BM_MakeFigure)->Unit(kMs);

}  // namespace
}  // namespace polhode
