// SPDX-License-Identifier: MIT
// A formula as a tree: what the reader of TeX makes, and what is set and spoken.
#pragma once

#include "base/color.h"
#include "render/typeset/display_list.h"
#include "render/typeset/math/math.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace polhode {

/// Classes of atoms (The TeXbook, chapter 17): they decide the space between neighbours.
enum class MathClass : std::uint8_t {
  ordinary,
  large,
  binary,
  relation,
  opening,
  closing,
  punctuation,
  inner
};

/// Which letters a letter is set in.
enum class Alphabet : std::uint8_t {
  normal,  ///< italic, but upright digits and capital Greek
  upright,
  bold,
  italic,
  bold_italic,
  script,
  blackboard,
  fraktur,
  sans,
  mono
};

/// Where sub- and superscripts of an operator go.
enum class Limits : std::uint8_t { beside, in_display, above_below };

/// Cells in rows and columns.
struct MathGrid {
  enum class Kind : std::uint8_t { matrix, small, cases, aligned, gathered, array } kind = Kind::matrix;
  int columns = 0;
  char32_t left = 0, right = 0;        ///< delimiters; 0: none
  std::string places;                  ///< of array: l, c or r for each column
  std::vector<int> columns_with_line;  ///< a line stands before them; `columns`: after the last
  std::vector<int> rows_with_line;     ///< a line stands above them; one past the last: below all
  std::vector<double> skips;           ///< more space below each row, em
  bool operator==(const MathGrid&) const = default;
};

/// The name of the term that \proved{…} makes: no id of an author has a blank.
inline constexpr std::string_view kProvedPart = "proved part";

/// Begins the name of the term that \eqref{…} makes until it is known where it leads.
inline constexpr std::string_view kReferenceMark = "#";

struct MathNode {
  /// What `children` are is said after each; `nothing` stands for one that is absent.
  enum class Kind : std::uint8_t {
    nothing,
    row,        ///< atoms beside each other: a group in braces, an argument
    alphabet,   ///< the same, but its atoms keep their classes: \mathbf{…}
    symbol,     ///< `character`, `alphabet`
    text,       ///< `text`, `face`, `sources`; class `large`: a named operator
    space,      ///< `amount` em
    style,      ///< the rest of the row in the style `amount`: 0 display … 3 scriptscript
    color,      ///< contents; `color`
    term,       ///< contents; `text` is the id
    scripts,    ///< nucleus, sub, sup
    fraction,   ///< numerator, denominator; `amount` 0 without bar; `forced_style`; `delimiters`
    radical,    ///< radicand, degree
    accent,     ///< base; `character`; `wide`: as wide as the base
    bar,        ///< contents; `character` '-' above, '_' below
    brace,      ///< contents; `character` U+23DE above, U+23DF below; its scripts are labels
    stacked,    ///< base, above, below: \overset, \underset
    arrow,      ///< above, below; `character` is stretched to them
    fenced,     ///< delimiter, row, delimiter, row, … , delimiter
    delimiter,  ///< `character`, 0: none; `amount` > 0: height + depth in em (\big)
    grid,       ///< cells, row by row; `grid`
    cancel,     ///< contents; `character` '/', '\\' or 'x'; 'n': a slash through a relation
    box,        ///< contents
    phantom     ///< contents; `amount` bits: 1 keeps the width, 2 the height and depth
  };

  Kind kind = Kind::nothing;
  MathClass atom = MathClass::ordinary;
  Alphabet alphabet = Alphabet::normal;
  Limits limits = Limits::beside;
  Face face = Face::serif;
  bool wide = false;
  bool binomial = false;  ///< a fraction in parentheses
  int forced_style = -1;  ///< of a fraction: 0 \dfrac, 1 \tfrac
  char32_t character = 0;
  double amount = 0;
  Color color;
  SourceSpan span;
  std::string text;
  std::vector<SourceSpan> sources;  ///< of each character of `text`
  std::vector<MathNode> children;
  std::shared_ptr<const MathGrid> grid;

  bool absent() const { return kind == Kind::nothing; }
};

/// The only child of a row in a row …; a group in braces around one atom is that atom.
const MathNode& without_groups(const MathNode& node);

/// Whether both are the same mathematics, wherever they stand in their sources.
bool same_math(const MathNode& a, const MathNode& b);

/// As it is shown and spoken: where the formula's language has decimal commas, its numbers have them.
std::shared_ptr<const MathNode> with_decimals(const Math& math);
/// A comma without space behind it: one that parts decimals, not the entries of a list.
bool is_decimal_comma(const MathNode& node);

/// The index in Math::live of the number whose term a node is (live_name); nothing of other nodes.
std::optional<std::size_t> index_of_live(const MathNode& node);

}  // namespace polhode
