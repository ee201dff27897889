// SPDX-License-Identifier: MIT
#include "render/typeset/math/mathml.h"

#include "base/numbers.h"
#include "base/utf8.h"
#include "render/typeset/math/alphabets.h"
#include "render/typeset/math/symbols.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace polhode {
namespace {

using Kind = MathNode::Kind;

std::string escaped(std::string_view utf8) {
  std::string text;
  for (const char c : utf8) {
    switch (c) {
      case '&':
        text += "&amp;";
        break;
      case '<':
        text += "&lt;";
        break;
      case '>':
        text += "&gt;";
        break;
      case '"':
        text += "&quot;";
        break;
      default:
        text += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return text;
}

std::string utf8_of(char32_t c) {
  std::string text;
  append_utf8(text, c);
  return text;
}

/// ` name="value"`
std::string attribute(std::string_view name, std::string_view value) {
  return ' ' + std::string(name) + "=\"" + escaped(value) + '"';
}

/// "0.25em"
std::string in_em(double length) {
  constexpr int kDigits = 4;  // a ten-thousandth of an em is no pixel anywhere
  return digits(length, kDigits) + "em";
}

std::string_view class_of(Face face) {
  switch (face) {
    case Face::serif_bold:
      return "b";
    case Face::serif_italic:
      return "i";
    case Face::sans:
      return "sf";
    case Face::mono:
      return "tt";
    default:
      return {};
  }
}

/// The sign that stands above a letter, as a character that needs none below it; 0: there is none.
char32_t standing_alone(char32_t accent) {
  struct Accent {
    char32_t combining, alone;
  };
  static constexpr std::array<Accent, 13> kAccents = {{{0x0300, U'`'},
                                                       {0x0301, U'´'},
                                                       {0x0302, U'ˆ'},
                                                       {0x0303, U'˜'},
                                                       {0x0304, U'¯'},
                                                       {0x0306, U'˘'},
                                                       {0x0307, U'˙'},
                                                       {0x0308, U'¨'},
                                                       {0x030A, U'˚'},
                                                       {0x030C, U'ˇ'},
                                                       {0x20D6, U'←'},
                                                       {0x20D7, U'→'},
                                                       {0x20E1, U'↔'}}};
  const auto* const found = std::find_if(kAccents.begin(), kAccents.end(),
                                         [&](const Accent& known) { return known.combining == accent; });
  return found == kAccents.end() ? accent : found->alone;
}

bool is_letter(char32_t c) { return in_alphabet(c, Alphabet::bold) != c && !(U'0' <= c && c <= U'9'); }
bool is_digit(const MathNode& node) {
  return node.kind == Kind::symbol && U'0' <= node.character && node.character <= U'9' &&
         (node.alphabet == Alphabet::normal || node.alphabet == Alphabet::upright);
}

class Writer {
 public:
  Writer(const Math& math, const MathMlStyle& style)
      : style_(style), symbols_(style.symbols), has_links_(!math.references.empty()) {}

  std::string run(const MathNode& root) {
    text_ = (style_.display ? "<math display=\"block\"" : "<math") + attributes_of_words() + '>';
    if (!style_.tex.empty()) text_ += "<semantics>";
    argument(root);
    if (!style_.tex.empty())
      text_ +=
          "<annotation encoding=\"application/x-tex\">" + escaped(style_.tex) + "</annotation></semantics>";
    return std::move(text_) + "</math>";
  }

  /// In rows beside each other; empty: it would be one row.
  std::string run_in_pieces(const MathNode& root) {
    const bool is_row = root.kind == Kind::row && !root.children.empty();
    const bool is_display = is_row && root.children[0].kind == Kind::style && root.children[0].amount == 0;
    // Firefox breaks no line of a block of its own.
    text_ = "<math class=\"pieces\"" + attributes_of_words();
    if (is_display || style_.display) text_ += " displaystyle=\"true\"";
    if (!style_.tex.empty()) text_ += attribute("data-tex", style_.tex);
    text_ += "><mrow>";
    is_in_pieces_ = true;
    if (is_row)
      atoms(root.children, is_display ? 1 : 0);
    else
      atoms({root});
    return has_broken_ ? std::move(text_) + "</mrow></math>" : std::string();
  }

 private:
  std::string attributes_of_words() const {
    std::string attributes;
    // A name would hide the links that stand in it.
    if (!style_.words.empty() && !has_links_) attributes += attribute("aria-label", style_.words);
    if (!style_.words.empty()) attributes += attribute("alttext", style_.words);
    return attributes;
  }

  // ---- Elements

  void open(std::string_view name, std::string_view attributes = {}) {
    text_ += '<';
    text_ += name;
    text_ += attributes;
    text_ += '>';
  }
  void close(std::string_view name) {
    text_ += "</";
    text_ += name;
    text_ += '>';
  }
  void element(std::string_view name, std::string_view attributes, std::string_view content) {
    open(name, attributes);
    text_ += escaped(content);
    close(name);
  }
  template <class Do>
  void around(std::string_view name, std::string_view attributes, const Do& inside) {
    open(name, attributes);
    ++depth_;
    inside();
    --depth_;
    close(name);
  }

  /// A row of its own, in which an operator at the beginning has nothing before it.
  template <class Do>
  void group(const Do& inside) {
    const MathClass before = std::exchange(before_, MathClass::opening);
    around("mrow", "", inside);
    before_ = before;
  }
  /// What takes the place of one element.
  void argument(const MathNode& node_of_it) {
    if (node_of_it.absent()) return element("mrow", "", "");
    group([&] {
      if (node_of_it.kind == Kind::row && node_of_it.children.size() > 1)
        atoms(node_of_it.children);
      else
        node(node_of_it);
    });
  }

  // ---- Rows

  std::string class_attribute(const MathSymbol* symbol) const {
    if (symbol == nullptr || !style_.class_of) return {};
    const std::string name = style_.class_of(symbol->name);
    return name.empty() ? name : attribute("class", name);
  }

  void atoms(const std::vector<MathNode>& children) { atoms(children, 0); }

  static MathClass class_of_atom(const MathNode& n) {
    if (n.kind == Kind::arrow || (n.kind == Kind::cancel && n.character == U'n')) return MathClass::relation;
    return n.kind == Kind::scripts ? without_groups(n.children[0]).atom : n.atom;
  }

  bool is_place_to_break(const MathNode& n) const {
    constexpr std::u32string_view kSums = U"+−±∓";
    constexpr double kQuad_em = 0.99;
    if (n.kind == Kind::space) return n.amount > kQuad_em;
    const MathClass atom = class_of_atom(n);
    const bool is_sum =
        atom == MathClass::binary && n.kind == Kind::symbol && kSums.find(n.character) != kSums.npos;
    return atom == MathClass::relation || (is_sum && has_operand_before());
  }

  /// At the top level, before what is written next.
  void break_before(const MathNode& n) {
    if (!is_in_pieces_ || depth_ > 0) return;
    if (has_atom_ && brackets_ == 0 && !is_between_bars_ && is_place_to_break(n)) {
      text_ += "</mrow><mrow>";
      has_broken_ = true;
      has_atom_ = false;
    }
    has_atom_ = has_atom_ || n.kind != Kind::space;
    const MathClass atom = class_of_atom(n);
    if (atom == MathClass::opening) ++brackets_;
    if (atom == MathClass::closing) brackets_ = std::max(0, brackets_ - 1);
    const MathNode& sign = n.kind == Kind::scripts ? without_groups(n.children[0]) : n;
    if (sign.kind == Kind::symbol && sign.character == U'|' && atom == MathClass::ordinary)
      is_between_bars_ = !is_between_bars_;
  }

  /// Of what only colours, names or strikes out: its atoms are those of the row that it stands in.
  void contents(const MathNode& n) {
    for (const MathNode& child : n.children)
      if (child.kind == Kind::row)
        atoms(child.children);
      else
        node(child);
  }

  void atoms(const std::vector<MathNode>& children, std::size_t first) {
    for (std::size_t i = first; i < children.size(); ++i) {
      const MathNode& child = children[i];
      next_ = i + 1 < children.size() ? &children[i + 1] : nullptr;
      break_before(child);
      if (child.kind == Kind::style) {  // of the rest
        static constexpr std::array<std::string_view, 4> kStyles = {
            " displaystyle=\"true\" scriptlevel=\"0\"", " displaystyle=\"false\" scriptlevel=\"0\"",
            " displaystyle=\"false\" scriptlevel=\"1\"", " displaystyle=\"false\" scriptlevel=\"2\""};
        const auto level = static_cast<std::size_t>(std::clamp(child.amount, 0.0, 3.0));
        return around("mstyle", kStyles[level], [&] { atoms(children, i + 1); });
      }
      const MathSymbols::Found found = symbols_.at(children, i);
      if (found.symbol != nullptr && found.count > 1) {
        around("mrow", class_attribute(found.symbol), [&] {
          for (std::size_t k = 0; k < found.count; ++k) plain(children[i + k]);
        });
        i += found.count - 1;
        continue;
      }
      if (is_digit(child)) {
        i = number(children, i);
        continue;
      }
      node(child);
    }
  }

  /// Digits and a point, or comma, between them are one number. Returns the index of the last.
  std::size_t number(const std::vector<MathNode>& children, std::size_t i) {
    std::string digits;
    std::size_t end = i;
    const auto has_digit = [&](std::size_t k) { return k < children.size() && is_digit(children[k]); };
    const auto is_mark = [&](const MathNode& n) {
      return n.kind == Kind::symbol && (n.character == U'.' || is_decimal_comma(n));
    };
    while (has_digit(end) || (end < children.size() && is_mark(children[end]) && has_digit(end + 1)))
      digits += static_cast<char>(children[end++].character);
    element("mn", "", digits);
    before_ = MathClass::ordinary;
    return end - 1;
  }

  void node(const MathNode& n) {
    const MathSymbol* symbol = n.kind == Kind::row ? nullptr : symbols_.of(n);
    if (symbol == nullptr) symbol = symbols_.below_power(n);
    if (symbol == nullptr) symbol = symbols_.below_dots(n);
    const std::string name = class_attribute(symbol);
    if (name.empty()) return plain(n);
    around("mrow", name, [&] { plain(n); });
  }

  // ---- Nodes

  void plain(const MathNode& n) {
    switch (n.kind) {
      case Kind::nothing:
      case Kind::style:
        return;
      case Kind::row:
        return row(n);
      case Kind::alphabet:
        return contents(n);
      case Kind::symbol:
        return symbol(n);
      case Kind::text:
        return text(n);
      case Kind::space:
        return open("mspace", attribute("width", in_em(n.amount)) + '/');
      case Kind::color:
        return around("mrow", attribute("mathcolor", hex(n.color)), [&] { contents(n); });
      case Kind::term:
        return term(n);
      case Kind::scripts:
        return scripts(n);
      case Kind::fraction:
        return fraction(n);
      case Kind::radical:
        return radical(n);
      case Kind::accent:
        return accent(n);
      case Kind::bar:
        return mark(n, n.character == U'-' ? U'‾' : U'_', n.character == U'-', true);
      case Kind::brace:
        return mark(n, n.character, n.character == U'⏞', true);
      case Kind::stacked:
        return stacked(n);
      case Kind::arrow:
        return arrow(n);
      case Kind::fenced:
        return fenced(n);
      case Kind::delimiter:
        return delimiter(n);
      case Kind::grid:
        return grid(n);
      case Kind::cancel:
        return cancel(n);
      case Kind::box:
        around("mrow", " class=\"box\"", [&] { argument(n.children[0]); });
        before_ = MathClass::ordinary;
        return;
      case Kind::phantom:
        return phantom(n);
    }
  }

  /// A group in braces. A sign alone in one has no space around it: 10{,}000.
  void row(const MathNode& n) {
    const bool is_alone = n.children.size() == 1 && n.children[0].kind == Kind::symbol &&
                          n.atom == MathClass::ordinary && n.children[0].atom != MathClass::ordinary;
    if (is_alone) {
      element("mo", " lspace=\"0\" rspace=\"0\" stretchy=\"false\"", utf8_of(n.children[0].character));
    } else if (n.children.size() == 1) {
      return node(n.children[0]);
    } else {
      group([&] { atoms(n.children); });
    }
    before_ = n.atom;
  }

  static std::string hex(const Color& color) {
    std::string text = "#";
    for (const float part : {color.r, color.g, color.b}) {
      constexpr std::string_view kDigits = "0123456789abcdef";
      const auto level = static_cast<std::size_t>(std::clamp(std::lround(part * 255), 0L, 255L));
      text += kDigits[level / 16];
      text += kDigits[level % 16];
    }
    return text;
  }

  bool has_operand_before() const {
    return before_ == MathClass::ordinary || before_ == MathClass::closing || before_ == MathClass::inner;
  }

  void symbol(const MathNode& n) {
    const char32_t c = n.character;
    if (is_letter(c) && n.atom == MathClass::ordinary) {
      letter(c, n.alphabet);
    } else if (is_digit(n)) {
      element("mn", "", utf8_of(c));
    } else {
      element(is_ordinary_sign(n) ? "mi" : "mo", attributes_of(n), utf8_of(in_alphabet(c, n.alphabet)));
    }
    before_ = n.atom;
  }

  void letter(char32_t c, Alphabet alphabet) {
    const char32_t styled = in_alphabet(c, alphabet);
    // A single letter in mi is italic: what is upright has to say so, what is italic may stand as it is
    // typed.
    const bool is_italic = alphabet == Alphabet::normal || alphabet == Alphabet::italic;
    if (styled == c) return element("mi", " mathvariant=\"normal\"", utf8_of(c));
    element("mi", "", utf8_of(is_italic ? c : styled));
  }

  /// ∞, ∂, ℏ, ′ and the like stand as letters do; a stroke or a bar as an operator without space.
  static bool is_ordinary_sign(const MathNode& n) {
    constexpr std::u32string_view kStrokes = U"|/‖∣∥!′″‴%°";
    return n.atom == MathClass::ordinary && kStrokes.find(n.character) == std::u32string_view::npos;
  }

  std::string attributes_of(const MathNode& n) const {
    switch (n.atom) {
      case MathClass::ordinary:
        return is_ordinary_sign(n) ? "" : " lspace=\"0\" rspace=\"0\" stretchy=\"false\"";
      case MathClass::opening:
        return " form=\"prefix\" stretchy=\"false\"";
      case MathClass::closing:
        return " form=\"postfix\" stretchy=\"false\"";
      case MathClass::binary:
        if (has_operand_before()) return " form=\"infix\"";
        return " form=\"prefix\" lspace=\"0\" rspace=\"0\"";
      case MathClass::relation:
        return " form=\"infix\" lspace=\"0.2778em\" rspace=\"0.2778em\" stretchy=\"false\"";
      case MathClass::punctuation:
        return " separator=\"true\" lspace=\"0\" rspace=\"0.1667em\"";
      case MathClass::large:
        return n.limits == Limits::in_display ? " largeop=\"true\" movablelimits=\"true\""
                                              : " largeop=\"true\" movablelimits=\"false\"";
      case MathClass::inner:
        break;
    }
    return " lspace=\"0.1667em\" rspace=\"0.1667em\"";
  }

  void text(const MathNode& n) {
    if (n.atom == MathClass::large) {  // sin, lim
      constexpr std::string_view kThin = "0.1667em";
      const bool is_before_fence =
          next_ != nullptr && (next_->atom == MathClass::opening || next_->kind == Kind::fenced);
      element("mo",
              " form=\"prefix\"" + attribute("lspace", has_operand_before() ? kThin : "0") +
                  attribute("rspace", is_before_fence ? "0" : kThin) +
                  attribute("movablelimits", n.limits == Limits::in_display ? "true" : "false"),
              n.text);
    } else {
      const std::string_view name = class_of(n.face);
      // Blanks at the ends would be lost.
      std::string words = n.text;
      if (words.ends_with(' ')) words.replace(words.size() - 1, 1, "\u00A0");
      if (words.starts_with(' ')) words.replace(0, 1, "\u00A0");
      element("mtext", name.empty() ? std::string() : attribute("class", name), words);
    }
    before_ = n.atom == MathClass::large ? MathClass::large : MathClass::ordinary;
  }

  void term(const MathNode& n) {
    const std::string address =
        style_.address_of && n.text.find('#') != std::string::npos ? style_.address_of(n.text) : "";
    if (address.empty() && is_in_pieces_ && depth_ == 0) return contents(n);
    if (address.empty()) return around("mrow", "", [&] { contents(n); });
    around("mtext", "", [&] { element("a", attribute("href", address), words_of(n)); });
    before_ = MathClass::ordinary;
  }

  static std::string words_of(const MathNode& n) {
    std::string words = n.kind == Kind::text ? n.text : "";
    for (const MathNode& child : n.children) words += words_of(child);
    return words;
  }

  // ---- Scripts

  /// An element with the base and what stands about it; what is absent is left out.
  void with_marks(const MathNode& base, const MathNode& below, const MathNode& above, bool as_limits) {
    const MathClass before = before_;
    const bool both = !below.absent() && !above.absent();
    const std::string_view name = both             ? (as_limits ? "munderover" : "msubsup")
                                  : below.absent() ? (as_limits ? "mover" : "msup")
                                                   : (as_limits ? "munder" : "msub");
    around(name, "", [&] {
      marked(base);
      if (!below.absent()) argument(below);
      if (!above.absent()) argument(above);
    });
    before_ = before;
  }

  /// An operator is one only as the first child itself, not in a row.
  void marked(const MathNode& base) {
    const MathNode& only = without_groups(base);
    if (only.kind == Kind::symbol || only.kind == Kind::text)
      node(only);
    else
      argument(base);
  }

  static bool is_of_primes(const MathNode& above) {
    constexpr std::u32string_view kPrimes = U"′″‴⁗";
    return above.kind == Kind::row && !above.children.empty() &&
           std::ranges::all_of(above.children, [&](const MathNode& one) {
             return one.kind == Kind::symbol && kPrimes.find(one.character) != kPrimes.npos;
           });
  }

  /// Fonts draw them small and raised: as a script they would be so twice.
  void primed(const MathNode& base, const MathNode& below, const MathNode& primes) {
    const MathClass before = before_;
    around("mrow", "", [&] {
      if (below.absent())
        marked(base);
      else
        with_marks(base, below, MathNode{}, false);
      for (const MathNode& one : primes.children)
        element("mo", " form=\"postfix\" lspace=\"0\" rspace=\"0\" stretchy=\"false\"",
                utf8_of(one.character));
    });
    before_ = before;
  }

  void scripts(const MathNode& n) {
    const MathNode& base = without_groups(n.children[0]);
    const bool as_limits = base.kind == Kind::brace ||
                           (base.atom == MathClass::large && base.limits != Limits::beside) ||
                           (n.children[0].atom == MathClass::large && n.children[0].limits != Limits::beside);
    if (is_of_primes(n.children[2]))
      primed(n.children[0], n.children[1], n.children[2]);
    else
      with_marks(n.children[0], n.children[1], n.children[2], as_limits);
    before_ = base.atom;
  }

  void fraction(const MathNode& n) {
    const auto bare = [&] {
      around("mfrac", n.amount == 0 ? " linethickness=\"0\"" : "", [&] {
        argument(n.children[0]);
        argument(n.children[1]);
      });
    };
    const auto styled = [&] {
      if (n.forced_style < 0) return bare();
      around("mstyle",
             n.forced_style == 0 ? " displaystyle=\"true\" scriptlevel=\"0\""
                                 : " displaystyle=\"false\" scriptlevel=\"0\"",
             bare);
    };
    if (n.binomial) {
      around("mrow", "", [&] {
        fence(U'(', "prefix");
        styled();
        fence(U')', "postfix");
      });
    } else {
      styled();
    }
    before_ = MathClass::inner;
  }

  void radical(const MathNode& n) {
    if (n.children[1].absent()) {
      around("msqrt", "", [&] { argument(n.children[0]); });
    } else {
      around("mroot", "", [&] {
        argument(n.children[0]);
        argument(n.children[1]);
      });
    }
    before_ = MathClass::ordinary;
  }

  /// The contents with a sign above or below them.
  void mark(const MathNode& n, char32_t sign, bool above, bool stretches) {
    around(above ? "mover" : "munder", above ? " accent=\"true\"" : " accentunder=\"true\"", [&] {
      group([&] { atoms(n.children); });
      // The arrow of its own is as long as "to": a style sheet makes that of a vector shorter.
      constexpr std::u32string_view kArrows = U"←→↔";
      const bool is_arrow = !stretches && kArrows.find(sign) != kArrows.npos;
      element("mo",
              std::string(stretches ? " stretchy=\"true\"" : " stretchy=\"false\"") +
                  (is_arrow ? " class=\"vec\"" : ""),
              utf8_of(sign));
    });
    before_ = MathClass::ordinary;
  }

  void accent(const MathNode& n) {
    // Three dots, and more, have no character of their own.
    if (n.character == 0x20DB || n.character == 0x20DC) {
      around("mover", " accent=\"true\"", [&] {
        group([&] { atoms(n.children); });
        element("mo", " stretchy=\"false\"", n.character == 0x20DB ? "˙˙˙" : "˙˙˙˙");
      });
      before_ = MathClass::ordinary;
      return;
    }
    mark(n, standing_alone(n.character), true, n.wide);
  }

  void stacked(const MathNode& n) {
    with_marks(n.children[0], n.children[2], n.children[1], true);
    before_ = n.atom;
  }

  void arrow(const MathNode& n) {
    const auto label = [&](const MathNode& words) {
      group([&] {
        open("mspace", " width=\"0.4em\"/");
        node(words);
        open("mspace", " width=\"0.4em\"/");
      });
    };
    const bool below = !n.children[1].absent();
    around(below ? "munderover" : "mover", "", [&] {
      element("mo", " stretchy=\"true\" form=\"infix\" lspace=\"0.2778em\" rspace=\"0.2778em\"",
              utf8_of(n.character));
      if (below) label(n.children[1]);
      label(n.children[0]);
    });
    before_ = MathClass::relation;
  }

  // ---- Delimiters

  void fence(char32_t c, std::string_view form) {
    if (c != 0)
      element("mo", attribute("form", form) + " fence=\"true\" stretchy=\"true\" symmetric=\"true\"",
              utf8_of(c));
  }

  void fenced(const MathNode& n) {
    around("mrow", "", [&] {
      for (std::size_t i = 0; i < n.children.size(); ++i) {
        const MathNode& child = n.children[i];
        const bool is_last = i + 1 == n.children.size();
        if (child.kind != Kind::delimiter)
          argument(child);
        else
          fence(child.character, i == 0 ? "prefix" : is_last ? "postfix" : "infix");
      }
    });
    before_ = MathClass::inner;
  }

  void delimiter(const MathNode& n) {
    if (n.character == 0) return;
    const std::string_view form = n.atom == MathClass::closing   ? "postfix"
                                  : n.atom == MathClass::opening ? "prefix"
                                                                 : "infix";
    std::string attributes = attribute("form", form) + " stretchy=\"true\" symmetric=\"true\"";
    if (n.amount > 0)
      attributes += attribute("minsize", in_em(n.amount)) + attribute("maxsize", in_em(n.amount));
    if (n.atom == MathClass::ordinary) attributes += " lspace=\"0\" rspace=\"0\"";
    element("mo", attributes, utf8_of(n.character));
    before_ = n.atom;
  }

  // ---- Tables

  static std::string_view name_of(MathGrid::Kind kind) {
    static constexpr std::array<std::string_view, 6> kNames = {"matrix",  "small",    "cases",
                                                               "aligned", "gathered", "array"};
    return kNames[static_cast<std::size_t>(kind)];
  }

  static std::string_view place_in(const MathGrid& grid, std::size_t column) {
    using K = MathGrid::Kind;
    if (grid.kind == K::aligned) return column % 2 == 0 ? "right" : "left";
    if (grid.kind == K::cases) return "left";
    if (grid.kind != K::array || column >= grid.places.size()) return "center";
    return grid.places[column] == 'l' ? "left" : grid.places[column] == 'r' ? "right" : "center";
  }

  static bool has(const std::vector<int>& lines, std::size_t at) {
    return std::find(lines.begin(), lines.end(), static_cast<int>(at)) != lines.end();
  }

  void grid(const MathNode& n) {
    const MathGrid& g = *n.grid;
    const auto columns = static_cast<std::size_t>(std::max(g.columns, 1));
    const std::size_t rows = n.children.size() / columns;
    const bool is_display = g.kind == MathGrid::Kind::aligned || g.kind == MathGrid::Kind::gathered;
    const auto cell = [&](std::size_t r, std::size_t c) {
      std::string name(place_in(g, c));
      if (has(g.rows_with_line, r)) name += " line-above";
      if (r + 1 == rows && has(g.rows_with_line, rows)) name += " line-below";
      if (has(g.columns_with_line, c)) name += " line-left";
      if (c + 1 == columns && has(g.columns_with_line, columns)) name += " line-right";
      around("mtd", attribute("class", name), [&] {
        // Behind an & a sign stands as if something were before it.
        const bool goes_on = g.kind == MathGrid::Kind::aligned && c % 2 == 1;
        const MathClass before = std::exchange(before_, goes_on ? MathClass::ordinary : MathClass::opening);
        around("mrow", "", [&] { node_of_cell(n.children[r * columns + c]); });
        before_ = before;
      });
    };
    const auto table = [&] {
      around("mtable",
             attribute("class", name_of(g.kind)) + (is_display ? " displaystyle=\"true\""
                                                    : g.kind == MathGrid::Kind::small ? " scriptlevel=\"1\""
                                                                                      : ""),
             [&] {
               for (std::size_t r = 0; r < rows; ++r)
                 around("mtr", "", [&] {
                   for (std::size_t c = 0; c < columns; ++c) cell(r, c);
                 });
             });
    };
    around("mrow", "", [&] {
      fence(g.left, "prefix");
      table();
      fence(g.right, "postfix");
    });
    before_ = n.atom;
  }

  /// Its atoms, without a row of their own, which would begin anew.
  void node_of_cell(const MathNode& cell) {
    if (cell.kind == Kind::row)
      atoms(cell.children);
    else
      node(cell);
  }

  // ---- Others

  void cancel(const MathNode& n) {
    if (n.character == U'n') {  // a relation that does not hold
      const MathNode& only = without_groups(n.children[0]);
      element("mo", " form=\"infix\" lspace=\"0.2778em\" rspace=\"0.2778em\" stretchy=\"false\"",
              utf8_of(only.character) + "\u0338");
      before_ = MathClass::relation;
      return;
    }
    const std::string_view name = n.character == U'/'    ? "cancel-up"
                                  : n.character == U'\\' ? "cancel-down"
                                                         : "cancel-x";
    around("mrow", attribute("class", name), [&] { contents(n); });
    before_ = n.atom;
  }

  void phantom(const MathNode& n) {
    const auto bits = static_cast<unsigned>(n.amount);
    const auto hidden = [&] { around("mphantom", "", [&] { argument(n.children[0]); }); };
    constexpr unsigned kWidth = 1, kHeight = 2;
    if ((bits & kWidth) == 0)
      around("mpadded", " width=\"0\"", hidden);
    else if ((bits & kHeight) == 0)
      around("mpadded", " height=\"0\" depth=\"0\"", hidden);
    else
      hidden();
    before_ = MathClass::ordinary;
  }

  const MathMlStyle& style_;
  MathSymbols symbols_;
  bool has_links_;
  std::string text_;
  MathClass before_ = MathClass::opening;  ///< of what was written last
  const MathNode* next_ = nullptr;         ///< what comes next in the row
  int depth_ = 0;                          ///< so many elements are open, in the row of all or in a piece
  bool is_in_pieces_ = false, has_broken_ = false, is_between_bars_ = false;
  bool has_atom_ = false;  ///< the piece: more than spaces
  int brackets_ = 0;       ///< so many are open at the top level
};

}  // namespace

std::string mathml(const Math& math, const MathMlStyle& style) {
  if (!math.root) return {};
  const std::shared_ptr<const MathNode> root = with_decimals(math);
  if (style.in_pieces)
    if (std::string html = Writer(math, style).run_in_pieces(*root); !html.empty()) return html;
  return Writer(math, style).run(*root);
}

}  // namespace polhode
