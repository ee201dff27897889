// SPDX-License-Identifier: MIT
// Mathematics in TeX's notation: parsed without fonts, then set by the rules of TeX (D. E. Knuth, The
// TeXbook, Appendix G) with the measures of the font's OpenType MATH table.
#pragma once

#include "base/words/language.h"
#include "render/typeset/fonts.h"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

inline constexpr std::size_t kMaxMathBytes = 8192;
/// Braces, \left, \begin, and macros inside macros nest at most so deep.
inline constexpr int kMaxMathNesting = 64;

/// `\name` stands for `body`, in which #1…#9 are its arguments.
struct MathMacro {
  int arguments = 0;
  std::string body;
};
using MathMacros = std::map<std::string, MathMacro, std::less<>>;

/// \live[digits=3, unit={rad/s}]{expression}: a number that whoever shows the formula puts in; and
/// \value[unit={s}]{0.75}{expression}: one that is shown as it is typed, and is to be that of the expression.
struct LiveNumber {
  std::string expression;  ///< as it is written
  std::size_t offset = 0;  ///< byte where it begins
  int digits = 0;          ///< significant ones, up to kMaxLiveDigits; 0: not said
  std::string unit{};      ///< as it is written; set behind the number
  std::size_t unit_offset = 0;
  std::string typed{};  ///< of \value: "-0.75", "2.25e4"; empty: \live
  std::size_t typed_offset = 0;
  SourceSpan whole{};  ///< with its command
  int id = -1;         ///< for whoever keeps the formula: which number it is of all that are kept
};
inline constexpr int kMaxLiveDigits = 15;
/// The unit behind a number, as TeX: upright after a thin space, its powers raised; a degree is ° and close
/// to the number, "1" is nothing.
std::string unit_tex(std::string unit);
/// What stands in its place until a number is put in.
inline constexpr std::string_view kLiveRoom = "−0.00";
/// The name of a number's term in a formula: that of its index in Math::live.
std::string live_name(std::size_t index);

/// \eqref{id}: shows the number of another formula.
struct MathReference {
  std::string id;          ///< as it is written
  std::size_t offset = 0;  ///< byte where it begins
};

struct MathNode;  // render/typeset/math/tree.h

/// A formula that reads without errors.
struct Math {
  std::shared_ptr<const MathNode> root;
  std::string tag;                          ///< of \tag{…}; empty: none
  std::vector<std::string> terms;           ///< ids of \term{id}{…}, in their order
  std::vector<LiveNumber> live;             ///< in their order
  std::vector<MathReference> references{};  ///< in their order
  std::vector<std::size_t> tag_offsets,
      term_offsets;      ///< bytes where each name begins; several tags are joined
  std::size_t made = 0;  ///< so many signs the author's macros stand for, with all of theirs
  /// Whose decimal mark its numbers are shown and spoken with; read, and here, they have points.
  Language language = Language::en;
};

/// All that is wrong is reported, up to 16 errors, in the order of their offsets. Linear in the formula's
/// length.
Result<Math, std::vector<TypeError>> parse_math(std::string_view tex, const MathMacros& macros = {},
                                                Language language = Language::en);

/// Where a reference leads, and what it shows.
struct ShownReference {
  std::string link;  ///< the name of its glyphs (DisplayList::names)
  std::string number;
};
/// The formula with "(number)" for each reference whose id is known; before that all show "(?)".
Math with_references(const Math& math, const std::map<std::string, ShownReference>& shown);

/// What is put in for a number.
struct ShownNumber {
  Math number;
  std::string name{};  ///< of its glyphs (DisplayList::names); empty: none
};
/// The formula with these in the place of its \live numbers, one for each of Math::live; those of \value
/// stay.
Math with_numbers(const Math& math, const std::vector<ShownNumber>& shown);

/// A symbol of a lesson: wherever its formula stands, it has its colour and its name.
struct MathSymbol {
  std::string name;
  Math math;
  Color color;
};

struct MathStyle {
  double size = 24;      ///< em, px
  bool display = false;  ///< large operators with limits above and below, full fractions
  Color color;
  std::optional<Color> strike = {};  ///< of \cancel's strokes; absent: that of what they strike
  double line_width = 0;             ///< px; a longer formula is broken; 0: never
  const std::vector<MathSymbol>* symbols = nullptr;  ///< looked for; may be null
};

/// A formula without its tag. Sizes in px; a broken display has more than one line below the first baseline.
/// Characters that the fonts lack are errors.
Result<DisplayList, std::vector<TypeError>> set_math(const Math& math, const MathStyle& style,
                                                     const Fonts& fonts);

/// What a reader would say, in the language of the formula: "d L over d t equals N". `say` gives the words of
/// a symbol's name, empty: none.
std::string spoken(const Math& math, const std::vector<MathSymbol>& symbols,
                   const std::function<std::string(std::string_view symbol)>& say);

}  // namespace polhode
