// SPDX-License-Identifier: MIT
// Text inside of formulas, and environments.
#include "base/spelling.h"
#include "render/typeset/characters.h"
#include "render/typeset/math/parser.h"

#include <algorithm>
#include <utility>

namespace polhode {
MathNode MathParser::text(const Token& token, Face face) {
  const Token at = tokens_.peek();
  if (at.kind != Token::Kind::open) {
    no_plain_argument(token, written(token) + "{…}");
    return {};
  }
  tokens_.next();
  MathNode made = node_of(Kind::row, token.span);
  if (!text_group(at, face, made)) return {};
  finish(made);
  if (made.children.size() == 1) {
    made.children.front().span = made.span;
    return std::move(made.children.front());
  }
  return made;
}

bool MathParser::text_group(const Token& at, Face face, MathNode& into) {
  if (!open(Open::Kind::brace, "{", "}", at)) return false;
  while (tokens_.peek_raw().kind != Token::Kind::end) {
    const Token token = tokens_.next_raw();
    into.span = joined(into.span, token.span);
    if (token.kind == Token::Kind::close) {
      open_.pop_back();
      return true;
    }
    if (!text_item(token, face, into)) return false;
  }
  return !tokens_.stopped();
}

bool MathParser::text_item(const Token& token, Face face, MathNode& into) {
  if (token.kind == Token::Kind::open) return text_group(token, face, into);
  if (token.is(U'$')) return formula_in_text(token, into);
  if (token.kind == Token::Kind::command) return text_command(token, face, into);
  char32_t c = token.character;
  if (c == U'~') c = 0xA0;
  if (c == U'\'') c = U'’';
  if (c == U'`') c = U'‘';
  add_text(token, face, c, into);
  return true;
}

void MathParser::add_text(const Token& token, Face face, char32_t c, MathNode& into) {
  const bool goes_on =
      !into.children.empty() && into.children.back().kind == Kind::text && into.children.back().face == face;
  if (!goes_on) {
    into.children.push_back(node_of(Kind::text, token.span));
    into.children.back().face = face;
  }
  MathNode& run = into.children.back();
  append_utf8(run.text, c);
  run.sources.push_back(token.span);
  run.span = joined(run.span, token.span);
}

bool MathParser::formula_in_text(const Token& token, MathNode& into) {
  if (!open(Open::Kind::dollar, "$", "$", token)) return false;
  into.children.push_back(row());
  return close();
}

bool MathParser::text_command(const Token& token, Face face, MathNode& into) {
  const MathCommand* known = math_command(token.name);
  if (known == nullptr) {
    unknown(token);
    return true;
  }
  if (known->action == Action::text) {
    const Token at = tokens_.peek();
    if (at.kind == Token::Kind::open)
      return text_group(tokens_.next(), static_cast<Face>(static_cast<int>(known->amount)), into);
    no_plain_argument(token, written(token) + "{…}");
    return true;
  }
  if (known->action == Action::space) {
    if (token.name == " ")
      add_text(token, face, U' ', into);
    else
      into.children.push_back(space(token, known->amount));
    return true;
  }
  if (known->action == Action::symbol && token.name.size() == 1) {
    add_text(token, face, known->character, into);
    return true;
  }
  tokens_.error(token, written(token) + " stands in text", "put it between $ and $");
  return true;
}

std::optional<std::string> MathParser::environment_name(std::string_view command, const Token& token) {
  const bool braced = tokens_.peek_raw().kind == Token::Kind::open;
  std::string name;
  if (braced) {
    tokens_.next_raw();
    while (tokens_.peek_raw().kind == Token::Kind::character) append_utf8(name, tokens_.next_raw().character);
  }
  if (!braced || name.empty() || tokens_.peek_raw().kind != Token::Kind::close) {
    tokens_.error(token, std::string(command) + " needs a name in braces",
                  std::string(command) + "{aligned}");
    return std::nullopt;
  }
  environment_end_ = tokens_.next_raw().span.end;
  return name;
}

MathNode MathParser::environment(const Token& token) {
  const auto name = environment_name("\\begin", token);
  if (!name) return {};
  auto grid = math_environment(*name);
  if (!grid) {
    const std::string near = closest_name(*name, math_environment_names());
    tokens_.error(token, "unknown environment " + *name,
                  near.empty() ? "such as aligned, pmatrix, cases" : "did you mean " + near + "?");
    grid.emplace();
  }
  if (!open(Open::Kind::environment, "\\begin{" + *name + "}", "\\end{" + *name + "}", token)) return {};
  if (grid->kind == MathGrid::Kind::array) array_columns(token, *grid);
  if (name->ends_with("at")) plain_argument(token, "\\begin{" + *name + "}{2}");
  if (grid->kind == MathGrid::Kind::aligned && tokens_.peek().is(U'[')) vertical_place(*name);
  const Alphabet before = std::exchange(alphabet_, Alphabet::normal);
  MathNode made = cells(*grid, token);
  alphabet_ = before;
  if (!close()) return {};
  made.span.end = std::max(made.span.end, environment_end_);
  return made;
}

void MathParser::vertical_place(const std::string& environment) {
  const Token bracket = tokens_.next();
  const Token place = tokens_.peek();
  const bool known = place.is(U't') || place.is(U'c') || place.is(U'b');
  if (known) tokens_.next();
  if (known && tokens_.peek().is(U']'))
    tokens_.next();
  else
    tokens_.error(bracket, "\\begin{" + environment + "} takes [t], [c] or [b]",
                  "put {} before another bracket");
}

void MathParser::array_columns(const Token& token, MathGrid& grid) {
  const auto columns = plain_argument(token, "\\begin{array}{lcr}");
  if (!columns) return;
  for (const char c : *columns) {
    if (c == 'l' || c == 'c' || c == 'r')
      grid.places += c;
    else if (c == '|')
      grid.columns_with_line.push_back(static_cast<int>(grid.places.size()));
    else if (c != ' ')
      return tokens_.error(token, "columns of an array are l, c, r and |, not " + *columns);
  }
}

MathNode MathParser::substack(const Token& token) {
  if (tokens_.peek().kind != Token::Kind::open) {
    tokens_.error(token, "\\substack needs its lines in braces", "\\substack{… \\\\ …}");
    return {};
  }
  const Token at = tokens_.next();
  if (!open(Open::Kind::environment, "{", "}", at)) return {};
  MathGrid grid;
  grid.kind = MathGrid::Kind::small;
  MathNode made = cells(grid, token);
  if (!close()) return {};
  return made;
}

MathNode MathParser::cells(MathGrid grid, const Token& at) {
  std::vector<std::vector<MathNode>> rows(1);
  lines_above(grid, 0);
  while (true) {
    rows.back().push_back(row());
    const Token& token = tokens_.peek();
    if (ended_ || token.kind == Token::Kind::end || token.kind == Token::Kind::close) break;
    const Token separator = tokens_.next();
    if (separator.is(U'&')) {
      const bool too_many = grid.kind == MathGrid::Kind::array && rows.back().size() >= grid.places.size();
      if (too_many && !grid.places.empty())
        tokens_.error(separator,
                      "more cells than columns of the array, " + std::to_string(grid.places.size()));
      continue;
    }
    grid.skips.resize(rows.size(), 0.0);
    grid.skips.back() = extra_skip(separator);
    rows.emplace_back();
    lines_above(grid, static_cast<int>(rows.size()) - 1);
  }
  return grid_node(std::move(grid), std::move(rows), at);
}

void MathParser::lines_above(MathGrid& grid, int at_row) {
  const bool inside = open_.back().kind == Open::Kind::environment;
  while (inside && tokens_.peek().is_command("hline")) {
    tokens_.next();
    grid.rows_with_line.push_back(at_row);
  }
}

double MathParser::extra_skip(const Token& separator) {
  if (!tokens_.peek_raw().is(U'[')) return 0.0;
  tokens_.next();
  std::string text;
  while (tokens_.peek_raw().kind == Token::Kind::character && !tokens_.peek_raw().is(U']'))
    append_utf8(text, tokens_.next_raw().character);
  const auto em = length_in_em(text);
  if (!tokens_.peek_raw().is(U']') || !em) {
    tokens_.error(separator, "bad length behind \\\\", "\\\\[4pt], or \\\\{} before a bracket");
    return 0.0;
  }
  tokens_.next_raw();
  return *em;
}

MathNode MathParser::grid_node(MathGrid grid, std::vector<std::vector<MathNode>> rows, const Token& at) {
  const bool last_is_empty = rows.back().size() == 1 && rows.back().front().children.empty();
  if (rows.size() > 1 && last_is_empty) rows.pop_back();
  grid.skips.resize(rows.size(), 0.0);
  std::size_t columns = grid.places.size();
  for (const auto& r : rows) columns = std::max(columns, r.size());
  grid.columns = static_cast<int>(columns);
  MathNode made = node_of(Kind::grid, at.span);
  made.atom = grid.left != 0 || grid.right != 0 ? MathClass::inner : MathClass::ordinary;
  for (auto& r : rows) {
    r.resize(columns, node_of(Kind::row, r.back().span));
    std::move(r.begin(), r.end(), std::back_inserter(made.children));
  }
  finish(made);
  made.grid = std::make_shared<const MathGrid>(std::move(grid));
  return made;
}

}  // namespace polhode
