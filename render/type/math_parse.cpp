// SPDX-License-Identifier: MIT
#include "render/type/characters.h"
#include "render/type/math_commands.h"
#include "render/type/math_lexer.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

namespace polhode {
namespace {

using Kind = MathNode::Kind;
using Token = MathToken;
using Action = MathCommand::Action;

SourceSpan joined(SourceSpan a, SourceSpan b) { return {std::min(a.begin, b.begin), std::max(a.end, b.end)}; }

MathNode node_of(Kind kind, SourceSpan span) {
  MathNode node;
  node.kind = kind;
  node.span = span;
  return node;
}

/// Letters, digits and hyphens, 1 to 64 of them: what may name a term.
bool is_term_id(std::string_view text) {
  const auto fits = [](char c) {
    return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') || c == '-';
  };
  return !text.empty() && text.size() <= 64 && std::all_of(text.begin(), text.end(), fits);
}

std::string trimmed(std::string text) {
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text.substr(std::min(text.find_first_not_of(' '), text.size()));
}

/// "2pt", "0.5em": em. TeX's points are of a ten-point font. Nothing if it is no length.
std::optional<double> length_in_em(const std::string& text) {
  struct Unit {
    std::string_view name;
    double em;
  };
  static constexpr std::array<Unit, 7> kUnits = {{{"em", 1.0},
                                                  {"ex", 0.45},
                                                  {"mu", 1.0 / 18.0},
                                                  {"pt", 0.1},
                                                  {"mm", 0.2845},
                                                  {"cm", 2.845},
                                                  {"px", 0.075}}};
  double value = 0.0, place = 1.0;
  bool digits = false, fraction = false;
  std::size_t i = text.find_first_not_of(' ');
  if (i == std::string::npos) return std::nullopt;
  const bool negative = text[i] == '-';
  if (negative) ++i;
  for (; i < text.size() && (text[i] == '.' || ('0' <= text[i] && text[i] <= '9')); ++i) {
    if (text[i] == '.') {
      if (fraction) return std::nullopt;
      fraction = true;
      continue;
    }
    digits = true;
    value = 10.0 * value + (text[i] - '0');
    if (fraction) place *= 10.0;
  }
  const std::string unit = trimmed(text.substr(i));
  for (const Unit& u : kUnits) {
    const double em = (negative ? -value : value) / place * u.em;
    constexpr double kLongest = 50.0;
    if (digits && unit == u.name && -kLongest <= em && em <= kLongest) return em;
  }
  return std::nullopt;
}

class MathParser {
 public:
  MathParser(std::string_view tex, const MathMacros& macros, MathErrors& errors)
      : tokens_(tex, macros, errors) {}

  Math run() {
    Math math;
    open_.push_back({Open::Kind::formula, "", "", Token{}});
    math.root = std::make_shared<const MathNode>(formula());
    for (std::size_t i = 1; i < open_.size() && !tokens_.stopped(); ++i) never_closed(open_[i]);
    math.tag = std::move(tag_);
    math.terms = std::move(terms_);
    math.tag_offsets = std::move(tag_offsets_);
    math.term_offsets = std::move(term_offsets_);
    return math;
  }

 private:
  /// What waits to be closed.
  struct Open {
    enum class Kind { formula, brace, left, environment, bracket, dollar, argument } kind;
    std::string what;     // as written: "{", "\left", "\begin{aligned}"
    std::string partner;  // what closes it
    Token at;
  };

  // --- rows ---------------------------------------------------------------------------------------------

  MathNode formula() {
    MathGrid grid;
    grid.kind = MathGrid::Kind::aligned;
    MathNode node = cells(grid, tokens_.peek());
    if (node.children.size() == 1) return std::move(node.children.front());
    return node;
  }

  /// Until what closes the innermost opener, or a cell's end; neither is read.
  MathNode row() {
    MathNode made = node_of(Kind::row, {tokens_.peek().span.begin, tokens_.peek().span.begin});
    while (!at_end_of_row()) {
      const std::size_t before = made.children.size();
      item(made.children);
      for (std::size_t i = before; i < made.children.size(); ++i)
        made.span = joined(made.span, made.children[i].span);
    }
    return made;
  }

  bool at_end_of_row() {
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

  /// Whether the first token closes the innermost opener. If not, it closes nothing, and is left behind.
  bool closes(const std::string& what) {
    if (open_.back().partner == what) return true;
    const Token token = tokens_.next();
    closes_nothing(token, what);
    if (what == "\\right") take_delimiter();
    return at_end_of_row();
  }

  void closes_nothing(const Token& token, const std::string& what) {
    if (what == "$") return tokens_.error(token, "$ stands inside of a formula", "\\$ for the sign");
    const Open& open = open_.back();
    std::string hint;
    if (open.kind != Open::Kind::formula) hint = quoted(open) + " waits for " + open.partner;
    tokens_.error(token, what + " closes nothing", std::move(hint));
  }

  void never_closed(const Open& open) {
    if (open.kind != Open::Kind::argument) tokens_.error(open.at, open.what + " is never closed");
  }

  /// The beginning of what it opens.
  std::string quoted(const Open& open) const {
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

  bool ends_cell(const std::string& what) {
    const Open::Kind kind = open_.back().kind;
    if (kind == Open::Kind::formula || kind == Open::Kind::environment) return true;
    const Token token = tokens_.next();
    tokens_.error(token, what + " stands inside of " + open_.back().what,
                  "close " + quoted(open_.back()) + " first");
    return at_end_of_row();
  }

  /// At \end: reads its name.
  bool end_of_environment() {
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

  /// What closes the opener has come: reads it. At the formula's end the opener stays open.
  bool close(Token* closing = nullptr) {
    if (tokens_.peek().kind == Token::Kind::end && !ended_) return false;
    if (!ended_) {
      const Token token = tokens_.next();
      if (closing != nullptr) *closing = token;
    }
    ended_ = false;
    open_.pop_back();
    return true;
  }

  bool open(Open::Kind kind, std::string what, std::string partner, const Token& at) {
    if (open_.size() > static_cast<std::size_t>(kMaxMathNesting)) {
      tokens_.error(at, "braces are nested deeper than " + std::to_string(kMaxMathNesting));
      tokens_.stop();
      return false;
    }
    open_.push_back({kind, std::move(what), std::move(partner), at});
    return true;
  }

  // --- atoms --------------------------------------------------------------------------------------------

  /// One more atom behind `into`, or something done to the last one.
  void item(std::vector<MathNode>& into) {
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
        case Action::line:
          return tokens_.error(tokens_.next(), "\\hline stands outside of an array", "at the start of a row");
        default:
          break;
      }
    }
    MathNode made = atom();
    if (!made.absent()) into.push_back(std::move(made));
  }

  static const MathCommand* command_of(const Token& token) {
    return token.kind == Token::Kind::command ? math_command(token.name) : nullptr;
  }

  MathNode atom() {
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

  MathNode group(const Token& at) {
    MathNode made;
    if (!open(Open::Kind::brace, "{", "}", at)) return made;
    made = row();
    made.span = joined(made.span, at.span);
    Token closing;
    if (close(&closing)) made.span = joined(made.span, closing.span);
    return made;
  }

  MathNode symbol(const Token& at, char32_t character, MathClass atom_class) const {
    MathNode made = node_of(Kind::symbol, at.span);
    made.character = character;
    made.atom = atom_class;
    made.alphabet = alphabet_;
    return made;
  }

  MathNode character(const Token& token) {
    if (token.character == U'~') return space(token, 0.25);
    if (token.character == U'#') {
      tokens_.error(token, "# stands in macros only", "\\# for the sign");
      return {};
    }
    const TypedSymbol typed = typed_symbol(token.character);
    return symbol(token, typed.character, typed.atom);
  }

  static MathNode space(const Token& token, double em) {
    MathNode made = node_of(Kind::space, token.span);
    made.amount = em;
    return made;
  }

  MathNode command(const Token& token) {
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

  MathNode unknown(const Token& token) {
    std::vector<std::string> names;
    for (const auto& [name, macro] : tokens_.macros()) names.push_back(name);
    for (const MathCommand& c : math_commands()) names.emplace_back(c.name);
    const std::string near = near_name(token.name, names);
    tokens_.error(token, "unknown command \\" + std::string(token.name),
                  near.empty() ? "" : "did you mean \\" + near + "?");
    return {};
  }

  // --- arguments ----------------------------------------------------------------------------------------

  /// A group in braces or a single atom. `usage` says how the command is written.
  MathNode argument(const Token& command, std::string_view usage) {
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

  static std::string written(const Token& token) {
    if (token.kind == Token::Kind::command) return "\\" + std::string(token.name);
    std::string text;
    append_utf8(text, token.character);
    return text;
  }

  static bool begins_argument(const Token& token) {
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

  /// What stands in brackets, if a bracket comes.
  MathNode optional_argument() {
    if (!tokens_.peek().is(U'[')) return {};
    const Token at = tokens_.next();
    if (!open(Open::Kind::bracket, "[", "]", at)) return {};
    MathNode made = row();
    close();
    return made;
  }

  /// The text of braces that hold no braces, without commands. Nothing, and an error, if there are none.
  std::optional<std::string> plain_argument(const Token& command, const std::string& usage,
                                            std::size_t* offset = nullptr) {
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

  /// Past the } of the group that has begun.
  void skip_group() {
    for (int depth = 1; depth > 0 && tokens_.peek_raw().kind != Token::Kind::end;) {
      const Token::Kind kind = tokens_.next_raw().kind;
      depth += kind == Token::Kind::open ? 1 : kind == Token::Kind::close ? -1 : 0;
    }
  }

  std::optional<std::string> no_plain_argument(const Token& command, const std::string& usage) {
    tokens_.error(command, written(command) + " needs text in braces", usage);
    return std::nullopt;
  }

  // --- scripts ------------------------------------------------------------------------------------------

  void script(std::vector<MathNode>& into) {
    const Token mark = tokens_.next();
    MathNode& target = scripted(into, mark);
    const bool below = mark.is(U'_');
    MathNode& place = target.children[below ? 1 : 2];
    if (!place.absent()) {
      tokens_.error(
          mark, below ? "double subscript" : "double superscript",
          below ? "braces tell which: {x_1}_2 or x_{1_2}" : "braces tell which: {x^a}^b or x^{a^b}");
    }
    MathNode made = mark.is(U'\'') ? primes(mark) : argument(mark, below ? "x_{…}" : "x^{…}");
    target.span = joined(target.span, made.span);
    place = std::move(made);
  }

  MathNode& scripted(std::vector<MathNode>& into, const Token& mark) {
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

  /// All primes that follow, and the superscript behind them.
  MathNode primes(const Token& first) {
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

  void set_limits(const MathCommand& command, std::vector<MathNode>& into) {
    const Token token = tokens_.next();
    const bool fits = !into.empty() && into.back().atom == MathClass::large;
    if (!fits)
      return tokens_.error(token, written(token) + " needs an operator before it", "\\sum" + written(token));
    into.back().limits = command.limits;
  }

  // --- commands with arguments --------------------------------------------------------------------------

  MathNode named_operator(const Token& token, const MathCommand& command) {
    MathNode made = node_of(Kind::text, token.span);
    made.atom = MathClass::large;
    made.limits = command.limits;
    made.text = command.text;
    made.sources.assign(made.text.size(), token.span);
    return made;
  }

  MathNode operator_name(const Token& token) {
    const bool starred = tokens_.peek().is(U'*');
    if (starred) tokens_.next();
    MathNode made = node_of(Kind::text, token.span);
    made.atom = MathClass::large;
    made.limits = starred ? Limits::in_display : Limits::beside;
    if (tokens_.peek().kind != Token::Kind::open) {
      no_plain_argument(token, "\\operatorname{…}");
      return {};
    }
    tokens_.next();
    Token t = tokens_.next_raw();
    for (; t.kind == Token::Kind::character || t.kind == Token::Kind::space ||
           (command_of(t) != nullptr && command_of(t)->action == Action::space);
         t = tokens_.next_raw()) {
      if (t.kind == Token::Kind::space) continue;
      append_utf8(made.text, t.kind == Token::Kind::command ? 0x2009 : t.character);
      made.sources.push_back(t.span);
    }
    made.span = joined(token.span, t.span);
    if (t.kind != Token::Kind::close) {
      if (t.kind == Token::Kind::open) skip_group();
      skip_group();
      no_plain_argument(token, "\\operatorname{…}");
    }
    return made;
  }

  MathNode alphabet(const Token& token, Alphabet wanted) {
    const Alphabet before = alphabet_;
    // \mathbf{\mathit{x}} and the other way round are bold italic.
    const bool both = (before == Alphabet::bold && wanted == Alphabet::italic) ||
                      (before == Alphabet::italic && wanted == Alphabet::bold);
    alphabet_ = both ? Alphabet::bold_italic : wanted;
    MathNode made = node_of(Kind::alphabet, token.span);
    made.children.push_back(argument(token, written(token) + "{…}"));
    alphabet_ = before;
    finish(made);
    if (auto word = as_word(made, wanted)) return std::move(*word);
    const MathNode& only = without_groups(made.children.front());
    made.atom = only.atom;
    made.limits = only.limits;
    return made;
  }

  /// \mathrm{max} is a word of the text's font, with its kerning.
  static std::optional<MathNode> as_word(const MathNode& letters, Alphabet wanted) {
    static const std::map<Alphabet, Face> kFaces = {{Alphabet::upright, Face::serif},
                                                    {Alphabet::bold, Face::serif_bold},
                                                    {Alphabet::italic, Face::serif_italic},
                                                    {Alphabet::sans, Face::sans},
                                                    {Alphabet::mono, Face::mono}};
    const auto face = kFaces.find(wanted);
    const MathNode& row = letters.children.front();
    if (face == kFaces.end() || row.kind != Kind::row || row.children.size() < 2) return std::nullopt;
    MathNode word = node_of(Kind::text, letters.span);
    word.face = face->second;
    for (const MathNode& child : row.children) {
      const bool is_letter = (U'a' <= child.character && child.character <= U'z') ||
                             (U'A' <= child.character && child.character <= U'Z');
      if (child.kind != Kind::symbol || !is_letter || child.alphabet != wanted) return std::nullopt;
      append_utf8(word.text, child.character);
      word.sources.push_back(child.span);
    }
    return word;
  }

  /// The span of a node that holds its children.
  static void finish(MathNode& node) {
    for (const MathNode& child : node.children)
      if (!child.absent()) node.span = joined(node.span, child.span);
  }

  MathNode fraction(const Token& token, const MathCommand& command) {
    MathNode made = node_of(Kind::fraction, token.span);
    made.binomial = command.action == Action::binomial;
    made.amount = made.binomial ? 0 : 1;
    made.forced_style = static_cast<int>(command.amount);
    const std::string usage = written(token) + "{…}{…}";
    made.children.push_back(argument(token, usage));
    if (!tokens_.stopped()) made.children.push_back(argument(token, usage));
    made.children.resize(2);
    finish(made);
    return made;
  }

  /// a \over b: all before and all behind, as far as the braces go.
  void infix(const MathCommand& command, std::vector<MathNode>& into) {
    const Token token = tokens_.next();
    MathNode made = node_of(Kind::fraction, token.span);
    made.binomial = command.action == Action::infix_choose;
    made.amount = command.action == Action::infix_over ? 1 : 0;
    MathNode above = node_of(Kind::row, token.span);
    above.children = std::move(into);
    into.clear();
    finish(above);
    made.children.push_back(std::move(above));
    if (++infix_depth_ > kMaxMathNesting) {
      tokens_.error(token, "braces are nested deeper than " + std::to_string(kMaxMathNesting));
      tokens_.stop();
    }
    made.children.push_back(row());
    --infix_depth_;
    finish(made);
    into.push_back(std::move(made));
  }

  MathNode radical(const Token& token) {
    MathNode made = node_of(Kind::radical, token.span);
    const std::size_t waiting = open_.size();
    MathNode degree = optional_argument();
    if (tokens_.stopped() || open_.size() > waiting) return {};
    made.children.push_back(argument(token, "\\sqrt{…}"));
    made.children.push_back(std::move(degree));
    finish(made);
    return made;
  }

  MathNode delimiter_node(const Token& token, char32_t character) const {
    MathNode made = node_of(Kind::delimiter, token.span);
    made.character = character;
    return made;
  }

  /// The delimiter that comes next, if one does.
  std::optional<char32_t> next_delimiter() {
    const Token& token = tokens_.peek();
    if (token.is(U'.')) return 0;
    char32_t c = token.kind == Token::Kind::character ? token.character : 0;
    const MathCommand* command = command_of(token);
    if (command != nullptr && command->action == Action::symbol) c = command->character;
    const char32_t found = c == 0 ? 0 : delimiter_of(c);
    if (found == 0) return std::nullopt;
    return found;
  }

  void take_delimiter() {
    if (next_delimiter()) tokens_.next();
  }
  void skip_delimiter() {
    tokens_.next();
    take_delimiter();
  }

  MathNode delimiter(const Token& command, std::string_view usage) {
    const auto found = next_delimiter();
    if (!found) {
      tokens_.error(command, written(command) + " needs a delimiter", std::string(usage));
      return delimiter_node(command, 0);
    }
    return delimiter_node(tokens_.next(), *found);
  }

  MathNode fenced(const Token& token) {
    MathNode made = node_of(Kind::fenced, token.span);
    made.atom = MathClass::inner;
    if (!open(Open::Kind::left, "\\left", "\\right", token)) return {};
    constexpr std::string_view kUsage = "\\left( … \\right), with a dot where there is none";
    made.children.push_back(delimiter(token, kUsage));
    while (true) {
      made.children.push_back(row());
      const bool more = tokens_.peek().is_command("middle");
      Token at;
      if (more)
        at = tokens_.next();
      else if (!close(&at))
        return {};
      made.children.push_back(delimiter(at, kUsage));
      if (!more) break;
    }
    finish(made);
    return made;
  }

  MathNode big(const Token& token, const MathCommand& command) {
    MathNode made = delimiter(token, written(token) + "(");
    made.span = joined(made.span, token.span);
    made.atom = command.atom;
    // amsmath: 1.2, 1.8, 2.4 and 3 times the height of a parenthesis.
    static constexpr double kParenthesis = 0.829;
    static constexpr std::array<double, 5> kHeights = {0.0, 1.2 * kParenthesis, 1.8 * kParenthesis,
                                                       2.4 * kParenthesis, 3.0 * kParenthesis};
    made.amount = kHeights[static_cast<std::size_t>(command.amount)];
    return made;
  }

  MathNode stacked(const Token& token, const MathCommand& command) {
    MathNode made = node_of(Kind::stacked, token.span);
    const std::string usage = written(token) + "{…}{…}";
    MathNode script = argument(token, usage);
    if (tokens_.stopped()) return {};
    made.children.resize(3);
    made.children[0] = argument(token, usage);
    made.children[command.action == Action::underset ? 2 : 1] = std::move(script);
    made.atom = without_groups(made.children[0]).atom;
    if (command.action == Action::stackrel) made.atom = MathClass::relation;
    if (made.atom == MathClass::large) made.atom = MathClass::ordinary;
    finish(made);
    return made;
  }

  MathNode arrow(const Token& token, const MathCommand& command) {
    MathNode made = node_of(Kind::arrow, token.span);
    made.character = command.character;
    made.atom = MathClass::relation;
    const std::size_t waiting = open_.size();
    MathNode below = optional_argument();
    if (tokens_.stopped() || open_.size() > waiting) return {};
    made.children.push_back(argument(token, written(token) + "{…}"));
    made.children.push_back(std::move(below));
    finish(made);
    return made;
  }

  MathNode negate(const Token& token) {
    MathNode base = argument(token, "\\not=");
    const MathNode& only = without_groups(base);
    const char32_t struck = only.kind == Kind::symbol ? negated(only.character) : 0;
    MathNode made = node_of(struck != 0 ? Kind::symbol : Kind::cancel, joined(token.span, base.span));
    made.atom = only.atom;
    made.character = struck != 0 ? struck : U'n';
    if (struck == 0) made.children.push_back(std::move(base));
    return made;
  }

  MathNode hspace(const Token& token) {
    if (tokens_.peek().is(U'*')) tokens_.next();
    const std::string usage = written(token) + "{1em}";
    const auto text = plain_argument(token, usage);
    if (!text) return {};
    const auto em = length_in_em(*text);
    if (!em) tokens_.error(token, "bad length " + *text, usage + ", units em, ex, mu, pt, mm, cm");
    MathNode made = space(token, em.value_or(0.0));
    made.span.end = std::max(made.span.end, last_end_);
    return made;
  }

  std::optional<Color> color_argument(const Token& token) {
    const auto name = plain_argument(token, written(token) + "{blue}{…}");
    if (!name) return std::nullopt;
    if (const auto named = named_color(*name)) return named;
    if (name->size() == 7 && name->front() == '#' &&
        name->find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos)
      return color_from_hex(static_cast<unsigned>(std::strtoul(name->c_str() + 1, nullptr, 16)));
    const std::string near = near_name(*name, color_names());
    tokens_.error(token, "unknown color " + *name,
                  near.empty() ? "write #RRGGBB, or blue, green, red …" : "did you mean " + near + "?");
    return Color{};
  }

  MathNode text_color(const Token& token) {
    MathNode made = node_of(Kind::color, token.span);
    const auto color = color_argument(token);
    if (!color) return {};
    made.color = *color;
    made.children.push_back(argument(token, "\\textcolor{blue}{…}"));
    finish(made);
    return made;
  }

  void color_of_rest(std::vector<MathNode>& into) {
    const Token token = tokens_.next();
    MathNode made = node_of(Kind::color, token.span);
    const auto color = color_argument(token);
    if (!color) return;
    made.color = *color;
    if (++infix_depth_ > kMaxMathNesting) {
      tokens_.error(token, "braces are nested deeper than " + std::to_string(kMaxMathNesting));
      tokens_.stop();
    }
    made.children.push_back(row());
    --infix_depth_;
    finish(made);
    into.push_back(std::move(made));
  }

  MathNode term(const Token& token) {
    std::size_t offset = token.span.begin;
    const auto id = plain_argument(token, "\\term{…}", &offset);
    if (!id) return {};
    Token place = token;
    place.span.begin = static_cast<std::uint32_t>(offset);
    if (!is_term_id(*id))
      tokens_.error(place, "bad term id \"" + *id + "\"",
                    "an id has 1 to 64 of the characters a-z, A-Z, 0-9 and -");
    terms_.push_back(*id);
    term_offsets_.push_back(offset);
    const Token after = tokens_.peek();
    if (after.kind != Token::Kind::open) {
      tokens_.error(after, "\\term needs its formula in braces", "\\term{" + *id + "}{…}");
      return {};
    }
    MathNode made = node_of(Kind::term, token.span);
    made.text = *id;
    made.children.push_back(argument(token, "\\term{id}{…}"));
    finish(made);
    made.atom = without_groups(made.children.front()).atom;
    return made;
  }

  void tag() {
    const Token token = tokens_.next();
    std::size_t offset = token.span.begin;
    if (tokens_.peek().is(U'*')) tokens_.next();
    const auto name = plain_argument(token, "\\tag{…}", &offset);
    if (!name) return;
    tag_ += (tag_.empty() ? "" : ", ") + *name;
    tag_offsets_.push_back(offset);
  }

  /// Accents, bars, braces, boxes and what else does something to one argument.
  MathNode wrapped(const Token& token, const MathCommand& command) {
    MathNode made = node_of(Kind::row, token.span);
    made.character = command.character;
    made.wide = command.wide;
    made.amount = command.amount;
    switch (command.action) {
      case Action::accent:
        made.kind = Kind::accent;
        break;
      case Action::bar:
        made.kind = Kind::bar;
        break;
      case Action::brace:
        made.kind = Kind::brace;
        made.limits = Limits::above_below;
        break;
      case Action::cancel:
        made.kind = Kind::cancel;
        break;
      case Action::box:
        made.kind = Kind::box;
        break;
      case Action::phantom:
        made.kind = Kind::phantom;
        break;
      case Action::atom:
        made.atom = command.atom;
        break;
      default:
        return {};
    }
    if (made.kind == Kind::row && made.atom == MathClass::large) made.limits = Limits::in_display;
    made.children.push_back(argument(token, written(token) + "{…}"));
    if (made.kind == Kind::cancel) made.atom = without_groups(made.children.front()).atom;
    finish(made);
    return made;
  }

  // --- text ---------------------------------------------------------------------------------------------

  MathNode text(const Token& token, Face face) {
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

  /// What stands in braces, as runs of text and formulas between $, behind `into`.
  bool text_group(const Token& at, Face face, MathNode& into) {
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

  bool text_item(const Token& token, Face face, MathNode& into) {
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

  static void add_text(const Token& token, Face face, char32_t c, MathNode& into) {
    const bool goes_on = !into.children.empty() && into.children.back().kind == Kind::text &&
                         into.children.back().face == face;
    if (!goes_on) {
      into.children.push_back(node_of(Kind::text, token.span));
      into.children.back().face = face;
    }
    MathNode& run = into.children.back();
    append_utf8(run.text, c);
    run.sources.push_back(token.span);
    run.span = joined(run.span, token.span);
  }

  bool formula_in_text(const Token& token, MathNode& into) {
    if (!open(Open::Kind::dollar, "$", "$", token)) return false;
    into.children.push_back(row());
    return close();
  }

  bool text_command(const Token& token, Face face, MathNode& into) {
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

  // --- environments -------------------------------------------------------------------------------------

  std::optional<std::string> environment_name(std::string_view command, const Token& token) {
    const bool braced = tokens_.peek_raw().kind == Token::Kind::open;
    std::string name;
    if (braced) {
      tokens_.next_raw();
      while (tokens_.peek_raw().kind == Token::Kind::character)
        append_utf8(name, tokens_.next_raw().character);
    }
    if (!braced || name.empty() || tokens_.peek_raw().kind != Token::Kind::close) {
      tokens_.error(token, std::string(command) + " needs a name in braces",
                    std::string(command) + "{aligned}");
      return std::nullopt;
    }
    environment_end_ = tokens_.next_raw().span.end;
    return name;
  }

  MathNode environment(const Token& token) {
    const auto name = environment_name("\\begin", token);
    if (!name) return {};
    auto grid = math_environment(*name);
    if (!grid) {
      const std::string near = near_name(*name, math_environment_names());
      tokens_.error(token, "unknown environment " + *name,
                    near.empty() ? "such as aligned, pmatrix, cases" : "did you mean " + near + "?");
      grid.emplace();
    }
    if (!open(Open::Kind::environment, "\\begin{" + *name + "}", "\\end{" + *name + "}", token)) return {};
    if (grid->kind == MathGrid::Kind::array) array_columns(token, *grid);
    if (name->ends_with("at")) plain_argument(token, "\\begin{" + *name + "}{2}");
    if (grid->kind == MathGrid::Kind::aligned && tokens_.peek().is(U'[')) skip_bracket();
    const Alphabet before = std::exchange(alphabet_, Alphabet::normal);
    MathNode made = cells(*grid, token);
    alphabet_ = before;
    if (!close()) return {};
    made.span.end = std::max(made.span.end, environment_end_);
    return made;
  }

  /// [t] of aligned: alignments are centred on the axis always.
  void skip_bracket() {
    while (tokens_.peek().kind == Token::Kind::character && !tokens_.peek().is(U']')) tokens_.next();
    if (tokens_.peek().is(U']')) tokens_.next();
  }

  void array_columns(const Token& token, MathGrid& grid) {
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

  MathNode substack(const Token& token) {
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

  /// Cells until what closes the innermost opener; rows shorter than others are filled with empty cells.
  MathNode cells(MathGrid grid, const Token& at) {
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
          tokens_.error(separator, "more cells than the " + std::to_string(grid.places.size()) +
                                       " columns of the array");
        continue;
      }
      grid.skips.resize(rows.size(), 0.0);
      grid.skips.back() = extra_skip(separator);
      rows.emplace_back();
      lines_above(grid, static_cast<int>(rows.size()) - 1);
    }
    return grid_node(std::move(grid), std::move(rows), at);
  }

  void lines_above(MathGrid& grid, int at_row) {
    while (tokens_.peek().is_command("hline")) {
      tokens_.next();
      grid.rows_with_line.push_back(at_row);
    }
  }

  /// \\[2pt]
  double extra_skip(const Token& separator) {
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

  static MathNode grid_node(MathGrid grid, std::vector<std::vector<MathNode>> rows, const Token& at) {
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

  MathTokens tokens_;
  std::vector<Open> open_;
  Alphabet alphabet_ = Alphabet::normal;
  int infix_depth_ = 0;
  bool ended_ = false;  // the \end that the innermost environment waits for has been read
  std::uint32_t environment_end_ = 0, last_end_ = 0;
  std::string tag_;
  std::vector<std::string> terms_;
  std::vector<std::size_t> tag_offsets_, term_offsets_;
};

}  // namespace

const MathNode& without_groups(const MathNode& node) {
  const MathNode* inner = &node;
  while ((inner->kind == Kind::row || inner->kind == Kind::alphabet) && inner->children.size() == 1)
    inner = &inner->children.front();
  return *inner;
}

bool same_math(const MathNode& first, const MathNode& second) {
  const MathNode& a = without_groups(first);
  const MathNode& b = without_groups(second);
  if (a.kind != b.kind || a.character != b.character || a.alphabet != b.alphabet || a.text != b.text ||
      a.amount != b.amount || a.wide != b.wide || a.face != b.face || a.binomial != b.binomial ||
      a.children.size() != b.children.size())
    return false;
  if ((a.grid == nullptr) != (b.grid == nullptr) || (a.grid && *a.grid != *b.grid)) return false;
  return std::equal(a.children.begin(), a.children.end(), b.children.begin(), same_math);
}

Result<Math, std::vector<TypeError>> parse_math(std::string_view tex, const MathMacros& macros) {
  MathErrors errors;
  if (tex.size() > kMaxMathBytes) {
    errors.add(kMaxMathBytes, "formula is longer than " + std::to_string(kMaxMathBytes) + " bytes");
    return Failure<std::vector<TypeError>>{errors.take()};
  }
  Math math = MathParser(tex, macros, errors).run();
  if (errors.none()) return math;
  return Failure<std::vector<TypeError>>{errors.take()};
}

}  // namespace polhode
