// SPDX-License-Identifier: MIT
#include "tests/golden/approval.h"

#include "render/image/compare.h"
#include "render/image/png.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace polhode::golden {
namespace {

namespace fs = std::filesystem;

const fs::path kFailed = fs::path(POLHODE_SOURCE_DIR) / "out/check";

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

}  // namespace

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

void expect_as_approved(const std::string& name, const Image& got) {
  EXPECT_FALSE(is_blank(got));
  const fs::path path = kFolder / (name + ".png");
  if (to_remake(name)) {
    ASSERT_TRUE(write_png(path, got, {}).ok());
    std::ofstream(kFolder / "DRIVER") << renderer().driver() << '\n';
    GTEST_SKIP() << "remade " << path;
  }
  const std::string driver = renderer().driver();
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

}  // namespace polhode::golden
