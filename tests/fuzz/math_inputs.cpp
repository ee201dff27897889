// SPDX-License-Identifier: MIT
#include "tests/fuzz/math_inputs.h"

#include "lessons/notation/tex_equation.h"
#include "render/typeset/math/commands.h"
#include "tests/support/paths.h"

#include <algorithm>
#include <cmath>
#include <fstream>

namespace polhode::fuzz {
namespace {

std::vector<std::string> seeds() {
  std::vector<std::string> all;
  for (const char* file : {"lecture", "corpus"}) {
    std::ifstream in(test::source_dir() / "tests/data/formulas" / (std::string(file) + ".tsv"));
    for (std::string line; std::getline(in, line);) all.push_back(line.substr(line.find('\t') + 1));
  }
  return all;
}

std::vector<std::string> tokens() {
  std::vector<std::string> all = {"{",         "}",
                                  "^",         "_",
                                  "&",         "\\\\",
                                  "[",         "]",
                                  "'",         "%",
                                  "\n",        "$",
                                  "#1",        "~",
                                  "\\left(",   "\\right)",
                                  "\\middle|", "\\end{aligned}",
                                  "\\f{",      "\\g",
                                  "\\\\[3pt]", "א",
                                  "漢",        "\xE2\x82",
                                  "\xFF",      "{{{{{{{{{{{{",
                                  "}}}}}}}}",  "\\text{",
                                  "\\tag{1}"};
  for (const std::string_view name : math_command_names()) all.push_back("\\" + std::string(name));
  for (const std::string_view name : math_environment_names()) {
    all.push_back("\\begin{" + std::string(name) + "}");
    all.push_back("\\end{" + std::string(name) + "}");
  }
  return all;
}

const MathMacros& macros() {
  static const MathMacros kMacros = {
      {"f", {1, "\\frac{#1}{#1#1}"}}, {"g", {0, "\\f{\\g}"}}, {"h", {2, "{#2^#1"}}};
  return kMacros;
}

std::string wrong_with_errors(const std::vector<TypeError>& errors, std::size_t size) {
  if (errors.empty() || errors.size() > 16) return std::to_string(errors.size()) + " errors";
  std::size_t last = 0;
  for (const TypeError& e : errors) {
    if (e.offset > size || e.offset < last || e.message.empty())
      return "error at " + std::to_string(e.offset);
    last = e.offset;
  }
  return {};
}

std::string wrong_with_list(const DisplayList& list, std::size_t size) {
  // So much a formula of 8 KiB can measure, at 30 px.
  constexpr double kLargest = 1e7;
  const auto bad = [](double v) { return !(std::abs(v) < kLargest); };
  if (bad(list.width) || bad(list.ascent) || bad(list.depth) || list.ascent < 0.0 || list.depth < 0.0)
    return "measures";
  for (const Glyph& g : list.glyphs)
    if (bad(g.x) || bad(g.y) || !(g.size > 0.0) || g.source.end > size || g.source.begin > g.source.end)
      return "glyph";
  for (const Rule& r : list.rules)
    if (bad(r.x0) || bad(r.y0) || bad(r.x1) || bad(r.y1) || !(r.thickness > 0.0) || r.source.end > size)
      return "rule";
  return {};
}

}  // namespace

Mutator mutated_formulas(std::uint64_t seed) { return Mutator(seeds(), tokens(), seed); }

std::string finding_in(const std::string& tex, const Fonts& fonts) {
  static const std::vector<MathSymbol> kSymbols = {{"omega", *parse_math("\\vec\\omega"), {}},
                                                   {"i", *parse_math("I_1"), {}},
                                                   {"dl", *parse_math("d\\vec L"), {}}};
  const auto math = parse_math(tex, macros());
  if (!math.ok()) return wrong_with_errors(math.error(), tex.size());
  for (int i = 0; i < 3; ++i) {
    MathStyle style;
    style.size = 30.0;
    style.display = i > 0;
    style.line_width = i == 2 ? 300.0 : 0.0;
    style.symbols = i == 1 ? &kSymbols : nullptr;
    const auto list = set_math(*math, style, fonts);
    const std::string wrong =
        list.ok() ? wrong_with_list(*list, tex.size()) : wrong_with_errors(list.error(), tex.size());
    if (!wrong.empty()) return wrong;
  }
  if (const auto read = read_equation(*math, {}); !read && read.error().place.end > tex.size())
    return "an unreadable place outside the formula: " + read.error().reason;
  letters_in(*math, {});
  spoken(*math, kSymbols, [](std::string_view name) { return std::string(name); });
  return {};
}

}  // namespace polhode::fuzz
