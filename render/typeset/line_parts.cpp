// SPDX-License-Identifier: MIT
#include "render/typeset/line_parts.h"

#include "render/typeset/characters.h"

#include <algorithm>
#include <optional>
#include <string_view>

namespace polhode {
namespace {

constexpr int kMaxFormulaTries = 12;  // to make one narrow enough

// Lengths in em of the text.
constexpr double kSpaceStretch = 0.5;  // of a word space
constexpr double kSpaceShrink = 0.28;  // of a word space
constexpr double kShortFormula = 1.6;  // a name of something, which belongs to the word before it

/// Of the size at which the x-heights are equal: the letters of a typewriter are so wide that they look
/// larger.
constexpr double kMonoSize = 0.92;

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

/// Units in one word that lessons have behind a number.
bool is_unit(std::u32string_view word) {
  constexpr std::array<std::u32string_view, 28> kUnits = {
      U"%",   U"°",  U"deg", U"rad", U"mrad", U"rad/s", U"rad/s²", U"deg/s", U"s",    U"ms",
      U"min", U"h",  U"Hz",  U"m",   U"cm",   U"mm",    U"km",     U"m/s",   U"m/s²", U"kg",
      U"g",   U"mg", U"N",   U"kN",  U"J",    U"mJ",    U"W",      U"years"};
  return std::ranges::find(kUnits, word) != kUnits.end();
}

/// Where a byte of a span's text comes from. A text that is not its source (an entity) comes from all of it.
SourceSpan source_of(const TextSpan& span, std::size_t begin, std::size_t end) {
  if (span.text.size() != span.source.end - span.source.begin) return span.source;
  return {span.source.begin + static_cast<std::uint32_t>(begin),
          span.source.begin + static_cast<std::uint32_t>(end)};
}

class PartMaker {
 public:
  explicit PartMaker(const TextSetting& setting)
      : style_(setting.style),
        fonts_(setting.fonts),
        metrics_(setting.metrics),
        lenient_(setting.lenient),
        list_(setting.list),
        errors_(setting.errors) {}

  TextParts parts_of(const TextBlock& block, double width) {
    const std::vector<Element> elements = elements_of(block);
    TextParts parts;
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
        if (!span.code) element.character = curled(c, character_before(into));
        check_character(element);
        if (element.character >= 0x80) choose_face(element, into);
      }
      into.push_back(element);
    }
  }

  /// At the beginning of a line as behind a space; 0 is none, that of a formula.
  static char32_t character_before(const std::vector<Element>& before) {
    if (before.empty() || before.back().kind == Element::Kind::line_end) return U' ';
    return before.back().kind == Element::Kind::character ? before.back().character : 0;
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

  static void begin_part(TextParts& parts) {
    parts.first_atoms.push_back(parts.atoms.size());
    parts.lines.emplace_back();
  }
  static void drop_part(TextParts& parts) {
    parts.first_atoms.pop_back();
    parts.lines.pop_back();
  }
  static void end_part(TextParts& parts, double space, bool ends_line = false, double penalty = 0.0) {
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
               std::size_t last, TextParts& parts) {
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
      TextAtom atom;
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

  void add_space(double width, double penalty, TextParts& parts) {
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

  void add_formula(const TextSpan& span, std::uint32_t index, double width, TextParts& parts) {
    auto formula = formula_of(span, width);
    if (!formula) return;
    const double em = style_.size;
    const std::size_t part_index = parts.lines.size() - 1;
    const bool begins_part = parts.first_atoms.back() == parts.atoms.size();
    if (begins_part && part_index > 0 && formula->width < kShortFormula * em) {
      LinePart& before = parts.lines[part_index - 1];
      before.penalty = std::max(before.penalty, kBeforeShortFormula);
    }
    TextAtom atom;
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

  const TextStyle& style_;
  const Fonts& fonts_;
  const TextMetrics& metrics_;
  bool lenient_;
  DisplayList& list_;
  std::vector<TypeError>& errors_;

  // Of the run being shaped; kept to save their memory.
  std::string run_;
  std::vector<std::uint32_t> begins_;
};

/// Where what follows an atom of a part begins.
double next_x(const TextParts& parts, std::size_t part, std::size_t atom) {
  for (std::size_t a = atom + 1; a < parts.first_atoms[part + 1]; ++a)
    if (parts.atoms[a].is_cluster) return parts.atoms[a].glyph.x;
  return parts.lines[part].width;
}

}  // namespace

TextMetrics::TextMetrics(const TextStyle& style, const Fonts& fonts) : sans(style.sans) {
  const auto height = [&fonts](Face face, char32_t c) { return fonts.box(face, *fonts.glyph(face, c)).top; };
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

Face face_of(const TextSpan& span, const TextStyle& style) {
  const bool bold = span.bold || style.bold;
  if (span.code) return Face::mono;
  if (style.sans) return bold ? Face::sans_bold : Face::sans;
  if (bold) return span.italic ? Face::serif_bold_italic : Face::serif_bold;
  return span.italic ? Face::serif_italic : Face::serif;
}

TextParts parts_of(const TextBlock& block, double width, const TextSetting& setting) {
  return PartMaker(setting).parts_of(block, width);
}

void split_wide_parts(TextParts& parts, double width) {
  if (std::none_of(parts.lines.begin(), parts.lines.end(),
                   [width](const LinePart& p) { return p.width > width; }))
    return;
  TextParts split;
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

}  // namespace polhode
