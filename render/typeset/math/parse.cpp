// SPDX-License-Identifier: MIT
#include "render/typeset/characters.h"
#include "render/typeset/math/parser.h"

#include <algorithm>
#include <utility>

namespace polhode {
Math MathParser::run() {
  Math math;
  open_.push_back({Open::Kind::formula, "", "", Token{}});
  math.root = std::make_shared<const MathNode>(formula());
  for (std::size_t i = 1; i < open_.size() && !tokens_.stopped(); ++i) never_closed(open_[i]);
  math.tag = std::move(tag_);
  math.terms = std::move(terms_);
  math.live = std::move(live_);
  math.references = std::move(references_);
  math.tag_offsets = std::move(tag_offsets_);
  math.term_offsets = std::move(term_offsets_);
  math.made = tokens_.made();
  return math;
}

MathNode MathParser::formula() {
  MathGrid grid;
  grid.kind = MathGrid::Kind::aligned;
  MathNode node = cells(grid, tokens_.peek());
  if (node.children.size() == 1) return std::move(node.children.front());
  return node;
}

MathNode MathParser::row() {
  MathNode made = node_of(Kind::row, {tokens_.peek().span.begin, tokens_.peek().span.begin});
  while (!at_end_of_row()) {
    const std::size_t before = made.children.size();
    item(made.children);
    for (std::size_t i = before; i < made.children.size(); ++i)
      made.span = joined(made.span, made.children[i].span);
  }
  return made;
}

bool MathParser::at_end_of_row() {
  const Token& token = tokens_.peek();
  const Open& open = open_.back();
  switch (token.kind) {
    case Token::Kind::end:
      return true;
    case Token::Kind::close:
      return closes("}");
    case Token::Kind::character:
      if (token.character == U'&') return ends_cell("&");
      if (token.character == U'$') return closes("$");
      return token.character == U']' && open.kind == Open::Kind::bracket;
    case Token::Kind::command:
      break;
    default:
      return false;
  }
  const MathCommand* command = math_command(token.name);
  if (command == nullptr) return false;
  switch (command->action) {
    case Action::right:
      return closes("\\right");
    case Action::middle:
      if (open.kind == Open::Kind::left) return true;
      tokens_.error(token, "\\middle stands outside of \\left … \\right");
      skip_delimiter();
      return at_end_of_row();
    case Action::end:
      return end_of_environment();
    case Action::row_end:
      return ends_cell("\\" + std::string(token.name));
    default:
      return false;
  }
}

bool MathParser::closes(const std::string& what) {
  if (open_.back().partner == what) return true;
  const Token token = tokens_.next();
  closes_nothing(token, what);
  if (what == "\\right") take_delimiter();
  return at_end_of_row();
}

void MathParser::closes_nothing(const Token& token, const std::string& what) {
  if (what == "$") return tokens_.error(token, "$ stands inside of a formula", "\\$ for the sign");
  const Open& open = open_.back();
  std::string hint;
  if (open.kind != Open::Kind::formula) hint = quoted(open) + " waits for " + open.partner;
  tokens_.error(token, what + " closes nothing", std::move(hint));
}

void MathParser::never_closed(const Open& open) {
  if (open.kind != Open::Kind::argument) tokens_.error(open.at, open.what + " is never closed");
}

std::string MathParser::quoted(const Open& open) const {
  constexpr std::size_t kShown = 16;
  std::string_view rest =
      tokens_.source().substr(std::min<std::size_t>(open.at.span.begin, tokens_.source().size()));
  rest = rest.substr(0, rest.find('\n'));
  if (open.at.origin >= 0 || rest.size() <= open.what.size()) return open.what;
  if (rest.size() <= kShown) return "\"" + std::string(rest) + "\"";
  std::size_t end = 0;
  while (end < kShown) next_character(rest, end);
  return "\"" + std::string(rest.substr(0, end)) + "…\"";
}

bool MathParser::ends_cell(const std::string& what) {
  const Open::Kind kind = open_.back().kind;
  if (kind == Open::Kind::formula || kind == Open::Kind::environment) return true;
  const Token token = tokens_.next();
  tokens_.error(token, what + " stands inside of " + open_.back().what,
                "close " + quoted(open_.back()) + " first");
  return at_end_of_row();
}

bool MathParser::end_of_environment() {
  const Token token = tokens_.next();
  const auto name = environment_name("\\end", token);
  if (name && open_.back().kind == Open::Kind::environment &&
      open_.back().partner == "\\end{" + *name + "}") {
    environment_end_ = tokens_.peek_raw().span.begin;
    return ended_ = true;
  }
  if (name) closes_nothing(token, "\\end{" + *name + "}");
  return at_end_of_row();
}

bool MathParser::close(Token* closing) {
  if (tokens_.peek().kind == Token::Kind::end && !ended_) return false;
  if (!ended_) {
    const Token token = tokens_.next();
    if (closing != nullptr) *closing = token;
  }
  ended_ = false;
  open_.pop_back();
  return true;
}

bool MathParser::open(Open::Kind kind, std::string what, std::string partner, const Token& at) {
  if (open_.size() > static_cast<std::size_t>(kMaxMathNesting)) {
    tokens_.error(at, "braces are nested deeper than " + std::to_string(kMaxMathNesting));
    tokens_.stop();
    return false;
  }
  open_.push_back({kind, std::move(what), std::move(partner), at});
  return true;
}

Result<Math, std::vector<TypeError>> parse_math(std::string_view tex, const MathMacros& macros,
                                                Language language) {
  MathErrors errors;
  if (tex.size() > kMaxMathBytes) {
    errors.add(kMaxMathBytes, "formula is longer than " + std::to_string(kMaxMathBytes) + " bytes");
    return Failure<std::vector<TypeError>>{errors.take()};
  }
  Math math = MathParser(tex, macros, errors).run();
  math.language = language;
  if (errors.none()) return math;
  return Failure<std::vector<TypeError>>{errors.take()};
}

}  // namespace polhode
