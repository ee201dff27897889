// SPDX-License-Identifier: MIT
#include "render/typeset/math/lexer.h"

#include "base/ascii.h"
#include "render/typeset/characters.h"
#include "render/typeset/math/commands.h"

#include <algorithm>

namespace polhode {
namespace {

/// Tokens that all macros of a formula together may stand for.
constexpr std::size_t kMostMadeTokens = 4 * kMaxMathBytes;

SourceSpan span_of(std::size_t begin, std::size_t end) {
  return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
}

/// Characters one after the other; says what is wrong with a character, once for a run of them.
class Scan {
 public:
  Scan(std::string_view tex, bool is_macro, MathErrors& errors)
      : tex_(tex), is_macro_(is_macro), errors_(errors) {}

  std::vector<MathToken> run() {
    while (i_ < tex_.size() && !errors_.full()) step();
    return std::move(tokens_);
  }

 private:
  using Kind = MathToken::Kind;

  void step() {
    const std::size_t begin = i_;
    const char32_t c = next_character(tex_, i_);
    const std::string_view wrong = complaint(c);
    if (!wrong.empty()) {
      if (wrong != last_wrong_ || wrong_end_ != begin) report(begin, c, wrong);
      last_wrong_ = wrong;
      wrong_end_ = i_;
    } else if (c == U'\\') {
      command(begin);
    } else if (c == U'{') {
      put(Kind::open, begin, c);
    } else if (c == U'}') {
      put(Kind::close, begin, c);
    } else if (c == U'%') {
      i_ = std::min(tex_.find('\n', i_), tex_.size());
    } else if (c == U'#') {
      parameter(begin);
    } else if (is_space(c)) {
      while (i_ < tex_.size() && is_space(static_cast<unsigned char>(tex_[i_]))) ++i_;
      put(Kind::space, begin, U' ');
    } else {
      put(Kind::character, begin, c);
    }
  }

  static std::string_view complaint(char32_t c) {
    if (c == kMalformed) return "malformed UTF-8";
    if (is_right_to_left(c)) return "characters from right to left cannot be set";
    if (is_invisible(c)) return "invisible character";
    return {};
  }

  void report(std::size_t at, char32_t c, std::string_view wrong) {
    std::string message(wrong);
    if (c != kMalformed) message += ": " + code_point_name(c);
    if (!is_macro_) errors_.add(at, std::move(message));
  }

  void command(std::size_t begin) {
    if (i_ == tex_.size()) {
      if (!is_macro_) errors_.add(begin, "a lone \\ at the end");
      return;
    }
    const std::size_t name = i_;
    if (is_letter(tex_[i_])) {
      while (i_ < tex_.size() && is_letter(tex_[i_])) ++i_;
    } else {
      std::size_t after = i_;
      if (next_character(tex_, after) == kMalformed) return;  // said by the next step
      i_ = after;
    }
    put(Kind::command, begin, 0);
    std::string_view& text = tokens_.back().name;
    text = tex_.substr(name, i_ - name);
    if (text.size() == 1 && is_space(static_cast<unsigned char>(text.front()))) text = " ";
  }

  void parameter(std::size_t begin) {
    const bool numbered = is_macro_ && i_ < tex_.size() && '1' <= tex_[i_] && tex_[i_] <= '9';
    if (numbered) {
      put(Kind::parameter, begin, static_cast<char32_t>(tex_[i_] - '0'));
      ++i_;
    } else {
      put(Kind::character, begin, U'#');  // of a colour
    }
  }

  void put(Kind kind, std::size_t begin, char32_t c) {
    MathToken token;
    token.kind = kind;
    token.character = c;
    token.span = span_of(begin, i_);
    tokens_.push_back(token);
  }

  std::string_view tex_;
  bool is_macro_;
  MathErrors& errors_;
  std::size_t i_ = 0;
  std::string_view last_wrong_;
  std::size_t wrong_end_ = 0;
  std::vector<MathToken> tokens_;
};

}  // namespace

void MathErrors::add(std::size_t offset, std::string message, std::string hint) {
  add({offset, std::move(message), std::move(hint)});
}

void MathErrors::add(TypeError error) {
  if (!full()) errors_.push_back(std::move(error));
}

std::vector<TypeError> MathErrors::take() {
  std::stable_sort(errors_.begin(), errors_.end(),
                   [](const TypeError& a, const TypeError& b) { return a.offset < b.offset; });
  return std::move(errors_);
}

MathTokens::MathTokens(std::string_view tex, const MathMacros& macros, MathErrors& errors)
    : tex_(tex), macros_(macros), errors_(errors) {
  ahead_ = read(tex, false);
  std::reverse(ahead_.begin(), ahead_.end());
  end_.span = span_of(tex.size(), tex.size());
}

MathTokens::List MathTokens::read(std::string_view tex, bool is_macro) {
  return Scan(tex, is_macro, errors_).run();
}

MathToken MathTokens::peek_raw() {
  expand();
  return ahead_.empty() ? end_ : ahead_.back();
}

MathToken MathTokens::next_raw() {
  const MathToken token = peek_raw();
  if (!ahead_.empty()) ahead_.pop_back();
  return token;
}

MathToken MathTokens::peek() {
  while (peek_raw().kind == MathToken::Kind::space) ahead_.pop_back();
  return peek_raw();
}

MathToken MathTokens::next() {
  peek();
  return next_raw();
}

void MathTokens::stop() {
  ahead_.clear();
  stopped_ = true;
}

TypeError MathTokens::error_at(const MathToken& at, std::string message, std::string hint) const {
  TypeError error{at.span.begin, std::move(message), std::move(hint)};
  if (at.origin < 0) return error;
  const Expansion& expansion = expansions_[static_cast<std::size_t>(at.origin)];
  if (!macros_.contains(expansion.name)) return error;
  error.macro = expansion.name;
  error.macro_offset = at.body;
  return error;
}

void MathTokens::error(const MathToken& at, std::string message, std::string hint) {
  TypeError error = error_at(at, std::move(message), std::move(hint));
  if (!error.macro.empty()) error.message = "in \\" + error.macro + ": " + error.message;
  errors_.add(std::move(error));
  if (errors_.full()) stop();
}

/// Until the first token is no macro.
void MathTokens::expand() {
  while (!ahead_.empty() && ahead_.back().kind == MathToken::Kind::command && !ahead_.back().is_no_macro) {
    const MathToken call = ahead_.back();
    const auto author = macros_.find(call.name);
    const MathCommand* known = math_command(call.name);
    std::string_view name, text;
    int count = 0;
    if (author != macros_.end()) {
      name = author->first;
      text = author->second.body;
      count = author->second.arguments;
    } else if (known != nullptr && known->action == MathCommand::Action::macro) {
      name = known->name;
      text = known->text;
    } else {
      ahead_.back().is_no_macro = true;
      return;
    }
    ahead_.pop_back();
    if (!may_expand(call, name)) return;
    if (!bodies_.contains(name)) bodies_.emplace(name, read(text, true));

    MathToken whole = call;
    std::vector<List> arguments(static_cast<std::size_t>(std::clamp(count, 0, 9)));
    for (List& argument : arguments)
      if (!read_argument(call, name, count, argument, whole.span.end)) return;
    const int depth = call.origin < 0 ? 1 : expansions_[static_cast<std::size_t>(call.origin)].depth + 1;
    expansions_.push_back({name, call.origin, depth});
    put_back(bodies_[name], arguments, whole, static_cast<int>(expansions_.size()) - 1);
  }
}

bool MathTokens::may_expand(const MathToken& call, std::string_view name) {
  for (int i = call.origin; i >= 0; i = expansions_[static_cast<std::size_t>(i)].parent) {
    if (expansions_[static_cast<std::size_t>(i)].name != name) continue;
    errors_.add(error_at(call, "macro \\" + std::string(name) + " calls itself"));
    stop();
    return false;
  }
  const bool deep =
      call.origin >= 0 && expansions_[static_cast<std::size_t>(call.origin)].depth >= kMaxMathNesting;
  if (!deep) return true;
  errors_.add(call.span.begin, "macros are nested deeper than " + std::to_string(kMaxMathNesting) +
                                   ", down to \\" + std::string(name));
  stop();
  return false;
}

bool MathTokens::read_argument(const MathToken& call, std::string_view name, int count, List& into,
                               std::uint32_t& end) {
  using Kind = MathToken::Kind;
  while (!ahead_.empty() && ahead_.back().kind == Kind::space) ahead_.pop_back();
  int depth = 0;
  do {
    if (ahead_.empty() || (depth == 0 && ahead_.back().kind == Kind::close)) {
      error(call, "\\" + std::string(name) + " needs " + std::to_string(count) +
                      (count == 1 ? " argument" : " arguments"));
      return false;
    }
    const MathToken token = ahead_.back();
    ahead_.pop_back();
    depth += token.kind == Kind::open ? 1 : token.kind == Kind::close ? -1 : 0;
    into.push_back(token);
  } while (depth > 0);
  if (call.origin < 0) end = std::max(end, into.back().span.end);
  if (into.front().kind == Kind::open) {
    into.erase(into.begin());
    into.pop_back();
  }
  return true;
}

void MathTokens::put_back(const List& body, const std::vector<List>& arguments, const MathToken& call,
                          int origin) {
  List made;
  for (const MathToken& token : body) {
    if (token.kind == MathToken::Kind::parameter) {
      const auto number = static_cast<std::size_t>(token.character);
      if (number > arguments.size()) continue;
      const List& argument = arguments[number - 1];
      made.insert(made.end(), argument.begin(), argument.end());
    } else {
      made.push_back(token);
      made.back().body = token.span.begin;
      made.back().span = call.span;
      made.back().origin = origin;
    }
    if (made_ + made.size() > kMostMadeTokens) {
      errors_.add(call.span.begin, "macros stand for more than " + std::to_string(kMostMadeTokens) +
                                       " signs, the last is \\" +
                                       std::string(expansions_[static_cast<std::size_t>(origin)].name));
      return stop();
    }
  }
  made_ += made.size() + 1;
  ahead_.insert(ahead_.end(), made.rbegin(), made.rend());
}

}  // namespace polhode
