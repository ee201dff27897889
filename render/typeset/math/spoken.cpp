// SPDX-License-Identifier: MIT
#include "base/words/formula_words.h"
#include "render/typeset/characters.h"
#include "render/typeset/math/commands.h"
#include "render/typeset/math/symbols.h"

#include <algorithm>
#include <array>

namespace polhode {
namespace {

using Kind = MathNode::Kind;

template <std::size_t kCount>
const Phrase* words_of(const std::array<words::SignWords, kCount>& table, char32_t sign) {
  const auto found = std::find_if(table.begin(), table.end(),
                                  [sign](const words::SignWords& row) { return row.sign == sign; });
  return found == table.end() ? nullptr : &found->words;
}

class FormulaSpeaker {
 public:
  FormulaSpeaker(const std::vector<MathSymbol>& symbols,
                 const std::function<std::string(std::string_view)>& say, Language language)
      : symbols_(&symbols), say_(say), language_(language) {}

  std::string run(const MathNode& root) {
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
    last_is_digit_ = false;
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

  void atoms(const std::vector<MathNode>& children) {
    bool inside_bars = false;
    for (std::size_t i = 0; i < children.size(); ++i) {
      const MathSymbols::Found found = symbols_.at(children, i);
      if (found.symbol != nullptr && symbol_said(found.symbol)) {
        i += found.count - 1;
        continue;
      }
      if (is_bar(children[i])) {
        if (!inside_bars) word(words::kMagnitudeOf);
        if (children[i].kind == Kind::scripts) subscript_and_powers(children[i]);
        inside_bars = !inside_bars;
        continue;
      }
      node(children[i]);
    }
  }

  static bool is_bar(const MathNode& n) {
    if (n.kind == Kind::scripts) return is_bar(n.children[0]);
    return n.kind == Kind::symbol && n.character == U'|' && n.atom != MathClass::relation;
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
        word(words::kStruckOut);
        return atoms(n.children);
      case Kind::arrow:
        word(words::kGoesTo);
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
    constexpr double kWide = 0.99;
    const bool parted =
        text_.empty() || std::string_view(",;:.").find(text_.back()) != std::string_view::npos;
    if (em >= kWide && !parted) word(",");
  }

  void aside(const Phrase& what, const MathNode& n) {
    word(what);
    node(n);
  }

  static bool is_greek(char32_t c) { return is_greek_capital(c) || (U'α' <= c && c <= U'ω'); }
  static char upper(char c) { return 'a' <= c && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }
  static bool is_greek_capital(char32_t c) { return U'Α' <= c && c <= U'Ω'; }

  void symbol(const MathNode& n) {
    const char32_t c = n.character;
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
    if (!known.empty()) return word(known);
    std::string letter;
    append_utf8(letter, c);
    word(letter);
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
    node(n.children[0]);
    subscript_and_powers(n);
  }

  void subscript_and_powers(const MathNode& n) {
    if (!n.children[1].absent()) aside(words::kSub, n.children[1]);
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
    if (power.kind == Kind::row && power.children.size() == 2 && power.children[0].character == U'−' &&
        power.children[1].character == U'1')
      return word(words::kInverse);
    if (power.kind == Kind::text) return aside(words::kSuper, power);
    aside(words::kToThePower, power);
  }

  void large_operator(const MathNode& n, const MathNode& base) {
    node(base);
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

  /// Neither sums nor relations: it needs no words that say where it ends.
  static bool is_simple(const MathNode& n) {
    const MathNode& inner = without_groups(n);
    if (inner.kind != Kind::row) return inner.kind != Kind::fraction;
    return std::none_of(inner.children.begin(), inner.children.end(), [](const MathNode& child) {
      return child.kind == Kind::fraction || child.character == U'+' || child.character == U'−' ||
             child.atom == MathClass::relation;
    });
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
    const bool simple = is_simple(top) && is_simple(bottom);
    if (!simple) word(words::kTheFraction);
    node(n.children[0]);
    aside(words::kOver, n.children[1]);
    if (!simple) word(words::kEndOfFraction);
  }

  void radical(const MathNode& n) {
    if (n.children[1].absent()) {
      word(words::kSquareRootOf);
    } else {
      word(words::kRootOfOrder);
      node(n.children[1]);
      word(words::kRootOf);
    }
    node(n.children[0]);
    if (!is_simple(n.children[0])) word(words::kEndOfRoot);
  }

  void accent(const MathNode& n) {
    const Phrase* after = words_of(words::kAccents, n.character);
    if (after == nullptr) word(words::kVector);
    node(n.children[0]);
    if (after != nullptr) word(*after);
  }

  void fenced(const MathNode& n) {
    for (const MathNode& child : n.children) {
      const bool is_magnitude = child.kind == Kind::delimiter && child.character == U'|';
      if (!is_magnitude)
        node(child);
      else if (&child == &n.children.front())
        word(words::kMagnitudeOf);
    }
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
      node(n.children[i]);
    }
  }

  MathSymbols symbols_;
  const std::function<std::string(std::string_view)>& say_;
  Language language_;
  std::string text_;
  bool last_is_digit_ = false;
};

}  // namespace

std::string spoken(const Math& math, const std::vector<MathSymbol>& symbols,
                   const std::function<std::string(std::string_view symbol)>& say) {
  return math.root ? FormulaSpeaker(symbols, say, math.language).run(*with_decimals(math)) : std::string();
}

}  // namespace polhode
