// SPDX-License-Identifier: MIT
#include "base/words/formula_words.h"
#include "render/typeset/characters.h"
#include "render/typeset/math/commands.h"
#include "render/typeset/math/symbols.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

namespace polhode {
namespace {

using Kind = MathNode::Kind;
using Atoms = std::span<const MathNode>;

/// A space so wide, in em, parts what is said.
constexpr double kWideSpace = 0.99;

template <std::size_t kCount>
const Phrase* words_of(const std::array<words::SignWords, kCount>& table, char32_t sign) {
  const auto found = std::find_if(table.begin(), table.end(),
                                  [sign](const words::SignWords& row) { return row.sign == sign; });
  return found == table.end() ? nullptr : &found->words;
}

bool is_bar(const MathNode& n) {
  if (n.kind == Kind::scripts) return is_bar(n.children[0]);
  return n.kind == Kind::symbol && n.character == U'|' && n.atom != MathClass::relation;
}

/// \left| … \right|.
bool is_magnitude(const MathNode& n) {
  const auto is_fence = [](const MathNode& child) {
    return child.kind == Kind::delimiter && child.character == U'|';
  };
  return n.kind == Kind::fenced && n.children.size() == 3 && is_fence(n.children.front()) &&
         is_fence(n.children.back());
}

/// In a group of its own, too: a sign between numbers is set so, without the spaces of an operation.
bool is_product_sign(const MathNode& n) {
  const MathNode& sign = without_groups(n);
  return sign.kind == Kind::symbol && (sign.character == U'×' || sign.character == U'⋅');
}

bool is_seen(const MathNode& n) {
  return n.kind != Kind::style && n.kind != Kind::phantom && n.kind != Kind::nothing && n.kind != Kind::space;
}

bool has_vector(const MathNode& n);

/// Magnitudes are numbers.
bool has_vector(Atoms atoms) {
  bool inside_bars = false;
  for (const MathNode& atom : atoms) {
    if (is_bar(atom))
      inside_bars = !inside_bars;
    else if (!inside_bars && has_vector(atom))
      return true;
  }
  return false;
}

/// Whether an arrow or a hat stands in it, a bold letter, nabla or a matrix. Not every letter of a vector has
/// one of them, but then nobody could tell.
bool has_vector(const MathNode& n) {
  constexpr char32_t kHat = 0x0302;
  switch (n.kind) {
    case Kind::symbol:
      return n.character == U'∇' || n.alphabet == Alphabet::bold || n.alphabet == Alphabet::bold_italic;
    case Kind::accent:
      return n.character == kHat || words_of(words::kAccents, n.character) == nullptr ||
             has_vector(n.children[0]);
    case Kind::scripts:
      return without_groups(n.children[2]).character != U'2' && has_vector(n.children[0]);
    case Kind::fraction:
      return has_vector(n.children[0]);
    case Kind::grid:
      return n.grid->kind == MathGrid::Kind::matrix || n.grid->kind == MathGrid::Kind::small;
    case Kind::radical:
      return false;
    default:
      return !is_magnitude(n) && has_vector(Atoms(n.children));
  }
}

bool ends_operand(const MathNode& n) {
  return n.atom == MathClass::binary || n.atom == MathClass::relation || n.atom == MathClass::punctuation ||
         (n.kind == Kind::space && n.amount >= kWideSpace);
}

/// What stands before atoms[i] up to the sign before it, parentheses whole.
Atoms operand_before(Atoms atoms, std::size_t i) {
  std::size_t begin = i;
  for (int depth = 0; begin > 0; --begin) {
    const MathNode& n = atoms[begin - 1];
    depth += n.atom == MathClass::closing ? 1 : n.atom == MathClass::opening ? -1 : 0;
    if (depth < 0 || (depth == 0 && ends_operand(n))) break;
  }
  return atoms.subspan(begin, i - begin);
}

Atoms operand_behind(Atoms atoms, std::size_t i) {
  std::size_t end = i + 1;
  for (int depth = 0; end < atoms.size(); ++end) {
    const MathNode& n = atoms[end];
    depth += n.atom == MathClass::opening ? 1 : n.atom == MathClass::closing ? -1 : 0;
    if (depth < 0 || (depth == 0 && ends_operand(n))) break;
  }
  return atoms.subspan(i + 1, end - i - 1);
}

/// Whether the sign of a product is that of vectors, or of tensors, and not "times". Where nothing stands on
/// one side, as at the start of a line that goes on, the other decides.
bool joins_vectors(Atoms atoms, std::size_t i) {
  const Atoms before = operand_before(atoms, i), behind = operand_behind(atoms, i);
  if (before.empty()) return behind.empty() || has_vector(behind);
  return has_vector(before) && (behind.empty() || has_vector(behind));
}

/// Whether what stands from atoms[i] on multiplies what stands before it; `at_end`: what if nothing does.
bool begins_factor(Atoms atoms, std::size_t i, bool at_end) {
  for (; i < atoms.size(); ++i) {
    const MathNode& n = atoms[i];
    if (n.kind == Kind::space && n.amount >= kWideSpace) return false;
    if (!is_seen(n)) continue;
    if (is_product_sign(n)) return true;
    if (n.kind == Kind::symbol && n.character == U'.') return false;
    if (n.kind == Kind::text) return n.atom == MathClass::large;  // \sin, but no word and no unit
    return n.atom == MathClass::ordinary || n.atom == MathClass::opening || n.atom == MathClass::large ||
           n.atom == MathClass::inner;
  }
  return at_end;
}

/// The d of dt, d²r or d*A, of ∂x or Δx.
bool is_differential_sign(const MathNode& n) {
  const MathNode& inner = without_groups(n);
  if (inner.kind == Kind::scripts)
    return inner.children[1].absent() && is_differential_sign(inner.children[0]);
  constexpr std::u32string_view kSigns = U"d∂Δδ";
  return inner.kind == Kind::symbol && kSigns.find(inner.character) != std::u32string_view::npos;
}

/// dt, dt².
bool is_differential(const MathNode& n) {
  return n.kind == Kind::row && n.children.size() > 1 && is_differential_sign(n.children.front());
}

bool is_digit(const MathNode& n) {
  return n.kind == Kind::symbol &&
         ((U'0' <= n.character && n.character <= U'9') || n.character == U'.' || is_decimal_comma(n));
}

class FormulaSpeaker {
 public:
  FormulaSpeaker(const std::vector<MathSymbol>& symbols,
                 const std::function<std::string(std::string_view)>& say, Language language)
      : symbols_(&symbols), say_(say), language_(language) {}

  std::string run(const MathNode& root) {
    // A sign that stands alone, as the label of an arrow, relates nothing to nothing.
    const MathNode& alone = without_groups(root);
    if (const Phrase* part = alone.kind == Kind::symbol ? words_of(words::kParts, alone.character) : nullptr)
      word(*part);
    else
      node(root);
    return std::move(text_);
  }

 private:
  void word(std::string_view w) {
    // A text has blanks of its own beside a formula.
    while (w.starts_with(' ')) w.remove_prefix(1);
    while (w.ends_with(' ')) w.remove_suffix(1);
    if (w.empty()) return;
    const bool joins = w == "," || w == ";" || w == "." || w == ":";
    if (!text_.empty() && !joins) text_ += ' ';
    text_ += w;
    last_is_digit_ = last_is_upright_ = false;
  }

  void word(const Phrase& phrase) { word(phrase.in(language_)); }

  std::string_view word_of(char32_t sign) const {
    const Phrase* known = words_of(words::kSigns, sign);
    return known == nullptr ? std::string_view() : known->in(language_);
  }

  bool symbol_said(const MathSymbol* symbol) {
    const std::string words = symbol != nullptr ? say_(symbol->name) : std::string();
    word(words);
    return !words.empty();
  }

  void atoms(Atoms children) {
    const bool at_end = factor_follows_;
    for (std::size_t i = 0; i < children.size(); ++i) {
      const MathSymbols::Found found = symbols_.at(children, i);
      if (found.symbol != nullptr && symbol_said(found.symbol)) {
        i += found.count - 1;
        continue;
      }
      if (is_bar(children[i])) {
        i = bars(children, i, at_end);
        continue;
      }
      if (is_product_sign(children[i]) && !joins_vectors(children, i)) {
        word(words::kTimes);
        continue;
      }
      factor_follows_ = begins_factor(children, i + 1, at_end);
      node(children[i]);
    }
    factor_follows_ = at_end;
  }

  /// From the bar at children[i] to that which closes it, whose place is returned.
  std::size_t bars(Atoms children, std::size_t i, bool at_end) {
    std::size_t close = i + 1;
    while (close < children.size() && !is_bar(children[close])) ++close;
    const Atoms inside = children.subspan(i + 1, close - i - 1);
    if (close == children.size()) {
      word(words::kMagnitudeOf);
      return i;
    }
    magnitude(inside, begins_factor(children, close + 1, at_end));
    if (children[close].kind == Kind::scripts) subscript_and_powers(children[close]);
    return close;
  }

  void magnitude(Atoms inside, bool is_multiplied) {
    word(words::kMagnitudeOf);
    alone([&] { atoms(inside); });
    if (is_multiplied || !is_term(inside)) word(words::kEndOfMagnitude);
  }

  /// What has words of its own that end it: nothing multiplies the last of its parts.
  template <class Say>
  void alone(const Say& say) {
    const bool before = std::exchange(factor_follows_, false);
    say();
    factor_follows_ = before;
  }

  /// One sign with its marks and indices, one number, one name of the lesson, a differential such as dt:
  /// nobody who hears it beside others can take a part of it for theirs, or one of theirs for its own.
  bool is_term(const MathNode& n) const {
    const MathNode& inner = without_groups(n);
    if (symbols_.of(inner) != nullptr) return true;
    switch (inner.kind) {
      case Kind::symbol:
      case Kind::text:
        return inner.atom != MathClass::large;
      case Kind::accent:
        return is_term(inner.children[0]);
      case Kind::scripts:
        return is_term(inner.children[0]) && (inner.children[1].absent() || is_index(inner.children[1])) &&
               (inner.children[2].absent() || is_term(inner.children[2]) ||
                is_negative_number(without_groups(inner.children[2])));
      case Kind::row:
      case Kind::alphabet:
      case Kind::color:
      case Kind::term:
      case Kind::box:
        return is_term(Atoms(inner.children));
      default:
        return false;
    }
  }

  bool is_term(Atoms atoms) const {
    while (!atoms.empty() && !is_seen(atoms.front())) atoms = atoms.subspan(1);
    while (!atoms.empty() && !is_seen(atoms.back())) atoms = atoms.first(atoms.size() - 1);
    if (atoms.size() <= 1) return atoms.empty() || is_term(atoms.front());
    if (symbols_.at(atoms, 0).count == atoms.size()) return true;
    if (is_differential_sign(atoms.front())) return is_term(atoms.subspan(1));
    const auto is_of_number = [](const MathNode& n) {
      return is_digit(n.kind == Kind::scripts ? without_groups(n.children[0]) : n);
    };
    return std::all_of(atoms.begin(), atoms.end() - 1, is_digit) && is_of_number(atoms.back()) &&
           (atoms.back().kind != Kind::scripts || is_term(atoms.back()));
  }

  /// Letters and digits one after the other: the 12 of r₁₂.
  bool is_index(const MathNode& n) const {
    const MathNode& inner = without_groups(n);
    if (inner.kind != Kind::row) return is_term(inner);
    return std::all_of(inner.children.begin(), inner.children.end(), [&](const MathNode& child) {
      return child.kind == Kind::symbol && child.atom == MathClass::ordinary;
    });
  }

  static bool is_negative_number(const MathNode& n) {
    const Atoms atoms(n.children);
    return n.kind == Kind::row && atoms.size() > 1 && atoms.front().character == U'−' &&
           std::all_of(atoms.begin() + 1, atoms.end(), is_digit);
  }

  void node(const MathNode& n) {
    if (n.kind != Kind::row && symbol_said(symbols_.of(n))) return;
    switch (n.kind) {
      case Kind::symbol:
        return symbol(n);
      case Kind::text:
        return word(n.text == kLiveRoom ? words::kItsValueNow.in(language_)
                    : n.text == "°"     ? words::kDegrees.in(language_)
                                        : std::string_view(n.text));
      case Kind::scripts:
        return scripts(n);
      case Kind::fraction:
        return fraction(n);
      case Kind::radical:
        return radical(n);
      case Kind::accent:
        return accent(n);
      case Kind::fenced:
        return fenced(n);
      case Kind::delimiter:
        return word(word_of(n.character));
      case Kind::grid:
        return grid(n);
      case Kind::cancel:
        if (n.character == U'n') {  // of a relation: \not\subset
          word(words::kNot);
          return atoms(n.children);
        }
        word(words::kStruckOut);
        alone([&] { atoms(n.children); });
        return word(words::kEndOfStruckOut);
      case Kind::arrow:
        if (n.character == U'→')
          word(words::kGoesTo);
        else
          word(word_of(n.character));
        word(words::kBy);
        node(n.children[0]);
        if (!n.children[1].absent()) aside(words::kWithBelow, n.children[1]);
        return;
      case Kind::stacked:
        node(n.children[0]);
        if (!n.children[1].absent()) aside(words::kWithAbove, n.children[1]);
        if (!n.children[2].absent()) aside(words::kWithBelow, n.children[2]);
        return;
      case Kind::bar:
        atoms(n.children);
        return word(n.character == U'-' ? words::kBar : words::kUnderlined);
      case Kind::space:
        return pause(n.amount);
      case Kind::style:
      case Kind::phantom:
      case Kind::nothing:
        return;
      default:
        return atoms(n.children);
    }
  }

  /// A wide space parts what is said, unless a sign has done so.
  void pause(double em) {
    last_is_upright_ = false;
    const bool parted =
        text_.empty() || std::string_view(",;:.").find(text_.back()) != std::string_view::npos;
    if (em >= kWideSpace && !parted) word(",");
  }

  void aside(const Phrase& what, const MathNode& n) {
    word(what);
    alone([&] { node(n); });
  }

  static bool is_greek(char32_t c) { return is_greek_capital(c) || (U'α' <= c && c <= U'ω'); }
  static char upper(char c) { return 'a' <= c && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }
  static bool is_greek_capital(char32_t c) { return U'Α' <= c && c <= U'Ω'; }

  void symbol(const MathNode& n) {
    const char32_t c = n.character;
    if (c == U'1' && n.alphabet == Alphabet::bold) return word(words::kUnitTensor);
    if (U'0' <= c && c <= U'9') {
      if (!last_is_digit_ && !text_.empty()) text_ += ' ';
      text_ += static_cast<char>(c);
      last_is_digit_ = true;
      return;
    }
    if ((c == U'.' || is_decimal_comma(n)) && last_is_digit_) {
      text_ += static_cast<char>(c);
      return;
    }
    std::string known(word_of(c));
    if (known.empty() && c >= 0x80) {
      known = name_of_symbol(c);
      // A noun, in German: Omega.
      if (language_ == Language::de && is_greek(c) && !known.empty()) known.front() = upper(known.front());
    }
    // Heard, Ω and ω are one word.
    if (is_greek_capital(c) && !known.empty()) {
      char& first = known.front();
      if (language_ == Language::en && 'A' <= first && first <= 'Z')
        first = static_cast<char>(first - 'A' + 'a');
      return word(words::kCapital.with(language_, {known}));
    }
    if (!known.empty()) {
      word(known);
      if (n.atom == MathClass::large && !has_limits_) word(words::kOf);
      return;
    }
    // Upright letters are those of a word, or of a unit: kg.
    const bool is_upright = n.alphabet == Alphabet::upright && n.atom == MathClass::ordinary;
    std::string letter;
    append_utf8(letter, c);
    if (is_upright && last_is_upright_)
      text_ += letter;
    else
      word(letter);
    last_is_upright_ = is_upright;
  }

  void scripts(const MathNode& n) {
    const MathNode& base = without_groups(n.children[0]);
    if (base.atom == MathClass::large) return large_operator(n, base);
    if (base.kind == Kind::brace) {
      node(n.children[0]);
      for (const std::size_t i : {1U, 2U})
        if (!n.children[i].absent()) aside(words::kWhichIs, n.children[i]);
      return;
    }
    const MathSymbol* below = symbols_.below_power(n);
    if (symbol_said(below)) return powers(n);
    // What a power is of has to end before it.
    const bool before = std::exchange(factor_follows_, factor_follows_ || !n.children[2].absent());
    node(n.children[0]);
    factor_follows_ = before;
    subscript_and_powers(n);
  }

  void subscript_and_powers(const MathNode& n) {
    if (const MathNode& below = n.children[1]; !below.absent()) {
      const MathNode& first = without_groups(below);
      if (const Phrase* part =
              first.kind == Kind::symbol ? words_of(words::kParts, first.character) : nullptr) {
        word(*part);
        return powers(n);
      }
      const bool is_number = is_digit(first.kind == Kind::row ? first.children.front() : first);
      aside(is_number ? words::kSub : words::kSubLetter, below);
    }
    powers(n);
  }

  void powers(const MathNode& n) {
    if (n.children[2].absent()) return;
    const MathNode& power = without_groups(n.children[2]);
    if (power.kind == Kind::symbol) {
      const char32_t c = power.character;
      constexpr std::u32string_view kMarks = U"∗⊤†′″‴";
      if (c == U'2') return word(words::kSquared);
      if (c == U'3') return word(words::kCubed);
      if (c == U'∘') return word(words::kDegrees);  // 90^\circ
      if (kMarks.find(c) != std::u32string_view::npos) return symbol(power);
    }
    if (is_negative_number(power) && power.children.size() == 2 && power.children[1].character == U'1')
      return word(words::kInverse);
    if (power.kind == Kind::text) return aside(words::kSuper, power);
    aside(words::kToThePower, power);
    if (!is_term(power) && !is_negative_number(power)) word(words::kEndOfPower);
  }

  void large_operator(const MathNode& n, const MathNode& base) {
    const bool before = std::exchange(has_limits_, true);
    node(base);
    has_limits_ = before;
    const MathNode& below = n.children[1];
    const MathNode& above = n.children[2];
    if (base.kind == Kind::text && above.absent()) return aside(words::kLimitOver, below);
    if (!below.absent()) aside(above.absent() ? words::kLimitOver : words::kLimitFrom, below);
    if (!above.absent()) {
      if (below.absent()) return powers(n);
      aside(words::kLimitTo, above);
    }
    if (base.kind == Kind::symbol) word(words::kOf);
  }

  void fraction(const MathNode& n) {
    if (n.binomial) {
      node(n.children[0]);
      return aside(words::kChoose, n.children[1]);
    }
    const MathNode& top = without_groups(n.children[0]);
    const MathNode& bottom = without_groups(n.children[1]);
    if (top.character == U'1' && bottom.kind == Kind::symbol && bottom.character == U'2')
      return word(words::kOneHalf);
    // The rate of what follows: d over d t of it.
    const bool is_rate = is_differential_sign(top) && is_differential(bottom) && is_term(bottom);
    const bool is_short = is_rate || (!factor_follows_ && is_term(top) && is_term(bottom));
    if (!is_short) word(words::kTheFraction);
    alone([&] { node(n.children[0]); });
    aside(words::kOver, n.children[1]);
    if (!is_short) word(words::kEndOfFraction);
    if (is_rate && factor_follows_) word(words::kOf);
  }

  void radical(const MathNode& n) {
    if (n.children[1].absent()) {
      word(words::kSquareRootOf);
    } else {
      word(words::kRootOfOrder);
      alone([&] { node(n.children[1]); });
      word(words::kRootOf);
    }
    alone([&] { node(n.children[0]); });
    if (factor_follows_ || !is_term(n.children[0])) word(words::kEndOfRoot);
  }

  void accent(const MathNode& n) {
    constexpr char32_t kDot = 0x0307, kTwoDots = 0x0308;
    const bool is_rate = (n.character == kDot || n.character == kTwoDots) && has_vector(n.children[0]);
    if (is_rate) {
      word(n.character == kDot ? words::kTimeDerivativeOf : words::kSecondTimeDerivativeOf);
      return node(n.children[0]);
    }
    const Phrase* after = words_of(words::kAccents, n.character);
    if (after == nullptr) word(words::kVector);
    node(n.children[0]);
    if (after != nullptr) word(*after);
  }

  void fenced(const MathNode& n) {
    if (is_magnitude(n)) return magnitude(n.children[1].children, factor_follows_);
    alone([&] {
      for (const MathNode& child : n.children) node(child);
    });
  }

  void grid(const MathNode& n) {
    const MathGrid& g = *n.grid;
    const bool is_matrix = g.kind == MathGrid::Kind::matrix || g.kind == MathGrid::Kind::small;
    if (is_matrix) word(g.left == U'|' ? words::kDeterminantWithRows : words::kMatrixWithRows);
    if (g.kind == MathGrid::Kind::cases) word(words::kInCases);
    const auto columns = static_cast<std::size_t>(std::max(g.columns, 1));
    for (std::size_t i = 0; i < n.children.size(); ++i) {
      if (i > 0 && i % columns == 0)
        word(";");
      else if (i > 0 && g.kind != MathGrid::Kind::aligned)
        word(",");
      alone([&] { node(n.children[i]); });
    }
  }

  MathSymbols symbols_;
  const std::function<std::string(std::string_view)>& say_;
  Language language_;
  std::string text_;
  bool last_is_digit_ = false;
  bool last_is_upright_ = false;
  /// Whether what a sum runs over is said behind the operator that is said now.
  bool has_limits_ = false;
  /// Whether something multiplies what is said now.
  bool factor_follows_ = false;
};

}  // namespace

std::string spoken(const Math& math, const std::vector<MathSymbol>& symbols,
                   const std::function<std::string(std::string_view symbol)>& say) {
  return math.root ? FormulaSpeaker(symbols, say, math.language).run(*with_decimals(math)) : std::string();
}

}  // namespace polhode
