// SPDX-License-Identifier: MIT
#include "tests/golden/approval.h"

#include "render/image/compare.h"
#include "render/image/png.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>

namespace polhode::golden {
namespace {

namespace fs = std::filesystem;

const fs::path kFailed = test::source_dir() / "out/check";

struct Stage {
  std::unique_ptr<const Fonts> fonts;
  std::unique_ptr<GlContext> context;
  std::unique_ptr<Renderer> renderer;
};
Stage& stage() {
  static Stage made = [] {
    setenv("GALLIUM_OVERRIDE_CPU_CAPS", "sse4.1", 0);  // llvmpipe reads it when it is opened
    auto context = open_context(ContextKind::any);
    if (!context) throw std::runtime_error(context.error());
    auto fonts = std::make_unique<const Fonts>(Fonts::open().value());
    auto renderer = Renderer::create(**context, *fonts);
    if (!renderer) throw std::runtime_error(renderer.error());
    return Stage{std::move(fonts), std::move(context).value(), std::move(renderer).value()};
  }();
  return made;
}

std::string recorded_mesa() {
  std::ifstream file(kFolder / "DRIVER");
  std::string line;
  std::getline(file, line);
  return mesa_of(line);
}

/// For ./check, which repeats it; once for all goldens.
void tell_of_other_mesa(const std::string& recorded, const std::string& driver) {
  static const bool kTold = [&] {
    std::cout << "goldens were made on " << recorded << " and compared by the same rule with what " << driver
              << " draws" << std::endl;
    return true;
  }();
  static_cast<void>(kTold);
}

void keep_evidence(const std::string& name, const Image& want, const Image& got) {
  fs::create_directories(kFailed);
  EXPECT_TRUE(write_png(kFailed / (name + "-want.png"), want, {}).ok());
  EXPECT_TRUE(write_png(kFailed / (name + "-got.png"), got, {}).ok());
  EXPECT_TRUE(write_png(kFailed / (name + "-diff.png"), difference_image(want, got), {}).ok());
}

}  // namespace

std::string mesa_of(const std::string& driver) {
  const auto at = driver.rfind("Mesa ");
  return at == std::string::npos ? driver : driver.substr(at);
}

Remake remake_of(const std::string& name, const std::string& asked, bool by_other_mesa) {
  Remake answer = Remake::no;
  std::istringstream words(asked);
  for (std::string word; words >> word;) {
    if (word == "all") return Remake::yes;
    if (word == name) answer = by_other_mesa ? Remake::refused : Remake::yes;
  }
  return answer;
}

Renderer& renderer() { return *stage().renderer; }

const GlContext& context() { return *stage().context; }

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

void expect_as_approved(const std::string& name, const Image& got, const fs::path& folder) {
  EXPECT_FALSE(is_blank(got));
  const fs::path path = folder / (name + ".png");
  const std::string driver = renderer().driver(), recorded = recorded_mesa();
  const bool by_other_mesa = mesa_of(driver) != recorded;
  const char* asked = std::getenv("POLHODE_REMAKE");
  const Remake remake = remake_of(name, asked ? asked : "", by_other_mesa);
  if (remake == Remake::yes) {
    ASSERT_TRUE(write_png(path, got, {}).ok());
    std::ofstream(kFolder / "DRIVER") << driver << '\n';
    GTEST_SKIP() << "remade " << path;
  }
  ASSERT_NE(remake, Remake::refused) << name << " is not remade: goldens are of " << recorded << ", this is "
                                     << driver << "; remake all of them, or this one with " << recorded;
  if (by_other_mesa) tell_of_other_mesa(recorded, driver);

  const auto want = read_png(path);
  ASSERT_TRUE(want.ok()) << want.error();
  const Comparison c = compare_images(want->image, got);
  if (!c.equal()) keep_evidence(name, want->image, got);
  EXPECT_TRUE(c.equal()) << name << ": " << c.over_3 << " of " << c.pixels << " pixels off by more than "
                         << kGoldenLevels << " levels, at most " << c.max << "; see out/check/" << name
                         << "-*.png; driver " << driver;
}

}  // namespace polhode::golden
