// SPDX-License-Identifier: MIT
#include "render/typeset/characters.h"
#include "render/typeset/math/commands.h"
#include "render/typeset/math/symbols.h"

#include <algorithm>
#include <unordered_map>

namespace polhode {
namespace {

using Kind = MathNode::Kind;

std::string_view word_of(char32_t c) {
  static const std::unordered_map<char32_t, std::string_view> kWords = {
      {U'+', "plus"},
      {U'−', "minus"},
      {U'±', "plus or minus"},
      {U'∓', "minus or plus"},
      {U'×', "cross"},
      {U'⋅', "dot"},
      {U'÷', "divided by"},
      {U'/', "over"},
      {U'∗', "star"},
      {U'⊗', "tensor"},
      {U'∧', "wedge"},
      {U'∘', "after"},
      {U'∪', "union"},
      {U'∩', "intersection"},
      {U'∖', "without"},
      {U'=', "equals"},
      {U'≠', "is not equal to"},
      {U'<', "is less than"},
      {U'>', "is greater than"},
      {U'≤', "is at most"},
      {U'≥', "is at least"},
      {U'≪', "is much less than"},
      {U'≫', "is much greater than"},
      {U'≡', "is identical to"},
      {U'≈', "is about"},
      {U'∼', "is of the order of"},
      {U'≃', "is asymptotically"},
      {U'≅', "is congruent to"},
      {U'∝', "is proportional to"},
      {U'≔', "is defined as"},
      {U'∈', "in"},
      {U'∉', "not in"},
      {U'⊂', "is a subset of"},
      {U'⊆', "is a subset of"},
      {U'⟂', "is perpendicular to"},
      {U'∥', "parallel"},
      {U'∣', "such that"},
      {U'→', "to"},
      {U'←', "from"},
      {U'↦', "maps to"},
      {U'⇒', "implies"},
      {U'⟹', "implies"},
      {U'⇐', "follows from"},
      {U'⟸', "follows from"},
      {U'⇔', "is equivalent to"},
      {U'⟺', "is equivalent to"},
      {U'∂', "partial"},
      {U'∇', "nabla"},
      {U'ℏ', "h bar"},
      {U'ℓ', "l"},
      {U'∞', "infinity"},
      {U'∅', "the empty set"},
      {U'∀', "for all"},
      {U'∃', "there is"},
      {U'⊤', "transposed"},
      {U'†', "dagger"},
      {U'…', "and so on"},
      {U'⋯', "and so on"},
      {U'⋮', "and so on"},
      {U'⋱', "and so on"},
      {U'′', "prime"},
      {U'″', "double prime"},
      {U'‴', "triple prime"},
      {U'!', "factorial"},
      {U'∑', "the sum"},
      {U'∏', "the product"},
      {U'∫', "the integral"},
      {U'∬', "the double integral"},
      {U'∭', "the triple integral"},
      {U'∮', "the closed integral"},
      {U'∯', "the closed surface integral"},
      {U'(', "open parenthesis"},
      {U')', "close parenthesis"},
      {U'[', "open bracket"},
      {U']', "close bracket"},
      {U'{', "open brace"},
      {U'}', "close brace"},
      {U'⟨', "open angle"},
      {U'⟩', "close angle"},
      {U'‖', "norm"},
      {U'°', "degrees"},
      {U'%', "percent"},
  };
  const auto found = kWords.find(c);
  return found == kWords.end() ? std::string_view() : found->second;
}

std::string_view accent_word(char32_t accent) {
  switch (accent) {
    case 0x0302:
      return "hat";
    case 0x030C:
      return "check";
    case 0x0303:
      return "tilde";
    case 0x0307:
      return "dot";
    case 0x0308:
      return "double dot";
    case 0x20DB:
      return "triple dot";
    case 0x0304:
      return "bar";
    case 0x0306:
      return "breve";
    case 0x030A:
      return "ring";
    case 0x0301:
      return "acute";
    case 0x0300:
      return "grave";
    default:
      return {};
  }
}

class FormulaSpeaker {
 public:
  FormulaSpeaker(const std::vector<MathSymbol>& symbols,
                 const std::function<std::string(std::string_view)>& say)
      : symbols_(&symbols), say_(say) {}

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
        if (!inside_bars) word("the magnitude of");
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
        return word(n.text == kLiveRoom ? "its value now" : n.text == "°" ? "degrees" : n.text);
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
        word("struck out");
        return atoms(n.children);
      case Kind::arrow:
        word("goes to");
        word("by");
        node(n.children[0]);
        if (!n.children[1].absent()) aside("with below", n.children[1]);
        return;
      case Kind::stacked:
        node(n.children[0]);
        if (!n.children[1].absent()) aside("with above", n.children[1]);
        if (!n.children[2].absent()) aside("with below", n.children[2]);
        return;
      case Kind::bar:
        atoms(n.children);
        return word(n.character == U'-' ? "bar" : "underlined");
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

  void aside(std::string_view what, const MathNode& n) {
    word(what);
    node(n);
  }

  static bool is_greek_capital(char32_t c) { return U'Α' <= c && c <= U'Ω'; }

  void symbol(const MathNode& n) {
    const char32_t c = n.character;
    if (U'0' <= c && c <= U'9') {
      if (!last_is_digit_ && !text_.empty()) text_ += ' ';
      text_ += static_cast<char>(c);
      last_is_digit_ = true;
      return;
    }
    if (c == U'.' && last_is_digit_) {
      text_ += '.';
      return;
    }
    std::string_view known = word_of(c);
    if (known.empty() && c >= 0x80) known = name_of_symbol(c);
    // Heard, Ω and ω are one word.
    if (is_greek_capital(c) && !known.empty()) {
      std::string name = "capital " + std::string(known);
      char& first = name[name.size() - known.size()];
      if ('A' <= first && first <= 'Z') first = static_cast<char>(first - 'A' + 'a');
      return word(name);
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
        if (!n.children[i].absent()) aside("which is", n.children[i]);
      return;
    }
    const MathSymbol* below = symbols_.below_power(n);
    if (symbol_said(below)) return powers(n);
    node(n.children[0]);
    subscript_and_powers(n);
  }

  void subscript_and_powers(const MathNode& n) {
    if (!n.children[1].absent()) aside("sub", n.children[1]);
    powers(n);
  }

  void powers(const MathNode& n) {
    if (n.children[2].absent()) return;
    const MathNode& power = without_groups(n.children[2]);
    if (power.kind == Kind::symbol) {
      const char32_t c = power.character;
      constexpr std::u32string_view kMarks = U"∗⊤†′″‴";
      if (c == U'2') return word("squared");
      if (c == U'3') return word("cubed");
      if (c == U'∘') return word("degrees");  // 90^\circ
      if (kMarks.find(c) != std::u32string_view::npos) return symbol(power);
    }
    if (power.kind == Kind::row && power.children.size() == 2 && power.children[0].character == U'−' &&
        power.children[1].character == U'1')
      return word("inverse");
    if (power.kind == Kind::text) return aside("super", power);
    aside("to the power", power);
  }

  void large_operator(const MathNode& n, const MathNode& base) {
    node(base);
    const MathNode& below = n.children[1];
    const MathNode& above = n.children[2];
    if (base.kind == Kind::text && above.absent()) return aside("over", below);
    if (!below.absent()) aside(above.absent() ? "over" : "from", below);
    if (!above.absent()) {
      if (below.absent()) return powers(n);
      aside("to", above);
    }
    if (base.kind == Kind::symbol) word("of");
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
      return aside("choose", n.children[1]);
    }
    const MathNode& top = without_groups(n.children[0]);
    const MathNode& bottom = without_groups(n.children[1]);
    if (top.character == U'1' && bottom.kind == Kind::symbol && bottom.character == U'2')
      return word("one half");
    const bool simple = is_simple(top) && is_simple(bottom);
    if (!simple) word("the fraction");
    node(n.children[0]);
    aside("over", n.children[1]);
    if (!simple) word("end of fraction");
  }

  void radical(const MathNode& n) {
    if (n.children[1].absent()) {
      word("the square root of");
    } else {
      word("the root of order");
      node(n.children[1]);
      word("of");
    }
    node(n.children[0]);
    if (!is_simple(n.children[0])) word("end of root");
  }

  void accent(const MathNode& n) {
    const std::string_view after = accent_word(n.character);
    if (after.empty()) word("vector");
    node(n.children[0]);
    word(after);
  }

  void fenced(const MathNode& n) {
    for (const MathNode& child : n.children) {
      const bool is_magnitude = child.kind == Kind::delimiter && child.character == U'|';
      if (!is_magnitude)
        node(child);
      else if (&child == &n.children.front())
        word("the magnitude of");
    }
  }

  void grid(const MathNode& n) {
    const MathGrid& g = *n.grid;
    const bool is_matrix = g.kind == MathGrid::Kind::matrix || g.kind == MathGrid::Kind::small;
    if (is_matrix) word(g.left == U'|' ? "the determinant with rows" : "the matrix with rows");
    if (g.kind == MathGrid::Kind::cases) word("in cases");
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
  std::string text_;
  bool last_is_digit_ = false;
};

}  // namespace

std::string spoken(const Math& math, const std::vector<MathSymbol>& symbols,
                   const std::function<std::string(std::string_view symbol)>& say) {
  return math.root ? FormulaSpeaker(symbols, say).run(*math.root) : std::string();
}

}  // namespace polhode
