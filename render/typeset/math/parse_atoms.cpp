// SPDX-License-Identifier: MIT
// Atoms, arguments and scripts.
#include "base/spelling.h"
#include "render/typeset/characters.h"
#include "render/typeset/math/parser.h"

#include <algorithm>
#include <utility>

namespace polhode {
std::string trimmed(std::string text) {
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text.substr(std::min(text.find_first_not_of(' '), text.size()));
}

void MathParser::item(std::vector<MathNode>& into) {
  const Token token = tokens_.peek();
  if (token.is(U'^') || token.is(U'_') || token.is(U'\'')) return script(into);
  const MathCommand* command = command_of(token);
  if (command != nullptr) {
    switch (command->action) {
      case Action::limits:
        return set_limits(*command, into);
      case Action::infix_over:
      case Action::infix_choose:
      case Action::infix_atop:
        return infix(*command, into);
      case Action::color:
        return color_of_rest(into);
      case Action::tag:
        return tag();
      case Action::nothing:
        static_cast<void>(tokens_.next());
        return;
      case Action::live:
      case Action::value:
        static_cast<void>(tokens_.next());
        return computed_number(token, *command, into);
      case Action::line:
        return tokens_.error(tokens_.next(), "\\hline stands outside of an array", "at the start of a row");
      default:
        break;
    }
  }
  MathNode made = atom();
  if (!made.absent()) into.push_back(std::move(made));
}

const MathCommand* MathParser::command_of(const Token& token) {
  return token.kind == Token::Kind::command ? math_command(token.name) : nullptr;
}

MathNode MathParser::atom() {
  const Token token = tokens_.next();
  switch (token.kind) {
    case Token::Kind::open:
      return group(token);
    case Token::Kind::character:
      return character(token);
    case Token::Kind::command:
      return command(token);
    default:
      return {};
  }
}

MathNode MathParser::group(const Token& at) {
  MathNode made;
  if (!open(Open::Kind::brace, "{", "}", at)) return made;
  made = row();
  made.span = joined(made.span, at.span);
  Token closing;
  if (close(&closing)) made.span = joined(made.span, closing.span);
  return made;
}

MathNode MathParser::symbol(const Token& at, char32_t character, MathClass atom_class) const {
  MathNode made = node_of(Kind::symbol, at.span);
  made.character = character;
  made.atom = atom_class;
  made.alphabet = alphabet_;
  return made;
}

MathNode MathParser::character(const Token& token) {
  if (token.character == U'~') return space(token, 0.25);
  if (token.character == U'#') {
    tokens_.error(token, "# stands in macros only", "\\# for the sign");
    return {};
  }
  const TypedSymbol typed = typed_symbol(token.character);
  return symbol(token, typed.character, typed.atom);
}

MathNode MathParser::space(const Token& token, double em) {
  MathNode made = node_of(Kind::space, token.span);
  made.amount = em;
  return made;
}

MathNode MathParser::command(const Token& token) {
  const MathCommand* known = math_command(token.name);
  if (known == nullptr) return unknown(token);
  switch (known->action) {
    case Action::symbol:
      return symbol(token, known->character, known->atom);
    case Action::large_operator: {
      MathNode made = symbol(token, known->character, MathClass::large);
      made.limits = known->limits;
      return made;
    }
    case Action::named_operator:
      return named_operator(token, *known);
    case Action::space:
      return space(token, known->amount);
    case Action::style: {
      MathNode made = node_of(Kind::style, token.span);
      made.amount = known->amount;
      return made;
    }
    case Action::alphabet:
      return alphabet(token, static_cast<Alphabet>(static_cast<int>(known->amount)));
    case Action::text:
      return text(token, static_cast<Face>(static_cast<int>(known->amount)));
    case Action::fraction:
    case Action::binomial:
      return fraction(token, *known);
    case Action::radical:
      return radical(token);
    case Action::left:
      return fenced(token);
    case Action::big:
      return big(token, *known);
    case Action::begin:
      return environment(token);
    case Action::substack:
      return substack(token);
    case Action::operator_name:
      return operator_name(token);
    case Action::text_color:
      return text_color(token);
    case Action::term:
      return term(token);
    case Action::proved:
      return proved_part(token);
    case Action::live:
    case Action::value: {
      MathNode made = node_of(Kind::row, token.span);
      computed_number(token, *known, made.children);
      finish(made);
      return made;
    }
    case Action::reference:
      return reference(token);
    case Action::arrow:
      return arrow(token, *known);
    case Action::negate:
      return negate(token);
    case Action::hspace:
      return hspace(token);
    case Action::overset:
    case Action::underset:
    case Action::stackrel:
      return stacked(token, *known);
    default:
      return wrapped(token, *known);
  }
}

MathNode MathParser::unknown(const Token& token) {
  std::vector<std::string_view> names;
  for (const auto& [name, macro] : tokens_.macros()) names.push_back(name);
  names.insert(names.end(), math_command_names().begin(), math_command_names().end());
  const std::string near = closest_name(token.name, names);
  tokens_.error(token, "unknown command \\" + std::string(token.name),
                near.empty() ? "" : "did you mean \\" + near + "?");
  return {};
}

MathNode MathParser::argument(const Token& command, std::string_view usage) {
  const Token first = tokens_.peek();
  if (!begins_argument(first)) {
    tokens_.error(command, written(command) + " needs its argument in braces", std::string(usage));
    return node_of(Kind::row, first.span);
  }
  if (first.kind == Token::Kind::open) return group(tokens_.next());
  if (!open(Open::Kind::argument, written(command), "its argument", first)) return {};
  MathNode made = atom();
  if (!tokens_.stopped() && open_.back().kind == Open::Kind::argument) open_.pop_back();
  if (made.absent()) made = node_of(Kind::row, first.span);
  return made;
}

std::string MathParser::written(const Token& token) {
  if (token.kind == Token::Kind::command) return "\\" + std::string(token.name);
  std::string text;
  append_utf8(text, token.character);
  return text;
}

bool MathParser::begins_argument(const Token& token) {
  if (token.kind == Token::Kind::end || token.kind == Token::Kind::close) return false;
  if (token.kind == Token::Kind::character) {
    for (const char32_t c : {U'^', U'_', U'&', U'\'', U'$'})
      if (token.character == c) return false;
  }
  const MathCommand* command = command_of(token);
  if (command == nullptr) return true;
  switch (command->action) {
    case Action::right:
    case Action::middle:
    case Action::end:
    case Action::row_end:
    case Action::limits:
    case Action::infix_over:
    case Action::infix_choose:
    case Action::infix_atop:
    case Action::tag:
    case Action::line:
    case Action::color:
    case Action::nothing:
    case Action::style:
      return false;
    default:
      return true;
  }
}

MathNode MathParser::optional_argument() {
  if (!tokens_.peek().is(U'[')) return {};
  const Token at = tokens_.next();
  if (!open(Open::Kind::bracket, "[", "]", at)) return {};
  MathNode made = row();
  close();
  return made;
}

std::optional<std::string> MathParser::plain_argument(const Token& command, const std::string& usage,
                                                      std::size_t* offset) {
  if (tokens_.peek().kind != Token::Kind::open) return no_plain_argument(command, usage);
  Token token = tokens_.next();
  if (offset != nullptr) *offset = token.span.end;
  std::string text;
  for (token = tokens_.peek_raw(); token.kind != Token::Kind::close; token = tokens_.peek_raw()) {
    if (token.kind != Token::Kind::character && token.kind != Token::Kind::space) {
      skip_group();
      return no_plain_argument(command, usage);
    }
    append_utf8(text, tokens_.next_raw().character);
  }
  last_end_ = tokens_.next_raw().span.end;
  return trimmed(std::move(text));
}

void MathParser::skip_group() {
  for (int depth = 1; depth > 0 && tokens_.peek_raw().kind != Token::Kind::end;) {
    const Token::Kind kind = tokens_.next_raw().kind;
    depth += kind == Token::Kind::open ? 1 : kind == Token::Kind::close ? -1 : 0;
  }
}

std::optional<std::string> MathParser::no_plain_argument(const Token& command, const std::string& usage) {
  tokens_.error(command, written(command) + " needs text in braces", usage);
  return std::nullopt;
}

void MathParser::script(std::vector<MathNode>& into) {
  const Token mark = tokens_.next();
  MathNode& target = scripted(into, mark);
  const bool below = mark.is(U'_');
  MathNode& place = target.children[below ? 1 : 2];
  if (!place.absent()) {
    tokens_.error(mark, below ? "double subscript" : "double superscript",
                  below ? "braces tell which: {x_1}_2 or x_{1_2}" : "braces tell which: {x^a}^b or x^{a^b}");
  }
  MathNode made = mark.is(U'\'') ? primes(mark) : argument(mark, below ? "x_{…}" : "x^{…}");
  target.span = joined(target.span, made.span);
  place = std::move(made);
}

MathNode& MathParser::scripted(std::vector<MathNode>& into, const Token& mark) {
  const bool has_base = !into.empty() && into.back().kind != Kind::space && into.back().kind != Kind::style;
  if (has_base && into.back().kind == Kind::scripts) return into.back();
  MathNode made = node_of(Kind::scripts, mark.span);
  made.children.resize(3);
  if (has_base) {
    made.children[0] = std::move(into.back());
    into.pop_back();
  } else {
    made.children[0] = node_of(Kind::row, {mark.span.begin, mark.span.begin});
  }
  const MathNode& base = made.children[0];
  made.span = joined(made.span, base.span);
  made.atom = base.atom;
  made.limits = base.limits;
  into.push_back(std::move(made));
  return into.back();
}

MathNode MathParser::primes(const Token& first) {
  MathNode made = node_of(Kind::row, first.span);
  Token mark = first;
  for (int count = 1; mark.kind != Token::Kind::end; count = 1) {
    Token all = mark;
    for (; count < 4 && tokens_.peek().is(U'\''); ++count) all.span = joined(all.span, tokens_.next().span);
    constexpr std::u32string_view kPrimes = U"′″‴⁗";
    made.children.push_back(symbol(all, kPrimes[static_cast<std::size_t>(count - 1)], MathClass::ordinary));
    made.span = joined(made.span, all.span);
    mark = tokens_.peek().is(U'\'') ? tokens_.next() : Token{};
  }
  if (tokens_.peek().is(U'^')) {
    mark = tokens_.next();
    MathNode above = argument(mark, "x^{…}");
    made.span = joined(made.span, above.span);
    made.children.push_back(std::move(above));
  }
  return made;
}

void MathParser::set_limits(const MathCommand& command, std::vector<MathNode>& into) {
  const Token token = tokens_.next();
  const bool fits = !into.empty() && into.back().atom == MathClass::large;
  if (!fits)
    return tokens_.error(token, written(token) + " needs an operator before it", "\\sum" + written(token));
  into.back().limits = command.limits;
}

}  // namespace polhode
