// SPDX-License-Identifier: MIT
#include "render/drawing/plots/method_look.h"

#include "render/drawing/plots/plot_style.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <tuple>

namespace polhode {
namespace {

PlotSeries series_of(Method method) {
  return {.label = std::string(name_of(method)), .look = look_of(method), .place = place_of(method)};
}

TEST(MethodLook, EachMethodOfAFamilyHasItsOwnMark) {
  std::set<std::tuple<PlotLook, MarkShape, float, float, float>> marks;
  std::size_t count = 0;
  for (const MethodFacts& facts : all_methods()) {
    if (look_of(facts.method) == PlotLook::star) continue;  // one exact motion
    const CurveStyle style = styles_of({series_of(facts.method)}).front();
    marks.insert({look_of(facts.method), style.shape, style.paint.r, style.paint.g, style.paint.b});
    ++count;
  }
  EXPECT_EQ(marks.size(), count);
}

TEST(MethodLook, AMethodHasTheSameMarkInEveryPlot) {
  std::vector<PlotSeries> all;
  for (const MethodFacts& facts : all_methods()) all.push_back(series_of(facts.method));
  const std::vector<CurveStyle> among_all = styles_of(all);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const CurveStyle alone = styles_of({all[i]}).front();
    EXPECT_EQ(alone.shape, among_all[i].shape) << all[i].label;
    EXPECT_EQ(alone.paint, among_all[i].paint) << all[i].label;
  }
}

}  // namespace
}  // namespace polhode
