// SPDX-License-Identifier: MIT
// Golden images at 480x270, by the golden rule of render/image/compare.h, each proved able to fail.
// POLHODE_REMAKE="name name ..." (or "all") rewrites goldens instead of comparing them.
#include "render/image/compare.h"
#include "render/image/png.h"
#include "tests/golden/scenes.h"
#include "tests/scene/plot_examples.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

namespace polhode::golden {
namespace {

namespace fs = std::filesystem;

constexpr Size kSize{480, 270};
const fs::path kFolder = fs::path(POLHODE_SOURCE_DIR) / "tests/golden";
const fs::path kFailed = fs::path(POLHODE_SOURCE_DIR) / "out/check";

/// One context and renderer for all tests of this process. CMake sets GALLIUM_OVERRIDE_CPU_CAPS=sse4.1, which
/// puts every x86 machine into one class of pixels.
struct Stage {
  std::unique_ptr<GlContext> context;
  std::unique_ptr<Renderer> renderer;
};
Stage& stage() {
  static Stage made = [] {
    auto context = open_context(ContextKind::any);
    if (!context) throw std::runtime_error(context.error());
    auto renderer = Renderer::create(**context);
    if (!renderer) throw std::runtime_error(renderer.error());
    return Stage{std::move(context).value(), std::move(renderer).value()};
  }();
  return made;
}

/// "Mesa 22.3.6" of "llvmpipe (LLVM 15.0.6, 128 bits); 4.5 (Core Profile) Mesa 22.3.6".
std::string mesa_of(const std::string& driver) {
  const auto at = driver.rfind("Mesa ");
  return at == std::string::npos ? driver : driver.substr(at);
}

std::string recorded_mesa() {
  std::ifstream file(kFolder / "DRIVER");
  std::string line;
  std::getline(file, line);
  return mesa_of(line);
}

/// A transparent picture as it shows on a violet slide. Straight colours of nearly transparent pixels say
/// little: a rounding of one level at alpha 2 changes them by 127.
void lay_over_violet(Image& image) {
  constexpr int kViolet[] = {192, 64, 192};
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    const int a = image.rgba[i + 3];
    for (std::size_t k = 0; k < 3; ++k)
      image.rgba[i + k] =
          static_cast<std::uint8_t>((image.rgba[i + k] * a + kViolet[k] * (255 - a) + 127) / 255);
    image.rgba[i + 3] = 255;
  }
}

Image draw(const Figure& figure, const std::string& background) {
  auto image = stage().renderer->draw(figure, kSize, background_from(background).value());
  if (!image) throw std::runtime_error(image.error());
  if (background == "transparent") lay_over_violet(*image);
  return std::move(image).value();
}

constexpr double kAspect = static_cast<double>(kSize.width) / kSize.height;

Image picture(const Golden& golden) {
  const SceneModel model = make_model(golden.scene);
  return draw(make_figure(model, golden.scene.at_s, kAspect), golden.background);
}

/// A colour of the middle of the list, turned by exchanging red and blue.
void change_one_color(Figure& figure) {
  DrawList& list = figure.panes.front().list;
  Color* color = !list.arrows.empty()  ? &list.arrows.back().color
                 : !list.tubes.empty() ? &list.tubes.back().color
                                       : &list.meshes.front().color;
  *color = Color{color->b, color->r * 0.5F, color->r, color->a};
}

Image mutated(const Golden& golden, Mutation mutation) {
  Scene scene = golden.scene;
  double t_s = scene.at_s;
  constexpr double kHalfDegree = 0.5 * 3.14159265358979 / 180.0;
  switch (mutation) {
    case Mutation::later:
      t_s += make_model(scene).rate / 25.0;
      break;  // a film of 25 frames a second
    case Mutation::camera:
      scene.camera.azimuth_rad += kHalfDegree;
      break;
    case Mutation::overlay:
      scene.show.erase(golden.removed);
      break;
    case Mutation::attitude:
      scene.attitude = make_model(scene).q0_SB.conjugate();
      break;
    case Mutation::color:
      break;
  }
  const SceneModel model = make_model(scene);
  Figure figure = make_figure(model, t_s, kAspect);
  if (mutation == Mutation::color) change_one_color(figure);
  return draw(figure, golden.background);
}

const Exception* exception_of(const Golden& golden, Mutation mutation) {
  for (const Exception& e : golden.cannot)
    if (e.mutation == mutation) return &e;
  return nullptr;
}

bool to_remake(const std::string& name) {
  const char* names = std::getenv("POLHODE_REMAKE");
  if (names == nullptr) return false;
  std::istringstream words(names);
  for (std::string word; words >> word;)
    if (word == name || word == "all") return true;
  return false;
}

void keep_evidence(const std::string& name, const Image& want, const Image& got) {
  fs::create_directories(kFailed);
  EXPECT_TRUE(write_png(kFailed / (name + "-want.png"), want, {}).ok());
  EXPECT_TRUE(write_png(kFailed / (name + "-got.png"), got, {}).ok());
  EXPECT_TRUE(write_png(kFailed / (name + "-diff.png"), difference_image(want, got), {}).ok());
}

/// By the golden rule; rewrites the golden if asked to.
void expect_as_approved(const std::string& name, const Image& got) {
  EXPECT_FALSE(is_blank(got));
  const fs::path path = kFolder / (name + ".png");
  if (to_remake(name)) {
    ASSERT_TRUE(write_png(path, got, {}).ok());
    std::ofstream(kFolder / "DRIVER") << stage().renderer->driver() << '\n';
    GTEST_SKIP() << "remade " << path;
  }
  const std::string driver = stage().renderer->driver();
  if (mesa_of(driver) != recorded_mesa())
    GTEST_SKIP() << "goldens were made on " << recorded_mesa() << ", this is " << driver;

  const auto want = read_png(path);
  ASSERT_TRUE(want.ok()) << want.error();
  const Comparison c = compare_images(want->image, got);
  if (!c.equal()) keep_evidence(name, want->image, got);
  EXPECT_TRUE(c.equal()) << name << ": " << c.over_3 << " of " << c.pixels << " pixels off by more than "
                         << kGoldenLevels << " levels, at most " << c.max << "; see out/check/" << name
                         << "-*.png; driver " << driver;
}

class GoldenImage : public testing::TestWithParam<Golden> {};

TEST_P(GoldenImage, IsAsApproved) { expect_as_approved(GetParam().name, picture(GetParam())); }

TEST_P(GoldenImage, RefusesEveryMutationThatCanChangeIt) {
  const Golden& golden = GetParam();
  const Image approved = picture(golden);
  for (Mutation mutation : kMutations) {
    const bool refused = !compare_images(approved, mutated(golden, mutation)).equal();
    const Exception* exception = exception_of(golden, mutation);
    EXPECT_NE(refused, exception != nullptr)
        << golden.name << ": " << name_of(mutation)
        << (exception ? " was named as impossible: " + exception->why : "");
  }
}

TEST_P(GoldenImage, RepeatsToTheByte) {
  const Image first = picture(GetParam());
  EXPECT_EQ(first.rgba, picture(GetParam()).rgba);
}

INSTANTIATE_TEST_SUITE_P(All, GoldenImage, testing::ValuesIn(all()), [](const auto& row) {
  std::string name = row.param.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST(Goldens, EveryMutationIsRefusedByTenOrMore) {
  std::map<Mutation, int> refused;
  for (const Golden& golden : all())
    for (Mutation mutation : kMutations)
      if (exception_of(golden, mutation) == nullptr) ++refused[mutation];  // each proved by the test above
  for (Mutation mutation : kMutations) EXPECT_GE(refused[mutation], 10) << name_of(mutation);
}

constexpr Size kPlotSize{960, 540};
constexpr const char* kPlotName = "work-precision";

Image plot_picture(const WorkPrecisionPlot& plot) {
  const Sheet sheet = lay_out(plot, kPlotSize.width, kPlotSize.height, stage().renderer->fonts());
  auto image = stage().renderer->draw(sheet, kPlotSize, background_from("paper").value());
  if (!image) throw std::runtime_error(image.error());
  return std::move(image).value();
}

TEST(GoldenPlot, IsAsApproved) { expect_as_approved(kPlotName, plot_picture(ladder_plot())); }

TEST(GoldenPlot, RefusesEveryMutation) {
  const Image approved = plot_picture(ladder_plot());
  const auto refused = [&](const char* what, auto change) {
    WorkPrecisionPlot plot = ladder_plot();
    change(plot);
    EXPECT_FALSE(compare_images(approved, plot_picture(plot)).equal()) << what;
  };
  refused("one error a tenth larger", [](auto& p) { p.series[2].points[3].second *= 1.1; });
  refused("one curve removed", [](auto& p) { p.series.erase(p.series.begin() + 4); });
  refused("one curve of another family", [](auto& p) { p.series[8].look = PlotLook::orange; });
  refused("one curve quieter", [](auto& p) { p.series[9].emphasized = false; });
  refused("one letter changed", [](auto& p) { p.series[2].label = "RK5"; });
  refused("a tolerance a tenth larger", [](auto& p) { *p.tolerance *= 1.1; });
  refused("nothing recommended", [](auto& p) { p.recommended.reset(); });
  refused("the exact motion off by nothing", [](auto& p) { p.series.back().points[0].second = 0.0; });
}

TEST(GoldenPlot, RepeatsToTheByte) {
  EXPECT_EQ(plot_picture(ladder_plot()).rgba, plot_picture(ladder_plot()).rgba);
}

TEST(Goldens, NoFileIsWithoutItsRow) {
  std::set<std::string> names = {std::string(kPlotName) + ".png"};
  for (const Golden& golden : all()) names.insert(golden.name + ".png");
  for (const auto& entry : fs::directory_iterator(kFolder))
    EXPECT_TRUE(entry.path().extension() != ".png" || names.contains(entry.path().filename().string()))
        << entry.path();
}

}  // namespace
}  // namespace polhode::golden
