// SPDX-License-Identifier: MIT
// What stands behind set_math(). The rules named are those of The TeXbook, Appendix G. Internal to
// render/typeset/math/.
#pragma once

#include "render/typeset/math/constants.h"
#include "render/typeset/math/delimiters.h"
#include "render/typeset/math/math.h"
#include "render/typeset/math/symbols.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace polhode {

/// Display, text, script, scriptscript; cramped: exponents stand lower.
struct MathTextStyle {
  int level = 1;
  bool cramped = false;

  bool is_display() const { return level == 0; }
  bool is_script() const { return level >= 2; }
};
inline MathTextStyle cramped(MathTextStyle s) { return {s.level, true}; }
inline MathTextStyle superscript(MathTextStyle s) { return {std::min(s.level < 2 ? 2 : 3, 3), s.cramped}; }
inline MathTextStyle subscript(MathTextStyle s) { return {superscript(s).level, true}; }
inline MathTextStyle numerator(MathTextStyle s) { return {std::min(s.level + 1, 3), s.cramped}; }
inline MathTextStyle denominator(MathTextStyle s) { return {std::min(s.level + 1, 3), true}; }

struct MathPaint {
  Color color;
  bool fixed_color = false;  ///< \textcolor wins over the colour of symbols
  bool sealed = false;       ///< inside of a symbol of one atom none is looked for
  Naming naming;
};

/// How much of the list is made: what lies between two marks can be moved.
struct MathMark {
  std::size_t glyphs = 0, rules = 0;
};

/// Something set with its origin at (0, 0): px, `height` and `depth` from the baseline.
struct MathBox {
  double width = 0, height = 0, depth = 0;
  double italic = 0;                   ///< correction, not part of the width
  std::optional<double> attachment;    ///< x of an accent's middle; none: the middle
  std::optional<std::uint32_t> glyph;  ///< it is this one, or has its shape below accents
};

/// One atom of a row.
struct MathAtom {
  const MathNode* node = nullptr;
  MathPaint paint;
  MathTextStyle style;
  MathClass atom = MathClass::ordinary;
  const MathSymbol* base_symbol = nullptr;  ///< nucleus and subscript of these scripts are a symbol
};

/// An item in its place: a line may be broken before it.
struct PlacedAtom {
  MathMark begin;
  double x = 0;  ///< its left edge; the space before it lies to the left
  double end = 0;
  double height = 0, depth = 0;
  MathClass atom = MathClass::ordinary;
  double space = 0;  ///< of a space in the source, em
};

class MathLayout {
 public:
  MathLayout(const MathStyle& style, const Fonts& fonts)
      : style_(style), fonts_(fonts), font_(fonts), symbols_(style.symbols) {}
  Result<DisplayList, std::vector<TypeError>> run(const MathNode& root);

 private:
  // --- measures -----------------------------------------------------------------------------------------
  double size(MathTextStyle s) const;
  double measure(hb_ot_math_constant_t constant, MathTextStyle s) const { return font_[constant] * size(s); }
  double axis(MathTextStyle s) const { return font_.axis() * size(s); }
  double rule_thickness(MathTextStyle s) const { return font_.rule() * size(s); }

  // --- the list -----------------------------------------------------------------------------------------
  MathMark mark() const { return {out_.glyphs.size(), out_.rules.size()}; }
  void shift(MathMark begin, MathMark end, double dx, double dy);
  void shift(MathMark begin, double dx, double dy) { shift(begin, mark(), dx, dy); }
  /// Glyphs made since `made` are read before those since `begin`.
  void read_first(MathMark begin, MathMark made);
  void put_glyph(Face face, std::uint32_t id, double x, double y, double size, const MathPaint& paint,
                 SourceSpan source);
  void put_rule(double x0, double y0, double x1, double y1, double thickness, const MathPaint& paint,
                SourceSpan source);
  void fail(SourceSpan at, char32_t character);

  // --- symbols of the lesson ----------------------------------------------------------------------------
  MathPaint named(const MathPaint& paint, const MathSymbol& symbol, bool sealed);

  // --- rows ---------------------------------------------------------------------------------------------
  /// The atoms of a row; those of terms, colours and alphabets are atoms of the row they stand in.
  void flatten(const MathNode& node, MathTextStyle& style, const MathPaint& paint,
               std::vector<MathAtom>& into);
  void flatten_all(const std::vector<MathNode>& children, MathTextStyle& style, const MathPaint& paint,
                   std::vector<MathAtom>& into);
  /// A group in braces is one atom of its row.
  void flatten_child(const MathNode& child, MathTextStyle& style, const MathPaint& paint,
                     std::vector<MathAtom>& into);
  std::vector<MathAtom> items_of(const MathNode& node, MathTextStyle style, const MathPaint& paint,
                                 bool continues = false);
  /// An argument without braces.
  void flatten_single(const MathNode& node, MathTextStyle style, const MathPaint& paint,
                      std::vector<MathAtom>& into);
  /// Contents of an argument, a cell, a group: atoms with the space between them. In a cell behind & the
  /// first atom stands as if something were before it.
  MathBox row(const MathNode& node, MathTextStyle style, const MathPaint& paint,
              std::vector<PlacedAtom>* placed = nullptr, bool continues = false);
  /// A field that is one atom keeps its shape: a character's scripts and accents stand closer.
  MathBox nucleus(const MathNode& node, MathTextStyle style, const MathPaint& paint);
  MathBox atom(const MathAtom& item);
  /// Braces, or \mathrel{…}: its argument is its only child.
  MathBox group(const MathAtom& item) { return row(*item.node, item.style, item.paint); }

  // --- characters ---------------------------------------------------------------------------------------
  struct Found {
    Face face = Face::math;
    std::uint32_t glyph = 0;
  };
  std::optional<Found> find_glyph(char32_t character, Alphabet alphabet, MathTextStyle style) const;
  MathBox symbol(const MathAtom& item);
  MathBox plain_glyph(const Found& found, const MathAtom& item);
  MathBox math_glyph(std::uint32_t glyph, const MathAtom& item);
  /// Rule 13: larger in displays, its middle on the axis.
  MathBox large_operator(std::uint32_t glyph, const MathAtom& item);
  std::uint32_t stretched_single(std::uint32_t glyph, double length) const;
  MathBox text(const MathAtom& item);
  void put_text_glyph(Face face, std::uint32_t id, double x, double y, double s, const MathPaint& paint,
                      SourceSpan source, MathBox& box);
  /// The characters of a text, in their order.
  struct Clusters {
    const MathNode& node;
    std::size_t at = 0, index = 0;
    char32_t character = 0;
    SourceSpan source;
    /// Goes on to the character at a byte; its source reaches to the next glyph's at most.
    void go_to(std::size_t byte);
  };

  // --- scripts ------------------------------------------------------------------------------------------
  /// Rule 18.
  MathBox scripts(const MathAtom& item);
  /// Rule 18e.
  void keep_scripts_apart(const MathBox& sub, const MathBox& sup, MathTextStyle style, double& raise,
                          double& lower) const;
  /// Moves a script to its base as far as the corners of both allow, at the script's near edge and at the
  /// base's far edge.
  double corner_kern(const MathBox& base, MathMark begin, MathMark end, double offset, const MathBox& script,
                     MathTextStyle style, bool above) const;
  static bool has_limits(const MathNode& node, MathTextStyle style);
  /// Rule 13a.
  MathBox limits(const MathAtom& item);
  struct Gaps {
    hb_ot_math_constant_t above, above_baseline, below, below_baseline;
  };
  /// What stands above and below a base: set, but not yet in its place.
  struct Labels {
    MathMark begin, above_begin, end;  // the lower one comes first
    std::optional<MathBox> above, below;
  };
  Labels set_labels(const MathAtom& item, const MathNode& above, const MathNode& below);
  /// The base is what was made since `begin` and is no label.
  MathBox above_and_below(const MathAtom& item, MathMark begin, const MathBox& base, const Labels& labels,
                          double lean, const Gaps& gaps);

  // --- fractions and radicals ---------------------------------------------------------------------------
  /// Rule 15.
  MathBox fraction(const MathAtom& item);
  /// TeX's \nulldelimiterspace of 1.2 pt, em.
  static constexpr double kNoDelimiter = 0.12;
  /// Around \binom; its width.
  double fraction_delimiter(char32_t character, const MathAtom& item, MathTextStyle style,
                            const MathBox& inside, double x);
  /// Rule 11, with the sign's foot and the degree as the MATH table has it.
  MathBox radical(const MathAtom& item);

  // --- delimiters ---------------------------------------------------------------------------------------
  /// A vertical stretch, its lower end `bottom` above the baseline if it is of parts; one glyph stands as the
  /// font has it.
  MathBox put_vertical(const StretchedGlyph& sign, double bottom, MathTextStyle style, const MathPaint& paint,
                       SourceSpan span);
  /// Rule 19: how long a delimiter around contents that reach `half` from the axis is.
  double delimiter_length(double half, MathTextStyle style) const;
  /// A delimiter of at least the length, centred on the axis.
  MathBox delimiter(char32_t character, double length, MathTextStyle style, const MathPaint& paint,
                    SourceSpan span);
  /// Tall bars are rules: even, and without joints.
  MathBox bars(char32_t character, double length, MathTextStyle style, const MathPaint& paint,
               SourceSpan span);
  MathBox big_delimiter(const MathAtom& item);
  MathBox fenced(const MathAtom& item);

  // --- above, below, around -----------------------------------------------------------------------------
  /// Rule 12.
  MathBox accent(const MathAtom& item);
  static bool is_arrow(char32_t accent) { return accent == 0x20D7 || accent == 0x20D6 || accent == 0x20E1; }
  std::optional<std::uint32_t> accent_glyph(const MathNode& node, double base_em) const;
  /// Where an accent's middle is; four dots are drawn by the font beside their attachment.
  double middle_of_accent(std::uint32_t glyph, const GlyphBox& ink) const;
  /// i and j lose their dots below accents.
  MathBox dotless_base(const MathNode& node, MathTextStyle style, const MathPaint& paint);
  /// An arrow as wide as what stands below it.
  MathBox arrow_accent(const MathAtom& item, const MathBox& base, std::uint32_t glyph);
  /// From x = 0; parts stand at the font's own height.
  MathBox put_horizontal(const StretchedGlyph& sign, MathTextStyle style, const MathPaint& paint,
                         SourceSpan span);
  /// Rules 9 and 10.
  MathBox bar(const MathAtom& item);
  MathBox brace(const MathAtom& item);
  MathBox stacked(const MathAtom& item);
  static MathBox with_italic(MathBox box);
  /// \xrightarrow: as long as its labels.
  MathBox arrow(const MathAtom& item);
  MathBox cancel(const MathAtom& item);
  MathBox framed(const MathAtom& item);
  MathBox phantom(const MathAtom& item);

  // --- grids --------------------------------------------------------------------------------------------
  /// How a kind of grid is spaced, em: TeX's struts and skips for a ten-point font on twelve points.
  struct Spacing {
    double strut_height = 0, strut_depth = 0;  ///< of each row at least
    double leading = 0;                        ///< more between rows
    double gap = 0;                            ///< between ink of neighbouring rows at least
    double between = 0;                        ///< columns
    double outside = 0;
    bool trimmed = false;  ///< the struts of the first and the last row do not count outwards
  };
  static Spacing spacing_of(const MathGrid& grid);
  static MathTextStyle cell_style(MathGrid::Kind kind, MathTextStyle style);
  /// Part of the room beside a cell that goes to its left.
  static double room_left(const MathGrid& grid, std::size_t column);
  MathBox grid(const MathAtom& item);
  static MathBox beside(const MathBox& a, const MathBox& b);
  /// Measured by setting it once.
  double delimiter_width(char32_t character, double length, MathTextStyle style);
  static double ink_height(const std::vector<MathBox>& cells, std::size_t columns, std::size_t r);
  static double ink_depth(const std::vector<MathBox>& cells, std::size_t columns, std::size_t r);
  void grid_lines(const MathAtom& item, const MathGrid& grid, const std::vector<double>& lefts,
                  const std::vector<double>& widths, const std::vector<double>& baselines,
                  const std::vector<double>& heights, const std::vector<double>& depths, double width,
                  double top, double between);

  // --- lines of a long display --------------------------------------------------------------------------
  struct Line {
    std::size_t begin = 0, end = 0;  ///< items
  };
  /// How gladly a line is broken before an item: 0 at a wide space, 1 at a relation, 2 at a binary operator,
  /// 3 never.
  static int break_rank(const PlacedAtom& placed);
  /// Items [begin, end) of the line that begins at `begin`: as many as fit, and rather up to a relation than
  /// to a binary operator.
  Line line_from(const std::vector<PlacedAtom>& placed, std::size_t begin, double room) const;
  void break_lines(const std::vector<PlacedAtom>& placed);
  const MathStyle& style_;
  const Fonts& fonts_;
  MathFont font_;
  MathSymbols symbols_;
  DisplayList out_;
  std::vector<TypeError> errors_;
};

}  // namespace polhode
