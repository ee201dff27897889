// SPDX-License-Identifier: MIT
// Commands that take arguments.
#include "base/spelling.h"
#include "base/utf8.h"
#include "render/typeset/characters.h"
#include "render/typeset/math/parser.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <utility>

namespace polhode {
namespace {

/// Letters, digits and hyphens, 1 to 64 of them: what may name a term.
bool is_term_id(std::string_view text) {
  const auto fits = [](char c) {
    return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') || c == '-';
  };
  return !text.empty() && text.size() <= 64 && std::all_of(text.begin(), text.end(), fits);
}

}  // namespace

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

MathNode MathParser::named_operator(const Token& token, const MathCommand& command) {
  MathNode made = node_of(Kind::text, token.span);
  made.atom = MathClass::large;
  made.limits = command.limits;
  made.text = command.text;
  made.sources.assign(made.text.size(), token.span);
  return made;
}

MathNode MathParser::operator_name(const Token& token) {
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

MathNode MathParser::alphabet(const Token& token, Alphabet wanted) {
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

std::optional<MathNode> MathParser::as_word(const MathNode& letters, Alphabet wanted) {
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

void MathParser::finish(MathNode& node) {
  for (const MathNode& child : node.children)
    if (!child.absent()) node.span = joined(node.span, child.span);
}

MathNode MathParser::fraction(const Token& token, const MathCommand& command) {
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

void MathParser::infix(const MathCommand& command, std::vector<MathNode>& into) {
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

MathNode MathParser::radical(const Token& token) {
  MathNode made = node_of(Kind::radical, token.span);
  const std::size_t waiting = open_.size();
  MathNode degree = optional_argument();
  if (tokens_.stopped() || open_.size() > waiting) return {};
  made.children.push_back(argument(token, "\\sqrt{…}"));
  made.children.push_back(std::move(degree));
  finish(made);
  return made;
}

MathNode MathParser::delimiter_node(const Token& token, char32_t character) const {
  MathNode made = node_of(Kind::delimiter, token.span);
  made.character = character;
  return made;
}

std::optional<char32_t> MathParser::next_delimiter() {
  const Token& token = tokens_.peek();
  if (token.is(U'.')) return 0;
  char32_t c = token.kind == Token::Kind::character ? token.character : 0;
  const MathCommand* command = command_of(token);
  if (command != nullptr && command->action == Action::symbol) c = command->character;
  const char32_t found = c == 0 ? 0 : delimiter_of(c);
  if (found == 0) return std::nullopt;
  return found;
}

void MathParser::take_delimiter() {
  if (next_delimiter()) tokens_.next();
}

void MathParser::skip_delimiter() {
  tokens_.next();
  take_delimiter();
}

MathNode MathParser::delimiter(const Token& command, std::string_view usage) {
  const auto found = next_delimiter();
  if (!found) {
    tokens_.error(command, written(command) + " needs a delimiter", std::string(usage));
    return delimiter_node(command, 0);
  }
  return delimiter_node(tokens_.next(), *found);
}

MathNode MathParser::fenced(const Token& token) {
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

MathNode MathParser::big(const Token& token, const MathCommand& command) {
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

MathNode MathParser::stacked(const Token& token, const MathCommand& command) {
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

MathNode MathParser::arrow(const Token& token, const MathCommand& command) {
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

MathNode MathParser::negate(const Token& token) {
  MathNode base = argument(token, "\\not=");
  const MathNode& only = without_groups(base);
  const char32_t struck = only.kind == Kind::symbol ? negated(only.character) : 0;
  MathNode made = node_of(struck != 0 ? Kind::symbol : Kind::cancel, joined(token.span, base.span));
  made.atom = only.atom;
  made.character = struck != 0 ? struck : U'n';
  if (struck == 0) made.children.push_back(std::move(base));
  return made;
}

MathNode MathParser::hspace(const Token& token) {
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

std::optional<Color> MathParser::color_argument(const Token& token) {
  const auto name = plain_argument(token, written(token) + "{blue}{…}");
  if (!name) return std::nullopt;
  if (const auto named = named_color(*name)) return named;
  if (name->size() == 7 && name->front() == '#' &&
      name->find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos)
    return color_from_hex(static_cast<unsigned>(std::strtoul(name->c_str() + 1, nullptr, 16)));
  const std::string near = closest_name(*name, color_names());
  tokens_.error(token, "unknown color " + *name,
                near.empty() ? "write #RRGGBB, or blue, green, red …" : "did you mean " + near + "?");
  return Color{};
}

MathNode MathParser::text_color(const Token& token) {
  MathNode made = node_of(Kind::color, token.span);
  const auto color = color_argument(token);
  if (!color) return {};
  made.color = *color;
  made.children.push_back(argument(token, "\\textcolor{blue}{…}"));
  finish(made);
  return made;
}

void MathParser::color_of_rest(std::vector<MathNode>& into) {
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

std::optional<std::vector<MathParser::Option>> MathParser::options(const Token& command,
                                                                   const std::string& usage) {
  std::vector<Option> all;
  if (!tokens_.peek().is(U'[')) return all;
  const Token opening = tokens_.next();
  if (tokens_.peek().is(U']')) {
    tokens_.next();
    return all;
  }
  Option option;
  bool in_value = false;
  int depth = 0;
  const auto end_option = [&] {
    option.name = trimmed(std::move(option.name));
    option.value = trimmed(std::move(option.value));
    if (!in_value) option.value_at = option.at;
    all.push_back(std::move(option));
    option = {};
    in_value = false;
  };
  for (Token t = tokens_.peek_raw(); depth > 0 || !t.is(U']'); t = tokens_.peek_raw()) {
    const bool is_text = t.kind == Token::Kind::character || t.kind == Token::Kind::space;
    if (t.kind == Token::Kind::open || (t.kind == Token::Kind::close && depth > 0)) {
      depth += t.kind == Token::Kind::open ? 1 : -1;
    } else if (!is_text) {
      tokens_.error(opening, "the options of " + written(command) + " are text that ends with ]", usage);
      return std::nullopt;
    } else if (depth == 0 && t.is(U',')) {
      end_option();
    } else if (depth == 0 && t.is(U'=') && !in_value) {
      in_value = true;
    } else if (t.kind == Token::Kind::character || in_value || !option.name.empty()) {
      std::string& into = in_value ? option.value : option.name;
      if (into.empty()) (in_value ? option.value_at : option.at) = t;
      if (t.kind == Token::Kind::character || !into.empty()) append_utf8(into, t.character);
    }
    static_cast<void>(tokens_.next_raw());
    if (option.at.span.end == 0) option.at = t;
    if (in_value && option.value_at.span.end == 0) option.value_at = t;
  }
  static_cast<void>(tokens_.next_raw());
  end_option();
  return all;
}

void MathParser::read_options(const std::vector<Option>& options, bool has_digits, LiveNumber& number) {
  static const std::vector<std::string_view> kNames{"digits", "unit"};
  std::vector<std::string_view> seen;
  for (const Option& option : options) {
    const bool is_digits = option.name == "digits" && has_digits, is_unit = option.name == "unit";
    if (option.name == "digits" && !has_digits) {
      tokens_.error(option.at, "a number that is typed has the digits that it has", "leave out \"digits\"");
    } else if (!is_digits && !is_unit) {
      const std::string near = closest_name(option.name, kNames);
      tokens_.error(
          option.at, "unknown option \"" + option.name + "\"",
          near.empty() ? "the options are digits=3 and unit={rad/s}" : "did you mean " + near + "?");
    } else if (std::find(seen.begin(), seen.end(), option.name) != seen.end()) {
      tokens_.error(option.at, "the option " + option.name + " is there twice", "leave one out");
    } else if (is_digits) {
      const bool is_count = option.value.size() <= 2 && !option.value.empty() &&
                            option.value.find_first_not_of("0123456789") == std::string::npos;
      number.digits = is_count ? std::stoi(option.value) : 0;
      if (number.digits < 1 || number.digits > kMaxLiveDigits)
        tokens_.error(option.value_at, "digits is a whole number from 1 to " + std::to_string(kMaxLiveDigits),
                      "\\live[digits=3]{…}");
    } else if (option.value.empty()) {
      tokens_.error(option.value_at, "this unit is empty", "unit={rad/s}, or leave it out");
    } else {
      number.unit = option.value;
      number.unit_offset = option.value_at.span.begin;
    }
    seen.push_back(option.name);
  }
}

namespace {

/// {,}: the decimal comma of a line that is to be set (with_decimals).
bool is_comma_in_braces(const MathNode& node) {
  return node.kind == MathNode::Kind::row && node.children.size() == 1 && node.children[0].character == U',';
}

/// "-0.75", "2.25e4" of what is typed as −0.75, or 2.25\cdot10^{4}; thin spaces may part its digits.
std::optional<std::string> typed_number(const MathNode& node) {
  const MathNode& inner = without_groups(node);
  const std::vector<MathNode> one{inner};
  std::string text;
  bool has_point = false, has_digits = false, ended = false;
  const std::vector<MathNode>& atoms = inner.kind == MathNode::Kind::row ? inner.children : one;
  for (std::size_t i = 0; i < atoms.size(); ++i) {
    const MathNode& atom = atoms[i];
    const char32_t c = atom.kind == MathNode::Kind::symbol ? atom.character : 0;
    if (atom.kind == MathNode::Kind::space) continue;
    if (ended) return std::nullopt;
    if (text.empty() && (c == U'−' || c == U'+')) {
      text += c == U'−' ? '-' : '+';
    } else if (U'0' <= c && c <= U'9') {
      text += static_cast<char>(c);
      has_digits = true;
    } else if ((c == U'.' || is_comma_in_braces(atom)) && !has_point) {
      text += '.';
      has_point = true;
    } else if ((c == U'⋅' || c == U'×') && has_digits && i + 3 == atoms.size() &&
               atoms[i + 1].character == U'1' && atoms[i + 2].kind == MathNode::Kind::scripts &&
               atoms[i + 2].children[0].character == U'0' && atoms[i + 2].children[1].absent()) {
      const auto power = typed_number(atoms[i + 2].children[2]);
      if (!power || power->size() > 4 || power->find_first_of(".e") != std::string::npos) return std::nullopt;
      text += 'e' + *power;
      i += 2;
      ended = true;
    } else {
      return std::nullopt;
    }
  }
  constexpr std::size_t kLongest = 40;
  if (!has_digits || text.size() > kLongest) return std::nullopt;
  return text;
}

/// A unit as it stands behind a number: upright, with its powers raised.
std::string shown_unit(std::string unit) {
  for (const auto& [written, raised] : {std::pair("^2", "²"), std::pair("^3", "³"), std::pair("^4", "⁴")})
    for (std::size_t at = unit.find(written); at != std::string::npos; at = unit.find(written, at))
      unit.replace(at, 2, raised);
  return unit == "1" ? std::string() : unit == "deg" ? "°" : unit;
}

}  // namespace

std::string unit_tex(std::string unit) {
  const std::string shown = shown_unit(std::move(unit));
  return shown.empty() ? shown : (shown == "°" ? "\\text{" : "\\,\\text{") + shown + '}';
}

void MathParser::computed_number(const Token& token, const MathCommand& command,
                                 std::vector<MathNode>& into) {
  const bool is_typed = command.action == Action::value;
  const std::string usage = is_typed ? "\\value{0.75}{…}" : "\\live{…}";
  LiveNumber number;
  const auto given = options(token, usage);
  if (!given) return;
  read_options(*given, !is_typed, number);
  MathNode made = node_of(Kind::term, token.span);
  made.text = live_name(live_.size());
  if (is_typed) {
    const Token at = tokens_.peek();
    MathNode typed = argument(token, usage);
    if (tokens_.stopped()) return;
    auto read = typed_number(typed);
    if (!read)
      tokens_.error(at, "\\value shows a number as it is typed, such as 0.75, −12 or 2.25\\cdot10^{4}",
                    usage);
    number.typed = std::move(read).value_or("0");
    number.typed_offset = at.span.begin;
    made.children.push_back(std::move(typed));
  } else {
    MathNode room = node_of(Kind::text, token.span);
    room.text = kLiveRoom;
    room.sources.assign(5, token.span);  // one for each of its characters
    made.children.push_back(std::move(room));
  }
  auto expression = plain_argument(token, usage, &number.offset);
  if (!expression) return;
  number.expression = std::move(*expression);
  number.whole = {token.span.begin, std::max(token.span.end, last_end_)};
  made.span = number.whole;
  const std::string unit = shown_unit(number.unit);
  live_.push_back(std::move(number));
  into.push_back(std::move(made));
  if (unit.empty()) return;
  constexpr double kThinSpace = 1.0 / 6.0;
  if (unit != "°") into.push_back(space(token, kThinSpace));
  MathNode behind = node_of(Kind::text, token.span);
  behind.text = unit;
  behind.sources.assign(static_cast<std::size_t>(count_characters(unit)), token.span);
  into.push_back(std::move(behind));
}

MathNode MathParser::reference(const Token& token) {
  std::size_t offset = token.span.begin;
  auto id = plain_argument(token, "\\eqref{id}", &offset);
  if (!id) return {};
  MathNode number = node_of(Kind::text, token.span);
  number.text = "(?)";
  number.sources.assign(number.text.size(), token.span);
  MathNode made = node_of(Kind::term, token.span);
  made.text = std::string(kReferenceMark) + *id;
  made.children.push_back(std::move(number));
  references_.push_back({std::move(*id), offset});
  return made;
}

MathNode MathParser::term(const Token& token) {
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

MathNode MathParser::proved_part(const Token& token) {
  MathNode made = node_of(Kind::term, token.span);
  made.text = kProvedPart;
  made.children.push_back(argument(token, "\\proved{…}"));
  finish(made);
  made.atom = without_groups(made.children.front()).atom;
  return made;
}

void MathParser::tag() {
  const Token token = tokens_.next();
  std::size_t offset = token.span.begin;
  if (tokens_.peek().is(U'*')) tokens_.next();
  const auto name = plain_argument(token, "\\tag{…}", &offset);
  if (!name) return;
  tag_ += (tag_.empty() ? "" : ", ") + *name;
  tag_offsets_.push_back(offset);
}

MathNode MathParser::wrapped(const Token& token, const MathCommand& command) {
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

}  // namespace polhode
