// SPDX-License-Identifier: MIT
// Golden images at 480x270, by the golden rule of render/image/compare.h, each proved able to fail.
#include "render/figure/make_figure.h"
#include "render/image/compare.h"
#include "tests/golden/approval.h"
#include "tests/golden/scenes.h"
#include "tests/render/drawing/plots/plot_examples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

namespace polhode::golden {
namespace {

namespace fs = std::filesystem;

constexpr Size kSize{480, 270};

Image draw(const Figure& figure, const std::string& background) {
  auto image = renderer().draw(figure, kSize, background_from(background).value());
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

TEST(GoldenMarks, RefuseThatAnyOfThemIsMissing) {
  const std::vector<Golden> goldens = all();
  const auto golden =
      std::find_if(goldens.begin(), goldens.end(), [](const Golden& g) { return !g.scene.marks.empty(); });
  ASSERT_NE(golden, goldens.end());
  const Image approved = picture(*golden);
  const auto refused = [&](const char* what, auto change) {
    Golden changed = *golden;
    change(changed.scene.marks);
    EXPECT_FALSE(compare_images(approved, picture(changed)).equal()) << what;
  };
  refused("no trail", [](Marks& marks) { marks.trails.clear(); });
  refused("a trail without its sphere", [](Marks& marks) { marks.trails.front().on_sphere = false; });
  refused("one arrow less", [](Marks& marks) { marks.arrows.pop_back(); });
  refused("an arrow a tenth longer", [](Marks& marks) { marks.arrows.back().length = 1.1 * kArrowLength; });
  refused("no angle", [](Marks& marks) { marks.angles.clear(); });
  refused("another letter", [](Marks& marks) { marks.angles.front().tex = "\\phi"; });
  refused("no plane", [](Marks& marks) { marks.planes.clear(); });
  refused("a plane about the centre", [](Marks& marks) { marks.planes.front().through.reset(); });
  refused("no note", [](Marks& marks) { marks.notes.clear(); });
}

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
  const Sheet sheet = lay_out(plot, kPlotSize.width, kPlotSize.height, renderer().fonts());
  auto image = renderer().draw(sheet, kPlotSize, background_from("paper").value());
  if (!image) throw std::runtime_error(image.error());
  return std::move(image).value();
}

TEST(GoldenPlot, IsAsApproved) { expect_as_approved(kPlotName, plot_picture(plot_of_all_methods())); }

TEST(GoldenPlot, RefusesEveryMutation) {
  const Image approved = plot_picture(plot_of_all_methods());
  const auto refused = [&](const char* what, auto change) {
    WorkPrecisionPlot plot = plot_of_all_methods();
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
  EXPECT_EQ(plot_picture(plot_of_all_methods()).rgba, plot_picture(plot_of_all_methods()).rgba);
}

TEST(Goldens, NoFileIsWithoutItsRow) {
  std::set<std::string> names = {std::string(kPlotName) + ".png"};
  for (const Golden& golden : all()) names.insert(golden.name + ".png");
  for (const std::string& name : page_names()) names.insert(name + ".png");
  for (const std::string& name : diagram_names()) names.insert(name + ".png");
  for (const std::string& name : window_names()) names.insert(name + ".png");
  for (const auto& entry : fs::directory_iterator(kFolder))
    EXPECT_TRUE(entry.path().extension() != ".png" || names.contains(entry.path().filename().string()))
        << entry.path();
}

}  // namespace
}  // namespace polhode::golden
