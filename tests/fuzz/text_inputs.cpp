// SPDX-License-Identifier: MIT
#include "tests/fuzz/text_inputs.h"

#include "lessons/reader/markdown/inline_text.h"
#include "render/typeset/paragraph.h"

#include <algorithm>
#include <cmath>

namespace polhode::fuzz {
namespace {

constexpr double kWidth = 210.0;

bool is_finite(const DisplayList& list) {
  return std::isfinite(list.width) && std::isfinite(list.ascent) && std::isfinite(list.depth) &&
         std::all_of(list.glyphs.begin(), list.glyphs.end(),
                     [](const Glyph& g) { return std::isfinite(g.x) && std::isfinite(g.y) && g.size > 0.0; });
}

std::string finding_in_set(const RichText& text, const TextStyle& style, std::size_t bytes,
                           const Fonts& fonts) {
  const auto set = set_text(text, style, fonts);
  if (!set) {
    for (const TypeError& error : set.error())
      if (error.offset > bytes || error.message.empty()) return "an error outside the text";
    return "";
  }
  if (!is_finite(*set)) return "a place that is no number";
  if (set->width > kWidth + 1e-6) return "a line wider than its column";
  const bool outside = std::any_of(set->glyphs.begin(), set->glyphs.end(),
                                   [bytes](const Glyph& g) { return g.source.end > bytes; });
  return outside ? "a glyph from outside the text" : "";
}

}  // namespace

Mutator mutated_texts(std::uint64_t seed) {
  return Mutator(
      {"The tip of $\\vec L$ *moves* with **velocity** $\\vec N$, and `code`.",
       "- One $x_1^2$ \"item\".\n- Two: [a link](http://b.c)\n  1. inner $\\frac{a}{b}$\n\n  more\n",
       "If $|\\vec\\omega|\\ne 0$  \nthen &amp; only then — it's 3-dimensional.",
       "A$\\begin{pmatrix}a&b\\\\c&d\\end{pmatrix}$, 𝐿⃗ and é."},
      {"*",          "**",     "_",        "`",       "``",       "[",     "](",         ")",
       "<",          ">",      "&",        ";",       "&amp;",    "&#x",   "\\",         "$",
       "$$",         "\\vec",  "}",        "^",       "_{",       "\n",    "\n\n",       "  \n",
       "- ",         "1. ",    "> ",       "# ",      "|",        "---",   "```",        "![",
       "<b>",        "~",      "\\$",      "\xFF",    "ω",        "ש",     "水",         "\xE2\x83",
       "\t",         "\r",     "\"",       "'",       "\xC2\xA0", "𝐿⃗",     "-",          "—",
       "[a]: b\n\n", "&nbsp;", "\\begin{", "\\left(", "\\frac{",  "10⁻¹²", "\\term{a}{", "\xE2\x80\x8B"},
      seed);
}

std::string finding_in_text(const std::string& markdown, bool justified, const Fonts& fonts) {
  const SourceText source(markdown);
  Report report(source, "text");
  TextReader texts(report);
  const LocatedText located(source, source.text());
  TextStyle style;
  style.width = kWidth;
  style.justified = justified;
  for (const RichText& text : {texts.passage(located), texts.line(located)})
    if (std::string finding = finding_in_set(text, style, markdown.size(), fonts); !finding.empty())
      return finding;
  if (!is_finite(set_line(markdown, style, fonts))) return "a caption at no number";
  for (const Diagnostic& d : report.take())
    if (d.message.empty() || source.clamp(d.place) != d.place) return "a complaint without a place";
  return "";
}

}  // namespace polhode::fuzz
