// SPDX-License-Identifier: MIT
#include "lessons/notation/typed/typed_formula.h"

#include "base/numbers.h"
#include "base/utf8.h"
#include "lessons/claims/expressions/expression_names.h"
#include "lessons/claims/expressions/expression_tex.h"
#include "lessons/diagnostics/report.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace polhode {
namespace {

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

struct Token {
  enum class Kind { name, number, sign, end } kind = Kind::end;
  std::string text;  ///< of a sign what it stands for: "x" of ×, "." of ·, "^2" of ²
  std::size_t at = 0;
  bool is(std::string_view sign) const { return kind == Kind::sign && text == sign; }
};

/// What a character of its own stands for; empty: nothing.
std::string_view sign_of(char32_t c) {
  switch (c) {
    case U'×':
      return "x";
    case U'·':
    case U'⋅':
      return ".";
    case U'−':
    case U'–':
    case U'‐':
    case U'‑':
    case U'‒':
      return "-";
    case U'²':
      return "^2";
    case U'³':
      return "^3";
    case U'′':
      return "'";
    default:
      return "";
  }
}

/// Dots above the letter before: of the rate of what it stands for.
int dots_above(char32_t c) { return c == U'\u0307' ? 1 : c == U'\u0308' ? 2 : 0; }

/// A letter of one character with its dot; empty: it is none.
std::string_view letter_below_dot(char32_t c) {
  switch (c) {
    case U'ẇ':
      return "w";
    case U'Ṫ':
      return "T";
    case U'Ṅ':
      return "N";
    case U'ṗ':
      return "p";
    case U'Ḟ':
      return "F";
    default:
      return "";
  }
}

/// Commands of TeX that are read, for who is used to them.
std::string_view sign_of_command(std::string_view name) {
  if (name == "cdot") return ".";
  return name == "times" ? "x" : "";
}

/// Letters of names that are typed as such.
std::string_view letters_of(char32_t c) {
  switch (c) {
    case U'ω':
      return "omega";
    case U'₁':
      return "1";
    case U'₂':
      return "2";
    case U'₃':
      return "3";
    default:
      return "";
  }
}

constexpr std::string_view kTensor = "\\mathbf I";

/// A name whose letter an index may follow.
struct Letter {
  std::string_view name, plain;  ///< as it is typed; TeX of it before an index
  std::string alone;             ///< TeX of it without an index; empty: it needs one
};

const std::vector<Letter>& letters() {
  static const std::vector<Letter> kLetters = [] {
    std::vector<Letter> all{
        {"w", "\\omega", ""}, {"I", "I", std::string(kTensor)}, {"e", "\\hat e", ""}, {"T", "T", "T"}};
    for (const QuantityFacts& facts : kQuantities)
      if (!facts.arrow_letter.empty())
        all.push_back({facts.name, facts.arrow_letter, tex_of(facts.quantity)});
    return all;
  }();
  return kLetters;
}

/// TeX and the bytes of the line that its parts come from.
struct Piece {
  std::string tex;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> marks;
  std::string inside;      ///< of what stands in brackets: without them
  bool is_number = false;  ///< digits alone, or a fraction of two
  bool is_single = true;   ///< one name: its rate is d…/dt, without brackets

  void add(std::string_view text) { tex += text; }
  void add(const Piece& piece) {
    for (const auto& [at, typed] : piece.marks)
      marks.emplace_back(at + static_cast<std::uint32_t>(tex.size()), typed);
    tex += piece.tex;
  }
};

Piece piece_at(std::string tex, std::size_t typed) {
  Piece piece;
  piece.marks.emplace_back(0, static_cast<std::uint32_t>(typed));
  piece.tex = std::move(tex);
  return piece;
}

Piece around(std::string_view before, const Piece& piece, std::string_view behind) {
  Piece made;
  made.add(before);
  made.add(piece);
  made.add(behind);
  made.is_single = false;
  return made;
}

/// A name: what stands under a dot, and its index.
struct Name {
  std::string letter, index;
  bool is_vector = false, is_omega = false;

  std::string tex() const { return index.empty() ? letter : letter + "_{" + index + '}'; }
  /// With dots above; empty where print has none.
  std::string rate(std::size_t dots) const {
    const std::string dot = dots == 1 ? "\\dot" : "\\ddot";
    if (is_omega && dots == 1) return dot + '{' + letter + '}';
    if (is_vector || dots > 2) return "";
    return dot + '{' + letter + '}' + (index.empty() ? "" : "_{" + index + '}');
  }
};

class Typing {
 public:
  Typing(std::string_view line, const TypedNames& names) : names_(names) { read_tokens(line); }

  TypedFormula read() {
    TypedFormula formula;
    formula.goes_on = now().is("=");
    Piece all;
    if (formula.goes_on) next(), all.add("= ");
    all.add(sum(0));
    while (now().is("=")) {
      next();
      all.add(" = ");
      all.add(sum(0));
    }
    if (now().kind != Token::Kind::end) {
      fail(now().at, now().is(")") || now().is("|") ? "a bracket is closed that was not opened"
                                                    : "this is not read here");
      all.add("\\ \\ldots");
    }
    formula.tex = std::move(all.tex);
    formula.marks = std::move(all.marks);
    formula.fault = std::move(fault_);
    return formula;
  }

 private:
  const Token& now() const { return tokens_[at_]; }
  const Token& ahead(std::size_t n) const { return tokens_[std::min(at_ + n, tokens_.size() - 1)]; }
  void next() {
    if (at_ + 1 < tokens_.size()) ++at_;
  }

  void fail(std::size_t at, std::string message, std::string hint = {}) {
    if (!fault_) fault_ = TypedFault{at, std::move(message), std::move(hint)};
  }

  void read_tokens(std::string_view line) {
    std::size_t at = 0;
    if (line.size() > kMaxTypedBytes) {
      fail(kMaxTypedBytes, "a line has at most " + std::to_string(kMaxTypedBytes) + " characters",
           "write it in several steps");
      line = line.substr(0, kMaxTypedBytes);
    }
    while (at < line.size()) {
      const std::size_t begin = at;
      const char c = line[at];
      if (c == ' ' || c == '\t') {
        ++at;
      } else if (is_letter(c)) {
        read_name(line, at);
      } else if (is_digit(c)) {
        while (at < line.size() && is_digit(line[at])) ++at;
        if (at + 1 < line.size() && line[at] == '.' && is_digit(line[at + 1])) {
          ++at;
          while (at < line.size() && is_digit(line[at])) ++at;
        }
        tokens_.push_back({Token::Kind::number, std::string(line.substr(begin, at - begin)), begin});
      } else if (std::string_view("=+-*/().,^'|_").find(c) != std::string_view::npos) {
        tokens_.push_back({Token::Kind::sign, std::string(1, c), begin});
        ++at;
      } else if (c == '\\') {
        read_command(line, at);
      } else {
        const char32_t character = next_character(line, at);
        if ((!letters_of(character).empty() && !is_digit(letters_of(character).front())) ||
            !letter_below_dot(character).empty()) {
          at = begin;
          read_name(line, at);
        } else if (const std::string_view sign = sign_of(character); !sign.empty()) {
          tokens_.push_back({Token::Kind::sign, std::string(sign), begin});
        } else {
          fail(begin, "this character is not read: " + in_quotes(line.substr(begin, at - begin)));
        }
      }
    }
    tokens_.push_back({Token::Kind::end, "", line.size()});
  }

  /// \omega, \cdot and \times; others are refused, with what to type.
  void read_command(std::string_view line, std::size_t& at) {
    const std::size_t begin = at++;
    std::size_t end = at;
    while (end < line.size() && is_letter(line[end])) ++end;
    const std::string_view name = line.substr(at, end - at);
    if (const std::string_view sign = sign_of_command(name); !sign.empty()) {
      tokens_.push_back({Token::Kind::sign, std::string(sign), begin});
      at = end;
    } else if (name != "omega") {
      fail(begin, "of TeX only \\omega, \\cdot and \\times are read",
           "type L for \\vec L, w1' for \\dot\\omega_1, a/b for a fraction");
      at = end;
    }
  }

  /// Letters, and an index behind them: "w1", "w_1", "dw1", "ω₁".
  void read_name(std::string_view line, std::size_t& at) {
    const std::size_t begin = at;
    std::string name;
    bool has_digit = false;
    int dots = 0;
    while (at < line.size()) {
      std::size_t behind = at;
      const char32_t c = next_character(line, behind);
      if (dots_above(c) > 0 ||
          (c == U'_' && line.substr(behind, 1) == "{" && line.substr(behind + 2, 1) == "}")) {
        dots += dots_above(c);
        if (c == U'_') {  // "_{1}"
          has_digit = has_digit || is_digit(line[behind + 1]);
          name += line[behind + 1];
          behind += 3;
        }
        at = behind;
        continue;
      }
      if (!letter_below_dot(c).empty() && !has_digit && name.empty()) {
        name += letter_below_dot(c);
        ++dots;
        at = behind;
        continue;
      }
      const std::string_view letters = letters_of(c);
      const bool letter =
          (c < 0x80 && is_letter(static_cast<char>(c))) || (!letters.empty() && !is_digit(letters[0]));
      const bool digit =
          (c < 0x80 && is_digit(static_cast<char>(c))) || (!letters.empty() && is_digit(letters[0]));
      if (letter && has_digit) break;  // "I1w1" is two
      if (c == U'_' && behind < line.size() && (is_letter(line[behind]) || is_digit(line[behind]))) {
        has_digit = has_digit || is_digit(line[behind]);
        name += '_';
      } else if (letter || digit) {
        has_digit = has_digit || digit;
        name += letters.empty() ? line.substr(at, behind - at) : letters;
      } else {
        break;
      }
      at = behind;
    }
    if (name == "x")
      tokens_.push_back({Token::Kind::sign, name, begin});
    else if (const std::vector<std::size_t> parts = parts_of(name); parts.size() > 1)
      for (std::size_t i = 0; i < parts.size(); ++i) {
        const std::size_t end = i + 1 < parts.size() ? parts[i + 1] : name.size();
        tokens_.push_back({Token::Kind::name, name.substr(parts[i], end - parts[i]), begin});
      }
    else
      tokens_.push_back({Token::Kind::name, std::move(name), begin});
    for (int i = 0; i < dots; ++i) tokens_.push_back({Token::Kind::sign, "'", begin});
  }

  /// Where the names begin of which one that is not known is made: "kT", "kw". None with an x, which could be
  /// meant as a cross product, and none that begins with d, as rates do.
  std::vector<std::size_t> parts_of(const std::string& name) const {
    if (name.empty() || name.front() == 'd' || name.find('x') != name.npos || find(name)) return {};
    std::vector<std::size_t> parts;
    for (std::size_t at = 0; at < name.size();) {
      std::size_t end = name.size();
      while (end > at && !find(name.substr(at, end - at))) --end;
      if (end == at) return {};
      parts.push_back(at);
      at = end;
    }
    return parts;
  }

  /// What a name is printed as; nothing if there is none such.
  std::optional<Name> find(const std::string& text) const {
    if (const auto own = names_.find(text); own != names_.end()) {
      const bool is_arrow = own->second.starts_with("\\vec") || own->second.starts_with("\\boldsymbol");
      return Name{own->second, "", is_arrow || text == "I", text == "omega"};
    }
    if (text == "w") return find("omega").value_or(Name{"\\vec\\omega", "", true, true});
    if (text == "m") return Name{"m", ""};
    for (const Letter& letter : letters()) {
      if (!text.starts_with(letter.name)) continue;
      std::string index = text.substr(letter.name.size());
      if (index.starts_with('_')) index.erase(0, 1);
      if (index.empty() && text == letter.name && !letter.alone.empty())
        return Name{letter.alone, "", letter.name != "T", letter.name == "omega"};
      const bool is_index = !index.empty() && letter.name != "T" &&
                            index.size() <= (letter.name == "I" ? 2u : 1u) &&
                            index.find_first_not_of("123xyz") == index.npos;
      if (is_index) return Name{std::string(letter.plain), index, letter.name == "e"};
    }
    return std::nullopt;
  }

  Piece sum(int depth) {
    Piece all;
    all.is_single = false;
    if (now().is("-") || now().is("+")) {
      if (now().is("-")) all.add("-");
      next();
    }
    all.add(term(depth));
    while (now().is("+") || now().is("-")) {
      all.add(now().is("+") ? " + " : " - ");
      next();
      all.add(term(depth));
    }
    return all;
  }

  /// Products with a sign.
  Piece term(int depth) {
    Piece all = run(depth);
    while (now().is("x") || now().is(".")) {
      const bool is_cross = now().is("x");
      next();
      all.add(is_cross ? "\\times " : "\\cdot ");
      all.add(run(depth));
      all.is_single = all.is_number = false;
      all.inside.clear();
    }
    return all;
  }

  bool begins_factor() const {
    return now().kind == Token::Kind::name || now().kind == Token::Kind::number || now().is("(") ||
           (now().is("|") && !in_bars_);
  }

  /// Factors with nothing or "*" between them, and quotients.
  Piece run(int depth) {
    Piece all = factor(depth);
    bool is_quotient = false;
    while (true) {
      const bool star = now().is("*");
      if (now().is("/")) {
        next();
        const Piece below = factor(depth);
        Piece made;
        made.add("\\frac{");
        made.add(without_brackets(all));
        made.add("}{");
        made.add(without_brackets(below));
        made.add("}");
        made.is_number = all.is_number && below.is_number;
        made.is_single = false;
        is_quotient = !made.is_number;
        all = std::move(made);
        continue;
      }
      if (!star && !begins_factor()) return all;
      const std::size_t at = now().at;
      if (!star && is_quotient)
        fail(at, "does this stand below the line?", "write brackets, a/(b c), or a/b*c");
      if (star) next();
      const Piece right = factor(depth);
      const bool digits_meet = right.is_number && !right.tex.starts_with("\\frac");
      all.add(digits_meet || is_tensor(all) ? "\\cdot " : "\\,");
      all.add(right);
      all.inside.clear();
      all.is_number = all.is_single = is_quotient = false;
    }
  }

  /// The tensor is set with a dot before what it is applied to, as lessons print it.
  static bool is_tensor(const Piece& piece) { return piece.tex.ends_with(kTensor); }

  static Piece without_brackets(const Piece& piece) {
    if (piece.inside.empty()) return piece;
    Piece bare;
    bare.tex = piece.inside;
    constexpr std::uint32_t kOpening = 6;  // "\left("
    for (const auto& [at, typed] : piece.marks)
      if (at >= kOpening && at - kOpening < bare.tex.size()) bare.marks.emplace_back(at - kOpening, typed);
    return bare;
  }

  /// With its power behind it, and its primes.
  Piece factor(int depth) {
    const Token token = now();
    if (depth > kMaxTypedNesting) {
      fail(token.at, "brackets are nested too deep here");
      at_ = tokens_.size() - 1;
      return piece_at("\\ldots", token.at);
    }
    if (token.kind == Token::Kind::number) {
      next();
      Piece made = piece_at(token.text, token.at);
      made.is_number = true;
      return powered(std::move(made));
    }
    if (token.is("(") || token.is("|")) return bracketed(token, depth);
    if (token.kind == Token::Kind::name) return named(token, depth);
    fail(token.at, token.is("-") ? "two signs stand in a row" : "something is missing here",
         token.is("-") ? "write brackets: a*(-b)" : "");
    if (token.is("-")) {
      next();
      return around("\\left(-", factor(depth + 1), "\\right)");
    }
    return piece_at("\\ldots ", token.at);
  }

  Piece bracketed(const Token& token, int depth) {
    const bool bars = token.is("|");
    next();
    const bool was_in_bars = std::exchange(in_bars_, bars);
    const Piece inside = sum(depth + 1);
    in_bars_ = was_in_bars;
    if (now().is(bars ? "|" : ")"))
      next();
    else
      fail(now().at, bars ? "the bar is not closed" : "the bracket is not closed");
    Piece made = around(bars ? "\\left|" : "\\left(", inside, bars ? "\\right|" : "\\right)");
    made.marks.insert(made.marks.begin(), {0, static_cast<std::uint32_t>(token.at)});
    if (!bars) made.inside = inside.tex;
    if (!bars && now().is("_")) made = indexed(std::move(made));
    return primed(powered(std::move(made)), token.at);
  }

  /// (…)_2 is a component.
  Piece indexed(Piece base) {
    next();
    const Token index = now();
    if (index.text.size() == 1 && std::string_view("123xyz").find(index.text[0]) != std::string_view::npos) {
      next();
    } else {
      fail(index.at, "an index is 1, 2 or 3");
      return base;
    }
    base.tex += "_{" + index.text + '}';
    base.inside.clear();
    return base;
  }

  Piece powered(Piece base) {
    while (now().is("^") || now().is("^2") || now().is("^3")) {
      const Token token = now();
      next();
      std::string exponent = token.text.substr(1);
      if (exponent.empty()) {
        const bool bracket = now().is("(");
        if (bracket) next();
        if (now().is("-")) exponent = "-", next();
        if (now().kind == Token::Kind::number && now().text.find('.') == std::string::npos) {
          exponent += now().text;
          next();
        } else {
          fail(now().at, "a power is a whole number");
          exponent += "\\ldots";
        }
        if (bracket && now().is(")")) next();
      }
      const bool has_power = base.tex.find('^') != std::string::npos && base.inside.empty();
      Piece made = has_power ? around("\\left(", base, "\\right)") : std::move(base);
      made.tex += "^{" + exponent + '}';
      made.inside.clear();
      made.is_number = false;
      base = std::move(made);
    }
    return base;
  }

  /// Of what is no name a prime is d/dt.
  Piece primed(Piece base, std::size_t at) {
    while (now().is("'")) {
      next();
      Piece made =
          around("\\frac{d}{dt}", base.inside.empty() ? around("\\left(", base, "\\right)") : base, "");
      made.marks.insert(made.marks.begin(), {0, static_cast<std::uint32_t>(at)});
      base = std::move(made);
    }
    return base;
  }

  static Piece rate(const Piece& of, bool from_body, std::size_t at) {
    const std::string d = from_body ? "d^*" : "d";
    Piece made;
    made.marks.emplace_back(0, static_cast<std::uint32_t>(at));
    if (of.is_single && of.inside.empty()) {
      made.add("\\frac{" + d);
      made.add(of);
      made.add("}{dt}");
    } else {
      made.add("\\frac{" + d + "}{dt}");
      made.add(of.inside.empty() ? around("\\left(", of, "\\right)") : of);
    }
    made.is_single = false;
    return made;
  }

  Piece named(const Token& token, int depth) {
    if (auto made = quotient_rate(token, depth)) return powered(std::move(*made));
    if (ahead(1).is("(") && !find(token.text))
      if (auto made = function(token, depth)) return primed(powered(std::move(*made)), token.at);
    if (const std::string& t = token.text; t.size() > 1 && t[0] == 'd' && is_digit(t.back()))
      if (const auto name = find(t.substr(1)); name && !name->is_vector && !find(t)) {
        next();
        return powered(piece_at(name->rate(1), token.at));  // dw1
      }
    const auto name = find(token.text);
    next();
    if (!name) {
      const bool has_x = token.text.size() > 1 && token.text.find('x') != std::string::npos;
      fail(token.at, "there is no " + in_quotes(token.text) + " here",
           has_x ? "blanks stand around the x of a cross product: a x b"
                 : "names are omega, L, N, T, I, w1, I2, e3 and those of the lesson");
      return piece_at("\\text{" + token.text.substr(0, token.text.find('_')) + '}', token.at);
    }
    std::size_t dots = 0;
    while (now().is("'")) ++dots, next();
    Piece made = piece_at(name->tex(), token.at);
    if (dots > 0) {
      const std::string dotted = name->rate(dots);
      if (!dotted.empty()) {
        made = piece_at(dotted, token.at);
        made.is_single = false;
      }
      for (std::size_t i = 0; dotted.empty() && i < dots; ++i) made = rate(made, false, token.at);
    }
    return powered(std::move(made));
  }

  /// d/dt a, d*/dt a, dL/dt, d*L/dt, d(a)/dt: nothing if it is none of these.
  std::optional<Piece> quotient_rate(const Token& token, int depth) {
    if (token.text.front() != 'd') return std::nullopt;
    const std::size_t begin = at_;
    const auto is_dt = [this](std::size_t n) { return ahead(n).is("/") && ahead(n + 1).text == "dt"; };
    const bool whole = token.text == "d";
    bool from_body = false;
    std::size_t ahead_by = 1;
    if (whole) {
      if (ahead(ahead_by).is("^")) ++ahead_by;
      if (ahead(ahead_by).is("*")) from_body = true, ++ahead_by;
    }
    if (whole && is_dt(ahead_by)) {
      at_ += ahead_by + 2;
      return rate(operand(depth), from_body, token.at);
    }
    if (whole && ahead_by == 2 && !from_body) return std::nullopt;
    std::optional<Piece> of;
    const std::optional<TypedFault> fault = fault_;
    if (whole) {
      at_ += ahead_by;
      if (begins_factor() && now().kind != Token::Kind::number) of = factor(depth + 1);
    } else if (const auto name = find(token.text.substr(1))) {
      next();
      of = powered(piece_at(name->tex(), token.at + 1));
    }
    if (of && now().is("/") && ahead(1).text == "dt") {
      at_ += 2;
      return rate(*of, from_body, token.at);
    }
    at_ = begin;
    fault_ = fault;
    return std::nullopt;
  }

  /// What d/dt is taken of: the factors behind it.
  Piece operand(int depth) {
    Piece all = factor(depth + 1);
    while (begins_factor() || now().is("*")) {
      if (now().is("*")) next();
      const Piece right = factor(depth + 1);
      all.add(right.is_number || is_tensor(all) ? "\\cdot " : "\\,");
      all.add(right);
      all.inside.clear();
      all.is_single = false;
    }
    return all;
  }

  /// Nothing if no function has the name.
  std::optional<Piece> function(const Token& token, int depth) {
    const std::string& f = token.text;
    const bool two = f == "cross" || f == "dot" || f == "comp";
    if (!two && f != "norm2" && f != "norm" && f != "inertia" && f != "ddt" && f != "star")
      return std::nullopt;
    next(), next();
    const bool was_in_bars = std::exchange(in_bars_, false);
    const Piece first = sum(depth + 1);
    Piece second;
    if (two && now().is(",")) {
      next();
      if (f == "comp" && (now().kind == Token::Kind::number || now().kind == Token::Kind::name)) {
        second = piece_at(now().text, now().at);
        next();
      } else {
        second = sum(depth + 1);
      }
    } else if (two) {
      fail(now().at, in_quotes(f) + " takes two arguments, with a comma between them");
    }
    in_bars_ = was_in_bars;
    if (now().is(")"))
      next();
    else
      fail(now().at, "the bracket is not closed");
    const auto grouped = [](const Piece& p) { return around("\\left(", p, "\\right)"); };
    const auto part = [&](const Piece& p) { return is_one(p) ? p : grouped(p); };
    Piece made;
    if (f == "cross" || f == "dot") {
      Piece inside = part(first);
      inside.add(f == "cross" ? "\\times " : "\\cdot ");
      inside.add(part(second));
      made = grouped(inside);
      made.inside = inside.tex;
    } else if (f == "comp") {
      made = around("", grouped(first), "_{" + second.tex + '}');
    } else if (f == "norm2" || f == "norm") {
      made = around("\\left|", first, f == "norm" ? "\\right|" : "\\right|^{2}");
    } else if (f == "inertia") {
      made = around("\\left(" + std::string(kTensor) + "\\cdot ", part(first), "\\right)");
    } else {
      Piece of = first;
      of.is_single = is_one(first);
      made = rate(of, f == "star", token.at);
    }
    made.marks.insert(made.marks.begin(), {0, static_cast<std::uint32_t>(token.at)});
    made.is_single = false;
    return made;
  }

  /// Whether no sign stands outside of brackets: what is inside of others needs no brackets then.
  static bool is_one(const Piece& piece) {
    return piece.tex.find_first_of("+-/|(^") == std::string::npos &&
           piece.tex.find("\\,") == std::string::npos && piece.tex.find("\\times") == std::string::npos &&
           piece.tex.find("\\cdot") == std::string::npos && piece.tex.find("\\frac") == std::string::npos;
  }

  const TypedNames& names_;
  std::vector<Token> tokens_;
  std::size_t at_ = 0;
  bool in_bars_ = false;
  std::optional<TypedFault> fault_;
};

}  // namespace

TypedFormula typed_formula(std::string_view line, const TypedNames& names) {
  return Typing(line, names).read();
}

std::size_t typed_offset(const TypedFormula& formula, std::size_t tex_offset) {
  std::size_t typed = 0;
  for (const auto& [at, from] : formula.marks)
    if (at <= tex_offset) typed = from;
  return typed;
}

namespace {

enum class Level { sum, sign, product, atom };

struct Typed {
  std::string text;
  Level level = Level::atom;
};

class Printer {
 public:
  explicit Printer(const Expression& expression) : expression_(expression) {}

  Typed print(int index) const {
    using O = Operation;
    const ExpressionNode& n = expression_.nodes[static_cast<std::size_t>(index)];
    switch (n.operation) {
      case O::number:
        return {digits(n.number.value, 6), Level::atom};
      case O::constant:
        return {expression_.constants ? (*expression_.constants)[static_cast<std::size_t>(n.integer)] : "?",
                Level::atom};
      case O::quantity:
        return quantity(n.quantity);
      case O::negate:
        return {"-" + within(n.a, Level::sign), Level::sum};
      case O::add:
      case O::subtract:
        return {within(n.a, Level::sum) + (n.operation == O::add ? " + " : " - ") + within(n.b, Level::sign),
                Level::sum};
      case O::multiply: {
        const std::string right = within(n.b, Level::atom);
        return {within(n.a, Level::product) + (is_digit(right.front()) ? "*" : " ") + right, Level::product};
      }
      case O::divide:
        return {within(n.a, Level::atom) + '/' + within(n.b, Level::atom), Level::sign};
      case O::power:
        return {within(n.a, Level::atom) + '^' + std::to_string(n.integer), Level::atom};
      case O::dot:
        return {within(n.a, Level::product) + " . " + within(n.b, Level::product), Level::sign};
      case O::cross:
        return {within(n.a, Level::product) + " x " + within(n.b, Level::product), Level::sign};
      case O::norm2:
      case O::norm:
        return {'|' + print(n.a).text + '|' + (n.operation == O::norm2 ? "^2" : ""), Level::atom};
      case O::inertia:
        return {"I " + within(n.a, Level::atom), Level::product};
      case O::comp:
        return {"comp(" + print(n.a).text + ", " + std::to_string(n.integer + 1) + ')', Level::atom};
      case O::star:
      case O::ddt: {
        const std::string d = n.operation == O::star ? "d*" : "d";
        const Typed of = print(n.a);
        const bool is_name = is_letter(of.text.front()) && of.text.find_first_of(" (/'") == std::string::npos;
        return {d + (is_name ? of.text : '(' + of.text + ')') + "/dt", Level::atom};
      }
      default:
        return {expression_.text.substr(n.begin, n.end - n.begin), Level::atom};
    }
  }

 private:
  std::string within(int index, Level least) const {
    const Typed typed = print(index);
    return typed.level < least ? '(' + typed.text + ')' : typed.text;
  }

  static Typed quantity(Quantity quantity) {
    const std::string name(facts_of(quantity).name);
    if (name.size() == 3 && name.starts_with("dw")) return {name.substr(1) + '\'', Level::atom};
    return {name, Level::atom};
  }

  const Expression& expression_;
};

}  // namespace

std::string typing_of(const Expression& expression, int node) { return Printer(expression).print(node).text; }

}  // namespace polhode
