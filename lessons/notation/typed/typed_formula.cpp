// SPDX-License-Identifier: MIT
#include "lessons/notation/typed/typed_formula.h"

#include "base/ascii.h"
#include "lessons/diagnostics/report.h"

#include <algorithm>
#include <utility>

namespace polhode {
namespace {

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

class Typing {
 public:
  Typing(std::string_view line, const TypedNames& names) : names_(names) {
    TypedTokens read = read_typed_tokens(line, names);
    tokens_ = std::move(read.tokens);
    fault_ = std::move(read.fault);
  }

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
    if (now().kind != TypedToken::Kind::end) {
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
  const TypedToken& now() const { return tokens_[at_]; }
  const TypedToken& ahead(std::size_t n) const { return tokens_[std::min(at_ + n, tokens_.size() - 1)]; }
  void next() {
    if (at_ + 1 < tokens_.size()) ++at_;
  }

  void fail(std::size_t at, std::string message, std::string hint = {}) {
    if (!fault_) fault_ = TypedFault{at, std::move(message), std::move(hint)};
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
    return now().kind == TypedToken::Kind::name || now().kind == TypedToken::Kind::number || now().is("(") ||
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
  static bool is_tensor(const Piece& piece) { return piece.tex.ends_with(kTensorTex); }

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
    const TypedToken token = now();
    if (depth > kMaxTypedNesting) {
      fail(token.at, "brackets are nested too deep here");
      at_ = tokens_.size() - 1;
      return piece_at("\\ldots", token.at);
    }
    if (token.kind == TypedToken::Kind::number) {
      next();
      Piece made = piece_at(token.text, token.at);
      made.is_number = true;
      return powered(std::move(made));
    }
    if (token.is("(") || token.is("|")) return bracketed(token, depth);
    if (token.kind == TypedToken::Kind::name) return named(token, depth);
    fail(token.at, token.is("-") ? "two signs stand in a row" : "something is missing here",
         token.is("-") ? "write brackets: a*(-b)" : "");
    if (token.is("-")) {
      next();
      return around("\\left(-", factor(depth + 1), "\\right)");
    }
    return piece_at("\\ldots ", token.at);
  }

  Piece bracketed(const TypedToken& token, int depth) {
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
    const TypedToken index = now();
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
      const TypedToken token = now();
      next();
      std::string exponent = token.text.substr(1);
      if (exponent.empty()) {
        const bool bracket = now().is("(");
        if (bracket) next();
        if (now().is("-")) exponent = "-", next();
        if (now().kind == TypedToken::Kind::number && now().text.find('.') == std::string::npos) {
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

  Piece named(const TypedToken& token, int depth) {
    if (auto made = quotient_rate(token, depth)) return powered(std::move(*made));
    if (ahead(1).is("(") && !printed_name(token.text, names_))
      if (auto made = function(token, depth)) return primed(powered(std::move(*made)), token.at);
    if (const std::string& t = token.text; t.size() > 1 && t[0] == 'd' && is_digit(t.back()))
      if (const auto name = printed_name(t.substr(1), names_);
          name && !name->is_vector && !printed_name(t, names_)) {
        next();
        return powered(piece_at(name->rate(1), token.at));  // dw1
      }
    const auto name = printed_name(token.text, names_);
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
  std::optional<Piece> quotient_rate(const TypedToken& token, int depth) {
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
      if (begins_factor() && now().kind != TypedToken::Kind::number) of = factor(depth + 1);
    } else if (const auto name = printed_name(token.text.substr(1), names_)) {
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
  std::optional<Piece> function(const TypedToken& token, int depth) {
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
      if (f == "comp" && (now().kind == TypedToken::Kind::number || now().kind == TypedToken::Kind::name)) {
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
      made = around("\\left(" + std::string(kTensorTex) + "\\cdot ", part(first), "\\right)");
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
  std::vector<TypedToken> tokens_;
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

}  // namespace polhode
