// SPDX-License-Identifier: MIT
#include "app/export/named_sizes.h"

#include "app/cli/commands/export_options.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

ExportOptions options_for(const std::string& size, const std::string& dpi = "") {
  TypedExport typed;
  typed.lessons = {"any"};
  typed.size = size;
  typed.dpi = dpi;
  return export_options(typed);
}

TEST(NamedSizes, AreWhatTheirNamesSay) {
  EXPECT_EQ(options_for("16:9").size, (Size{1920, 1080}));
  EXPECT_EQ(options_for("4k").size, (Size{3840, 2160}));
  EXPECT_EQ(options_for("4:3").size.width * 3, options_for("4:3").size.height * 4);
  EXPECT_EQ(options_for("4:3").dpi, 0);
  const ExportOptions a4 = options_for("a4");
  EXPECT_NEAR(a4.size.width * 25.4 / a4.dpi, 297, 25.4 / a4.dpi) << "mm, to a pixel";
  EXPECT_NEAR(a4.size.height * 25.4 / a4.dpi, 210, 25.4 / a4.dpi);
  EXPECT_EQ(options_for("a4", "600").dpi, 600);
}

TEST(NamedSizes, OthersArePixels) {
  EXPECT_FALSE(named_size("1920x1080"));
  EXPECT_EQ(options_for("1024x768").size, (Size{1024, 768}));
  EXPECT_THROW(options_for("16x9px"), std::exception);
}

}  // namespace
}  // namespace polhode
