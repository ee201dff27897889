// SPDX-License-Identifier: MIT
// Display lists of all formulas at 1000 px, so that a number is a thousandth of the em. After a wanted
// change:
//   POLHODE_REMAKE=formulas build/dev/tests/render/typeset/typeset_tests --gtest_filter='MathGolden.*'
// Look at the formulas before you commit the new numbers.
#include "render/typeset/math/math.h"
#include "tests/render/typeset/math/formulas.h"
#include "tests/support/paths.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <sstream>

namespace polhode {
namespace {

std::string number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.2f", value == 0.0 ? 0.0 : value);
  std::string s = text;
  while (s.back() == '0') s.pop_back();
  if (s.back() == '.') s.pop_back();
  return s == "-0" ? "0" : s;
}

/// FNV-1a of the bits of every number.
class Bits {
 public:
  void add(double value) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    add(bits);
  }
  void add(std::uint64_t bits) {
    for (int i = 0; i < 8; ++i) sum_ = (sum_ ^ ((bits >> (8 * i)) & 0xFF)) * 0x100000001B3ULL;
  }
  std::uint64_t sum() const { return sum_; }

 private:
  std::uint64_t sum_ = 0xCBF29CE484222325ULL;
};

std::string described(const std::string& name, const DisplayList& list) {
  std::ostringstream out;
  Bits bits;
  for (const double v : {list.width, list.ascent, list.depth}) bits.add(v);
  out << name << " " << number(list.width) << " " << number(list.ascent) << " " << number(list.depth);
  for (const Glyph& g : list.glyphs) {
    out << " g" << static_cast<int>(g.face) << ":" << g.id << " " << number(g.x) << " " << number(g.y) << " "
        << number(g.size);
    bits.add(std::uint64_t{g.id});
    for (const double v : {g.x, g.y, g.size}) bits.add(v);
  }
  for (const Rule& r : list.rules) {
    out << " r " << number(r.x0) << " " << number(r.y0) << " " << number(r.x1) << " " << number(r.y1) << " "
        << number(r.thickness);
    for (const double v : {r.x0, r.y0, r.x1, r.y1, r.thickness}) bits.add(v);
  }
  char sum[20];
  std::snprintf(sum, sizeof sum, " #%016llx", static_cast<unsigned long long>(bits.sum()));
  out << sum;
  return out.str();
}

class MathGolden : public ::testing::TestWithParam<const char*> {};

/// All digits count: the sum at a line's end is that of the numbers' bits, in every build.
TEST_P(MathGolden, ListsAreTheStoredOnes) {
  const auto fonts = Fonts::open();
  ASSERT_TRUE(fonts.ok()) << fonts.error();
  const std::string path = test::source_dir() / "tests/data/formulas" / (GetParam() + std::string(".golden"));
  std::vector<std::string> lines;
  for (const auto& [name, tex] : testing::named_formulas(GetParam())) {
    const auto math = parse_math(tex);
    ASSERT_TRUE(math.ok()) << name;
    MathStyle style;
    style.size = 1000.0;
    style.display = !name.starts_with("inline-");
    const auto list = set_math(*math, style, *fonts);
    ASSERT_TRUE(list.ok()) << name;
    lines.push_back(described(name, *list));
  }
  const char* remake = std::getenv("POLHODE_REMAKE");
  if (remake != nullptr && std::string(remake) == "formulas") {
    std::ofstream out(path);
    for (const std::string& line : lines) out << line << "\n";
  }
  std::ifstream in(path);
  std::string stored;
  for (const std::string& line : lines) {
    ASSERT_TRUE(std::getline(in, stored)) << line;
    EXPECT_EQ(stored, line);
  }
  EXPECT_FALSE(std::getline(in, stored)) << stored;
}

/// lecture.tsv holds each ```math block of the lesson, its white space as single spaces.
TEST(FormulasOfTheLecture, AreThoseOfTheLesson) {
  std::map<std::string, std::string> stored;
  for (const auto& [name, tex] : testing::named_formulas("lecture")) stored[name] = tex;
  std::ifstream in(test::source_dir() / "lessons/euler-equations.md");
  std::string name, tex;
  int blocks = 0;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("```math ")) {
      name = line.substr(8, line.find(' ', 8) - 8);  // without the kind of what it claims
      tex.clear();
    } else if (line == "```" && !name.empty()) {
      EXPECT_EQ(stored[name], tex) << name;
      name.clear();
      ++blocks;
    } else if (!name.empty()) {
      std::istringstream words(line);
      for (std::string word; words >> word;) tex += (tex.empty() ? "" : " ") + word;
    }
  }
  EXPECT_GE(blocks, 90);
}

INSTANTIATE_TEST_SUITE_P(Formulas, MathGolden, ::testing::Values("lecture", "corpus"));

}  // namespace
}  // namespace polhode
