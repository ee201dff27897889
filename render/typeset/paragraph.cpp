// SPDX-License-Identifier: MIT
#include "render/typeset/paragraph.h"

#include "render/typeset/characters.h"
#include "render/typeset/line_breaker.h"
#include "render/typeset/line_formulas.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>

namespace polhode {
namespace {

constexpr int kMaxFormulaTries = 12;  // to make one narrow enough

// Lengths in em of the text.
constexpr double kRag = 2.6;           // what a ragged line may lack
constexpr double kSpaceStretch = 0.5;  // of a word space
constexpr double kSpaceShrink = 0.28;  // of a word space
constexpr double kListIndent = 1.35;   // of each level
constexpr double kBulletSize = 0.8;
constexpr double kMarkerGap = 0.5;    // between a marker and its text
constexpr double kListBetween = 0.5;  // of the space between other blocks
constexpr double kLinkDrop = 0.13;    // of the line below a link
constexpr double kLinkThickness = 0.045;
constexpr double kShortFormula = 1.6;  // a name of something, which belongs to the word before it

// Of tables.
constexpr double kColumnGap = 1.5;                       // between columns
constexpr double kTablePad = 0.35;                       // to the ends of the lines
constexpr double kRowGap = 0.16;                         // between rows, besides what lines have
constexpr double kRulePad = 0.3;                         // between a line and the rows beside it
constexpr double kAboveTable = 0.25, kBelowTable = 0.6;  // beside its outer lines
constexpr double kHeavyRule = 0.075, kLightRule = 0.045;
constexpr double kLeastTableSize = 0.6;   // of the text; rather than smaller, words are broken
constexpr double kLeastBrokenSize = 0.1;  // where there is not even room for letters

/// Of the size at which the x-heights are equal: the letters of a typewriter are so wide that they look
/// larger.
constexpr double kMonoSize = 0.92;

constexpr double kScriptSize = 0.68;
constexpr double kScriptRise = 0.38;
constexpr double kScriptDrop = 0.20;

// Penalties of a line that ends there; 100 is a lot.
constexpr double kAfterHyphen = 60.0;
constexpr double kAfterShortWord = 50.0;
constexpr double kBeforeShortFormula = 45.0;
constexpr double kWithinNumber = 1e4;  // "5 | s", "axis | 3": only where no other line fits

bool is_digit(char32_t c) { return U'0' <= c && c <= U'9'; }
bool is_combining(char32_t c) {
  return (0x0300 <= c && c <= 0x036F) || (0x20D0 <= c && c <= 0x20F0) || (0x1AB0 <= c && c <= 0x1AFF);
}
/// A line may end after it.
bool is_hyphen(char32_t c) { return c == U'-' || (0x2010 <= c && c <= 0x2014 && c != 0x2011); }
bool is_letter(char32_t c) { return (U'a' <= c && c <= U'z') || (U'A' <= c && c <= U'Z'); }

/// A character of a run, or a formula, or a forced end of the line.
struct Element {
  enum class Kind : std::uint8_t { character, formula, line_end } kind = Kind::character;
  Face face = Face::serif;
  char32_t character = 0;
  std::uint32_t span = 0;  ///< it belongs to
  SourceSpan source;
  int script = 0;  ///< 1: small and raised, −1: small and lowered
};

/// A glyph or a formula, x from the begin of its part.
struct Atom {
  Glyph glyph;
  int formula = -1;        ///< in formulas; −1: a glyph
  bool is_cluster = true;  ///< may be first on a line
  std::uint32_t span = 0;
};

/// Units in one word that lessons have behind a number.
bool is_unit(std::u32string_view word) {
  constexpr std::array<std::u32string_view, 28> kUnits = {
      U"%",   U"°",  U"deg", U"rad", U"mrad", U"rad/s", U"rad/s²", U"deg/s", U"s",    U"ms",
      U"min", U"h",  U"Hz",  U"m",   U"cm",   U"mm",    U"km",     U"m/s",   U"m/s²", U"kg",
      U"g",   U"mg", U"N",   U"kN",  U"J",    U"mJ",    U"W",      U"years"};
  return std::ranges::find(kUnits, word) != kUnits.end();
}

/// Of one block: atoms, and the parts they make.
struct Parts {
  std::vector<Atom> atoms;
  std::vector<std::size_t> first_atoms;  ///< of each part, and one past the last
  std::vector<LinePart> lines;           ///< what the breaker sees of each part
  std::vector<DisplayList> formulas;
};

/// Measures of faces that a text is set with, em of the text.
struct Metrics {
  Metrics(const TextStyle& style, const Fonts& fonts) : sans(style.sans) {
    const auto height = [&fonts](Face face, char32_t c) {
      return fonts.box(face, *fonts.glyph(face, c)).top;
    };
    const Face body = sans ? Face::sans : Face::serif;
    const double x = height(body, U'x');
    sizes.fill(1.0);
    // Letters of one line look equally large if their x-heights are equal.
    if (sans) sizes.fill(x / height(Face::serif, U'x'));
    sizes[static_cast<std::size_t>(Face::sans)] = sizes[static_cast<std::size_t>(Face::sans_bold)] = 1.0;
    sizes[static_cast<std::size_t>(Face::mono)] = kMonoSize * x / height(Face::mono, U'x');
    ascent = height(body, U'd');
    depth = -fonts.box(body, *fonts.glyph(body, U'p')).bottom;
  }
  double size(Face face) const { return sizes[static_cast<std::size_t>(face)]; }

  bool sans;
  std::array<double, kFaceCount> sizes{};
  double ascent = 0, depth = 0;
};

Face face_of(const TextSpan& span, const TextStyle& style) {
  const bool bold = span.bold || style.bold;
  if (span.code) return Face::mono;
  if (style.sans) return bold ? Face::sans_bold : Face::sans;
  if (bold) return span.italic ? Face::serif_bold_italic : Face::serif_bold;
  return span.italic ? Face::serif_italic : Face::serif;
}

/// Where a byte of a span's text comes from. A text that is not its source (an entity) comes from all of it.
SourceSpan source_of(const TextSpan& span, std::size_t begin, std::size_t end) {
  if (span.text.size() != span.source.end - span.source.begin) return span.source;
  return {span.source.begin + static_cast<std::uint32_t>(begin),
          span.source.begin + static_cast<std::uint32_t>(end)};
}

/// Sets text; collects what is wrong with it, or, if it is lenient, shows it somehow.
class TextSetter {
 public:
  TextSetter(const TextStyle& style, const Fonts& fonts, bool lenient)
      : style_(style), fonts_(fonts), metrics_(style, fonts), lenient_(lenient) {}

  DisplayList set(const RichText& text) {
    measure_indents(text);
    for (const TextBlock& block : text) {
      const TextBlock* before = &block != text.data() ? &block - 1 : nullptr;
      if (block.is_table())
        set_table(block, before);
      else
        set_block(block, before);
      if (errors_.size() >= kMaxTypeErrors) break;
    }
    return std::move(list_);
  }
  std::vector<TypeError> take_errors() {
    std::stable_sort(errors_.begin(), errors_.end(),
                     [](const TypeError& a, const TypeError& b) { return a.offset < b.offset; });
    if (errors_.size() > kMaxTypeErrors) errors_.resize(kMaxTypeErrors);
    return std::move(errors_);
  }

 private:
  void fail(std::size_t offset, std::string message, std::string hint) {
    if (!lenient_) errors_.push_back({offset, std::move(message), std::move(hint)});
  }

  // ---- From spans to elements

  std::vector<Element> elements_of(const TextBlock& block) {
    std::vector<Element> elements;
    for (std::uint32_t i = 0; i < block.spans.size(); ++i) {
      const TextSpan& span = block.spans[i];
      if (span.kind == TextSpan::Kind::math)
        elements.push_back({Element::Kind::formula, Face::math, 0, i, span.source});
      else
        add_characters(span, i, elements);
      if (span.break_after) elements.push_back({Element::Kind::line_end, Face::serif, 0, i, span.source});
    }
    set_scripts(elements);
    return elements;
  }

  /// All digits of an exponent are of one size; the fonts' own ¹²³ stay where they stand alone: m², note¹.
  static void set_scripts(std::vector<Element>& elements) {
    const auto raised = [&](std::size_t i) { return script_of(elements[i].character).raised; };
    for (std::size_t i = 0; i < elements.size(); ++i) {
      const Script script = script_of(elements[i].character);
      if (script.character == 0) continue;
      const Element* before = i > 0 ? &elements[i - 1] : nullptr;
      const bool in_exponent = (before != nullptr && (before->script > 0 || is_digit(before->character))) ||
                               (i + 1 < elements.size() && raised(i + 1));
      if (elements[i].character < 0x2000 && !in_exponent) continue;
      elements[i].character = script.character;
      elements[i].script = script.raised ? 1 : -1;
    }
  }

  void add_characters(const TextSpan& span, std::uint32_t index, std::vector<Element>& into) {
    const Face face = face_of(span, style_);
    for (std::size_t at = 0; at < span.text.size();) {
      const std::size_t begin = at;
      const char32_t c = next_character(span.text, at);
      Element element{Element::Kind::character, face, c, index, source_of(span, begin, at)};
      if (is_space(c)) {
        element.character = U' ';
        // Spaces count once, and not at the begin of a line.
        if (into.empty() || into.back().kind == Element::Kind::line_end || into.back().character == U' ')
          continue;
      } else {
        if (!span.code) element.character = curled(c, into);
        check_character(element);
        if (element.character >= 0x80) choose_face(element, into);
      }
      into.push_back(element);
    }
  }

  /// A straight quotation mark opens after a space, a bracket or a dash, and closes after anything else.
  static char32_t curled(char32_t c, const std::vector<Element>& before) {
    if (c != U'\'' && c != U'"') return c;
    constexpr std::u32string_view kBeforeOpening = U" ([{\u2013\u2014\u2018\u201C";
    const bool opens = before.empty() || before.back().kind == Element::Kind::line_end ||
                       (before.back().kind == Element::Kind::character &&
                        kBeforeOpening.find(before.back().character) != std::u32string_view::npos);
    if (c == U'"') return opens ? 0x201C : 0x201D;
    return opens ? 0x2018 : 0x2019;
  }

  void check_character(Element& e) {
    const char32_t c = e.character;
    if (c >= 0x20 && c < 0x7F) return;
    if (c == kMalformed)
      refuse(e, "this is not UTF-8 text", "save it as UTF-8");
    else if (is_right_to_left(c))
      refuse(e, "text from right to left is not set: " + code_point_name(c), "");
    else if (is_invisible(c))
      refuse(e, "the character " + code_point_name(c) + " shows nothing", "leave it out");
  }

  void refuse(Element& e, std::string message, std::string hint) {
    fail(e.source.begin, std::move(message), std::move(hint));
    if (!lenient_)
      e.character = U'?';  // said once
    else if (e.character == kMalformed)
      e.character = 0xFFFD;
  }

  /// The face of the text, or that of mathematics for what it lacks. A mark that the letter's face lacks
  /// takes its letter along.
  void choose_face(Element& e, std::vector<Element>& before) {
    const bool mark = is_combining(e.character) && !before.empty() &&
                      before.back().kind == Element::Kind::character && before.back().character != U' ';
    if (mark) e.face = before.back().face;
    if (fonts_.glyph(e.face, e.character) || !fonts_.glyph(Face::math, e.character)) return;
    if (mark && e.character < 0x20D0) return;  // composed with its letter by the shaper
    e.face = Face::math;
    if (mark && fonts_.glyph(Face::math, before.back().character)) before.back().face = Face::math;
  }

  // ---- From elements to parts

  Parts parts_of(const TextBlock& block, double width) {
    const std::vector<Element> elements = elements_of(block);
    Parts parts;
    parts.atoms.reserve(elements.size());
    begin_part(parts);
    for (std::size_t i = 0; i < elements.size();) {
      const Element& e = elements[i];
      if (e.kind == Element::Kind::character) {
        std::size_t end = i + 1;
        while (end < elements.size() && elements[end].kind == Element::Kind::character &&
               elements[end].face == e.face && elements[end].script == e.script)
          ++end;
        add_run(block, elements, i, end, parts);
        i = end;
        continue;
      }
      if (e.kind == Element::Kind::formula)
        add_formula(block.spans[e.span], e.span, width, parts);
      else
        end_part(parts, 0.0, true);
      ++i;
    }
    const bool nothing_follows = parts.first_atoms.back() == parts.atoms.size();
    if (nothing_follows && parts.lines.size() > 1) drop_part(parts);
    parts.first_atoms.push_back(parts.atoms.size());
    return parts;
  }

  static void begin_part(Parts& parts) {
    parts.first_atoms.push_back(parts.atoms.size());
    parts.lines.emplace_back();
  }
  static void drop_part(Parts& parts) {
    parts.first_atoms.pop_back();
    parts.lines.pop_back();
  }
  static void end_part(Parts& parts, double space, bool ends_line = false, double penalty = 0.0) {
    LinePart& part = parts.lines.back();
    part.space = space;
    part.stretch = kSpaceStretch * space;
    part.shrink = kSpaceShrink * space;
    part.ends_line = ends_line;
    part.penalty = std::max(part.penalty, penalty);
    begin_part(parts);
  }

  /// Characters of one face are shaped together, so that they kern across spans and spaces.
  void add_run(const TextBlock& block, const std::vector<Element>& elements, std::size_t first,
               std::size_t last, Parts& parts) {
    run_.clear();
    begins_.clear();
    for (std::size_t i = first; i < last; ++i) {
      begins_.push_back(static_cast<std::uint32_t>(run_.size()));
      append_utf8(run_, elements[i].character);
    }
    const Face face = elements[first].face;
    const int script = elements[first].script;
    const double em = style_.size * metrics_.size(face), size = script == 0 ? em : kScriptSize * em;
    const double rise = script > 0 ? kScriptRise * em : script < 0 ? -kScriptDrop * em : 0.0;
    const std::vector<ShapedGlyph> shaped = fonts_.shape(face, run_);
    std::size_t i = first;
    double pen = shaped.empty() ? 0.0 : shaped.front().x;
    std::uint32_t cluster = 0xFFFFFFFF;
    for (const ShapedGlyph& g : shaped) {
      while (i + 1 < last && begins_[i + 1 - first] <= g.cluster) ++i;
      const Element& e = elements[i];
      if (e.character == U' ') {
        add_space(g.advance * size, penalty_at(block, elements, i), parts);
        pen += g.advance;
        cluster = g.cluster;
        continue;
      }
      if (g.id == 0)
        fail(e.source.begin, "no font has the character " + code_point_name(e.character),
             "write another one");
      LinePart& part = parts.lines.back();
      Atom atom;
      atom.glyph = {face,
                    g.id,
                    part.width + (g.x - pen) * size,
                    -rise - g.y * size,
                    size,
                    color_of(block.spans[e.span]),
                    naming_of(block.spans[e.span], list_),
                    e.source};
      atom.is_cluster = g.cluster != cluster && !is_combining(e.character);
      atom.span = e.span;
      parts.atoms.push_back(atom);
      part.width += g.advance * size;
      pen += g.advance;
      cluster = g.cluster;
      if (ends_part(elements, i, last) && parts.first_atoms.back() + 1 < parts.atoms.size())
        end_part(parts, 0.0, false, e.character == U'-' ? kAfterHyphen : 0.0);
    }
  }

  /// A line may end after a hyphen or a dash, but for the dash of a pair of names: Moser–Veselov.
  static bool ends_part(const std::vector<Element>& elements, std::size_t i, std::size_t last) {
    if (!is_hyphen(elements[i].character) || i + 1 >= last || is_hyphen(elements[i + 1].character))
      return false;
    const bool joins_names = elements[i].character == 0x2013 && i > 0 &&
                             is_letter(elements[i - 1].character) && is_letter(elements[i + 1].character);
    return !joins_names;
  }

  /// The word that begins at an element, without punctuation.
  static std::u32string word_at(const std::vector<Element>& elements, std::size_t begin) {
    constexpr std::u32string_view kEnds = U" ,.;:!?)]";
    std::u32string word;
    for (std::size_t i = begin; i < elements.size() && elements[i].kind == Element::Kind::character &&
                                kEnds.find(elements[i].character) == std::u32string_view::npos;
         ++i)
      word += elements[i].character;
    return word;
  }

  static bool ends_in_digit(const TextBlock& block, const Element& element) {
    if (element.kind != Element::Kind::formula) return is_digit(element.character);
    const std::string& tex = block.spans[element.span].text;
    return !tex.empty() && is_digit(static_cast<unsigned char>(tex.back()));
  }

  /// Of a line that ends at this space: a number stays with its unit, and with the word that it numbers.
  static double penalty_at(const TextBlock& block, const std::vector<Element>& elements, std::size_t space) {
    if (space == 0) return 0.0;
    const Element& before = elements[space - 1];
    const std::u32string after = word_at(elements, space + 1);
    if (ends_in_digit(block, before) && is_unit(after)) return kWithinNumber;
    const bool is_short_number =
        0 < after.size() && after.size() <= 2 && std::all_of(after.begin(), after.end(), is_digit);
    return is_short_number && is_letter(before.character) ? kWithinNumber : 0.0;
  }

  void add_space(double width, double penalty, Parts& parts) {
    if (parts.first_atoms.back() == parts.atoms.size()) return;
    const bool short_word =
        parts.atoms.size() - parts.first_atoms.back() == 1 && parts.atoms.back().formula < 0;
    end_part(parts, width, false, std::max(penalty, short_word ? kAfterShortWord : 0.0));
  }

  Color color_of(const TextSpan& span) const { return span.link.empty() ? style_.color : style_.link_color; }

  /// All of a link has its name, so that whoever shows the text can follow it.
  static Naming naming_of(const TextSpan& span, DisplayList& list) {
    if (span.link.empty()) return {};
    return {index_of(list, span.link), -1};
  }

  void add_formula(const TextSpan& span, std::uint32_t index, double width, Parts& parts) {
    auto formula = formula_of(span, width);
    if (!formula) return;
    const double em = style_.size;
    const std::size_t part_index = parts.lines.size() - 1;
    const bool begins_part = parts.first_atoms.back() == parts.atoms.size();
    if (begins_part && part_index > 0 && formula->width < kShortFormula * em) {
      LinePart& before = parts.lines[part_index - 1];
      before.penalty = std::max(before.penalty, kBeforeShortFormula);
    }
    Atom atom;
    atom.glyph.x = parts.lines.back().width;
    atom.formula = static_cast<int>(parts.formulas.size());
    atom.span = index;
    parts.lines.back().width += formula->width;
    parts.atoms.push_back(atom);
    parts.formulas.push_back(std::move(*formula));
  }

  /// Broken, and then made smaller, if it is wider than a line.
  std::optional<DisplayList> formula_of(const TextSpan& span, double width) {
    MathStyle math;
    math.size = style_.size * metrics_.size(Face::math);
    math.color = color_of(span);
    math.symbols = style_.symbols;
    auto set = set_math(span.math, math, fonts_);
    if (width > 0.0) math.line_width = width;
    for (int i = 0; i < kMaxFormulaTries && set && width > 0.0 && set->width > width; ++i) {
      if (i > 0) math.size *= std::max(0.5, 0.99 * width / set->width);
      set = set_math(span.math, math, fonts_);
    }
    if (!set) {
      for (const TypeError& error : set.error())
        fail(source_of(span, error.offset, error.offset).begin, error.message, error.hint);
      return std::nullopt;
    }
    const auto move = [&span](SourceSpan& source) { source = source_of(span, source.begin, source.end); };
    const Naming link = naming_of(span, *set);
    for (Glyph& glyph : set->glyphs) {
      move(glyph.source);
      if (glyph.naming.term < 0) glyph.naming.term = link.term;
    }
    for (Rule& rule : set->rules) move(rule.source);
    return std::move(*set);
  }

  /// Words that are wider than a line are broken anywhere.
  static void split_wide_parts(Parts& parts, double width) {
    if (std::none_of(parts.lines.begin(), parts.lines.end(),
                     [width](const LinePart& p) { return p.width > width; }))
      return;
    Parts split;
    for (std::size_t p = 0; p < parts.lines.size(); ++p) {
      const std::size_t first = parts.first_atoms[p], end = parts.first_atoms[p + 1];
      std::size_t begin = first;
      for (std::size_t a = first; a < end; ++a) {
        if (a == begin || !parts.atoms[a].is_cluster) continue;
        if (next_x(parts, p, a) <= width) continue;
        const double x = parts.atoms[a].glyph.x;
        split.first_atoms.push_back(begin);
        split.lines.push_back({x, 0, 0, 0, 100.0, false});
        begin = a;
        for (std::size_t rest = a; rest < end; ++rest) parts.atoms[rest].glyph.x -= x;
        parts.lines[p].width -= x;
      }
      split.first_atoms.push_back(begin);
      split.lines.push_back(parts.lines[p]);
    }
    split.first_atoms.push_back(parts.atoms.size());
    parts.first_atoms = std::move(split.first_atoms);
    parts.lines = std::move(split.lines);
  }

  /// Where what follows an atom of a part begins.
  static double next_x(const Parts& parts, std::size_t part, std::size_t atom) {
    for (std::size_t a = atom + 1; a < parts.first_atoms[part + 1]; ++a)
      if (parts.atoms[a].is_cluster) return parts.atoms[a].glyph.x;
    return parts.lines[part].width;
  }

  // ---- From parts to lines

  void measure_indents(const RichText& text) {
    for (const TextBlock& block : text) {
      if (block.indent <= 0) continue;
      double& step = indents_[block.indent];
      step = std::max(
          {step, kListIndent * style_.size, marker_of(block.marker).width() + kMarkerGap * style_.size});
    }
  }
  double indent_of(int level) const {
    double x = 0.0;
    for (int i = 1; i <= level; ++i) {
      const auto step = indents_.find(i);
      x += step == indents_.end() ? kListIndent * style_.size : step->second;
    }
    return style_.width > 0.0 ? std::min(x, 0.5 * style_.width) : x;
  }
  Face marker_face() const { return face_of({}, style_); }
  /// The font's bullet is as heavy as bold text.
  double marker_size(const std::string& marker) const {
    return (marker == "•" ? kBulletSize : 1.0) * style_.size;
  }
  /// The digits of a raised number, of which the fonts lack some above 3; empty: the marker is none.
  static std::string raised_digits(const std::string& marker) {
    std::string digits;
    for (std::size_t at = 0; at < marker.size();) {
      const Script script = script_of(next_character(marker, at));
      if (!script.raised) return "";
      append_utf8(digits, script.character);
    }
    return digits;
  }
  /// A marker's glyphs, as large and as high as they stand.
  struct Marker {
    std::vector<ShapedGlyph> glyphs;
    double size = 0, rise = 0;
    double width() const {
      double sum = 0.0;
      for (const ShapedGlyph& g : glyphs) sum += g.advance * size;
      return sum;
    }
  };
  Marker marker_of(const std::string& marker) const {
    const std::string raised = raised_digits(marker);
    if (raised.empty()) return {fonts_.shape(marker_face(), marker), marker_size(marker), 0.0};
    return {fonts_.shape(marker_face(), raised), kScriptSize * style_.size, kScriptRise * style_.size};
  }

  void set_block(const TextBlock& block, const TextBlock* before) {
    const double x = indent_of(block.indent);
    const double width = style_.width > 0.0 ? style_.width - x : 0.0;
    Parts parts = parts_of(block, width);
    if (width > 0.0) split_wide_parts(parts, width);

    LineShape shape;
    shape.width = width;
    shape.rag = kRag * style_.size;
    shape.edge = style_.bold        ? LineShape::Edge::balanced
                 : style_.justified ? LineShape::Edge::justified
                                    : LineShape::Edge::ragged;
    const bool in_list = before != nullptr && before->indent > 0 && block.indent > 0;
    block_gap_ = before == nullptr ? 0.0 : style_.between * style_.size * (in_list ? kListBetween : 1.0);
    std::size_t begin = 0;
    for (const std::size_t end : width > 0.0 ? break_lines(parts.lines, shape) : forced_ends(parts.lines)) {
      set_line(block, parts, begin, end, x, space_change(parts.lines, begin, end, shape));
      if (begin == 0 && !block.marker.empty()) set_marker(block, x);
      begin = end;
    }
  }

  /// The lines of a text without width.
  static std::vector<std::size_t> forced_ends(const std::vector<LinePart>& lines) {
    std::vector<std::size_t> ends;
    for (std::size_t i = 0; i < lines.size(); ++i)
      if (lines[i].ends_line || i + 1 == lines.size()) ends.push_back(i + 1);
    return ends;
  }

  struct Extent {
    double ascent, depth;
  };
  Extent extent_of(const Parts& parts, std::size_t first, std::size_t last) const {
    Extent extent{metrics_.ascent * style_.size, metrics_.depth * style_.size};
    for (std::size_t a = first; a < last; ++a) {
      if (parts.atoms[a].formula < 0) continue;
      const DisplayList& formula = parts.formulas[static_cast<std::size_t>(parts.atoms[a].formula)];
      extent.ascent = std::max(extent.ascent, formula.ascent);
      extent.depth = std::max(extent.depth, formula.depth);
    }
    return extent;
  }

  /// Baseline of the next line: by the leading, and lower by whole pixels if something high is on it.
  void advance_to_line(const Extent& extent) {
    if (!has_line_) {
      list_.ascent = extent.ascent;
    } else {
      const double leading = std::round(style_.leading * style_.size + block_gap_);
      const double needed = std::ceil(line_depth_ + extent.ascent + style_.clearance * style_.size);
      y_ += std::max({1.0, leading, needed});
    }
    has_line_ = true;
    block_gap_ = 0.0;
    line_depth_ = extent.depth;
    list_.depth = std::max(list_.depth, y_ + extent.depth);
  }

  void set_line(const TextBlock& block, const Parts& parts, std::size_t begin, std::size_t end, double x,
                double change) {
    advance_to_line(extent_of(parts, parts.first_atoms[begin], parts.first_atoms[end]));
    double pen = x;
    if (flush_right_ && style_.width > 0.0)
      pen += std::max(0.0, style_.width - x - length_of(parts, begin, end));
    double right = pen;
    LinkRule link;
    for (std::size_t p = begin; p < end; ++p) {
      const LinePart& part = parts.lines[p];
      for (std::size_t a = parts.first_atoms[p]; a < parts.first_atoms[p + 1]; ++a) {
        const bool last_of_part = a + 1 == parts.first_atoms[p + 1];
        place(parts, parts.atoms[a], pen);
        follow_link(block.spans[parts.atoms[a].span], pen + parts.atoms[a].glyph.x,
                    pen + (last_of_part ? part.width : parts.atoms[a + 1].glyph.x), link);
      }
      right = pen + part.width;
      pen = right + part.space + change * (change < 0.0 ? part.shrink : part.stretch);
    }
    end_link(link);
    list_.width = std::max(list_.width, right);
  }

  static double length_of(const Parts& parts, std::size_t begin, std::size_t end) {
    double length = 0.0;
    for (std::size_t p = begin; p < end; ++p)
      length += parts.lines[p].width + (p + 1 < end ? parts.lines[p].space : 0.0);
    return length;
  }

  void place(const Parts& parts, const Atom& atom, double x) {
    if (atom.formula >= 0) {
      append(list_, parts.formulas[static_cast<std::size_t>(atom.formula)], x + atom.glyph.x, y_);
      return;
    }
    list_.glyphs.push_back(atom.glyph);
    list_.glyphs.back().x += x;
    list_.glyphs.back().y += y_;
  }

  void set_marker(const TextBlock& block, double x) {
    const Marker marker = marker_of(block.marker);
    const double size = marker.size;
    const double pen = x - kMarkerGap * style_.size - marker.width();
    const SourceSpan source = block.spans.empty() ? SourceSpan{} : block.spans.front().source;
    for (const ShapedGlyph& g : marker.glyphs) {
      const GlyphBox box = fonts_.box(marker_face(), g.id);
      const double rise = marker.rise > 0.0
                              ? marker.rise
                              : 0.5 * (box.bottom + box.top) * (style_.size - size);  // keeps its middle
      list_.glyphs.push_back({marker_face(),
                              g.id,
                              pen + g.x * size,
                              y_ - rise - g.y * size,
                              size,
                              style_.color,
                              {},
                              {source.begin, source.begin}});
    }
  }

  // ---- Tables

  /// A table's cells at one size of type.
  struct SetTable {
    double size = 0;
    std::vector<double> widths;  ///< of the columns
    std::vector<std::vector<DisplayList>> rows;
    double width() const {
      double sum = 2.0 * kTablePad * size + kColumnGap * size * static_cast<double>(widths.size() - 1);
      for (const double one : widths) sum += one;
      return sum;
    }
  };

  DisplayList cell_list(const TextTable::Cell& cell, const TextStyle& style,
                        TextTable::Align align = TextTable::Align::left) {
    TextSetter setter(style, fonts_, lenient_);
    setter.flush_right_ = align == TextTable::Align::right;
    DisplayList list = setter.set({TextBlock{.indent = 0, .marker = {}, .spans = cell}});
    std::vector<TypeError> errors = setter.take_errors();
    if (errors_.size() < kMaxTypeErrors) errors_.insert(errors_.end(), errors.begin(), errors.end());
    return list;
  }

  /// Of the widest word or formula.
  double least_width(const TextTable::Cell& cell, const TextStyle& style) {
    TextSetter setter(style, fonts_, true);
    double least = 0.0;
    for (const LinePart& part :
         setter.parts_of(TextBlock{.indent = 0, .marker = {}, .spans = cell}, 0.0).lines)
      least = std::max(least, part.width);
    return least;
  }

  /// How wide a column may be at most, so that all together lose so much.
  static double widest_column(std::vector<double> widths, double loss) {
    std::sort(widths.begin(), widths.end());
    double room = -loss;
    for (const double one : widths) room += one;
    std::size_t left = widths.size();
    for (const double one : widths) {
      if (one * static_cast<double>(left) > room) break;
      room -= one;
      --left;
    }
    return left == 0 ? widths.back() : std::max(0.0, room / static_cast<double>(left));
  }

  /// Each column as wide as its widest cell; where that is too much, the wide ones give what they have above
  /// their widest word, in proportion; where that is not enough, the type is made smaller.
  SetTable laid_out(const TextTable& table, double width) {
    TextStyle style = style_;
    style.justified = false;
    // What is as wide as its column fits into it: glyphs are set on a grid of their own.
    const auto with_room = [](double one) { return std::ceil(one) + 1.0; };
    for (SetTable made; true; style.size *= 0.93) {
      style.width = 0.0;
      made = {style.size, std::vector<double>(table.columns.size()), {}};
      std::vector<double> least(table.columns.size());
      for (const auto& row : table.rows)
        for (std::size_t c = 0; c < row.size(); ++c) {
          made.widths[c] = std::max(made.widths[c], with_room(cell_list(row[c], style).width));
          if (width > 0.0) least[c] = std::max(least[c], with_room(least_width(row[c], style)));
        }
      if (!errors_.empty()) return made;
      const double over = width > 0.0 ? made.width() - width : 0.0;
      if (over > 0.0) {
        double spare = 0.0;
        for (std::size_t c = 0; c < least.size(); ++c) spare += made.widths[c] - least[c];
        if (spare < over && style.size > kLeastTableSize * style_.size) continue;
        const double part = spare > over ? over / spare : 1.0;
        for (std::size_t c = 0; c < least.size(); ++c) made.widths[c] -= part * (made.widths[c] - least[c]);
        if (spare < over) {  // words will be broken
          const double widest = widest_column(made.widths, made.width() - width);
          if (widest < style.size && style.size > kLeastBrokenSize * style_.size) continue;
          for (double& one : made.widths) one = std::min(one, widest);
        }
      }
      for (const auto& row : table.rows) {
        made.rows.emplace_back();
        for (std::size_t c = 0; c < row.size(); ++c) {
          style.width = made.widths[c];
          made.rows.back().push_back(cell_list(row[c], style, table.columns[c]));
        }
      }
      return made;
    }
  }

  void set_table(const TextBlock& block, const TextBlock* before) {
    const double x0 = indent_of(block.indent);
    const double room = style_.width > 0.0 ? style_.width - x0 : 0.0;
    const SetTable table = laid_out(block.table, room);
    if (!errors_.empty()) return;
    const double em = table.size, width = table.width();
    const double left = x0 + (block.indent == 0 ? std::max(0.0, std::round(0.5 * (room - width))) : 0.0);
    const double heavy = std::max(1.0, std::round(kHeavyRule * em)),
                 light = std::max(1.0, std::round(kLightRule * em)), pad = kRulePad * em;
    const auto rule = [&](double y, double thickness) {
      list_.rules.push_back({left, y, left + width, y, thickness, style_.color, {}, {}});
    };
    block_gap_ = before == nullptr ? 0.0 : style_.between * style_.size;
    for (std::size_t r = 0; r < table.rows.size(); ++r) {
      const bool is_head = r == 0, is_last = r + 1 == table.rows.size();
      Extent extent{metrics_.ascent * em, metrics_.depth * em};
      for (const DisplayList& cell : table.rows[r]) {
        extent.ascent = std::max(extent.ascent, cell.ascent);
        extent.depth = std::max(extent.depth, cell.depth);
      }
      const double above = is_head ? std::ceil(extent.ascent + pad) : 0.0,
                   below = std::ceil(extent.depth + pad);
      Extent with_rules = extent;
      if (is_head) with_rules.ascent = above + heavy + (has_line_ ? kAboveTable * em : 0.0);
      if (is_head || is_last) with_rules.depth = below + (is_last ? heavy : light + pad);
      if (!is_head && !is_last) with_rules.depth += kRowGap * em;
      advance_to_line(with_rules);
      if (is_head) rule(y_ - above - 0.5 * heavy, heavy);
      if (is_last)
        rule(y_ + below + 0.5 * heavy, heavy);
      else if (is_head)
        rule(y_ + below + 0.5 * light, light);
      double x = left + kTablePad * em;
      for (std::size_t c = 0; c < table.rows[r].size(); ++c) {
        const DisplayList& cell = table.rows[r][c];
        const double free = table.widths[c] - cell.width;
        const TextTable::Align align = block.table.columns[c];
        const double shift = align == TextTable::Align::left    ? 0.0
                             : align == TextTable::Align::right ? free
                                                                : 0.5 * free;
        append(list_, cell, x + shift, y_);
        x += table.widths[c] + kColumnGap * em;
      }
    }
    line_depth_ += kBelowTable * em;
    list_.width = std::max(list_.width, left + width);
  }

  // ---- The line below a link

  struct LinkRule {
    const TextSpan* first = nullptr;  ///< of the spans with this link
    double x0 = 0, x1 = 0;
    SourceSpan source;
  };
  void follow_link(const TextSpan& span, double x0, double x1, LinkRule& link) {
    if (link.first != nullptr && link.first->link != span.link) end_link(link);
    if (span.link.empty()) return;
    if (link.first == nullptr) link = {&span, x0, x1, span.source};
    link.x1 = x1;
    link.source.end = std::max(link.source.end, span.source.end);
  }
  void end_link(LinkRule& link) {
    if (link.first != nullptr) {
      const double thickness = std::max(1.0, std::round(kLinkThickness * style_.size));
      const double y = y_ + std::round(kLinkDrop * style_.size) + 0.5 * thickness;
      list_.rules.push_back({link.x0, y, link.x1, y, thickness, style_.link_color, {}, link.source});
    }
    link.first = nullptr;
  }

  const TextStyle& style_;
  const Fonts& fonts_;
  Metrics metrics_;
  bool lenient_;
  bool flush_right_ = false;       // lines of a cell, in the whole width
  std::map<int, double> indents_;  // steps of the levels of lists
  std::vector<TypeError> errors_;

  DisplayList list_;
  bool has_line_ = false;
  double y_ = 0;           // of the last baseline
  double line_depth_ = 0;  // of the last line
  double block_gap_ = 0;   // before the next line

  // Of the run being shaped; kept to save their memory.
  std::string run_;
  std::vector<std::uint32_t> begins_;
};

TextSpan plain_span(std::string_view line, std::size_t begin, std::size_t end) {
  TextSpan span;
  for (std::size_t i = begin; i < end; ++i) {
    if (line[i] == '\\' && i + 1 < end && line[i + 1] == '$') continue;
    span.text += line[i];
  }
  span.source = {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
  return span;
}

/// A formula that cannot be set is shown as it is written.
TextSpan formula_span(std::string_view line, SourceSpan source, const TextStyle& style, const Fonts& fonts) {
  const std::string_view tex = line.substr(source.begin, source.end - source.begin);
  TextSpan span;
  span.source = source;
  if (auto math = parse_math(tex)) {
    MathStyle math_style;
    math_style.size = style.size;
    if (set_math(*math, math_style, fonts)) {
      span.kind = TextSpan::Kind::math;
      span.text = tex;
      span.math = std::move(*math);
      return span;
    }
  }
  return plain_span(line, source.begin - 1, source.end + 1);
}

}  // namespace

Result<DisplayList, std::vector<TypeError>> set_text(const RichText& text, const TextStyle& style,
                                                     const Fonts& fonts) {
  TextSetter setter(style, fonts, false);
  DisplayList list = setter.set(text);
  std::vector<TypeError> errors = setter.take_errors();
  if (!errors.empty()) return Failure{std::move(errors)};
  return list;
}

DisplayList set_lines(std::string_view text, const TextStyle& style, const Fonts& fonts) {
  TextBlock block;
  std::size_t at = 0;
  for (const SourceSpan& formula : formulas_of_line(text)) {
    if (formula.begin > at + 1) block.spans.push_back(plain_span(text, at, formula.begin - 1));
    block.spans.push_back(formula_span(text, formula, style, fonts));
    at = formula.end + 1;
  }
  if (at < text.size()) block.spans.push_back(plain_span(text, at, text.size()));
  return TextSetter(style, fonts, true).set({block});
}

DisplayList set_line(std::string_view text, const TextStyle& style, const Fonts& fonts) {
  TextStyle one_line = style;
  one_line.width = 0.0;
  return set_lines(text, one_line, fonts);
}

}  // namespace polhode
