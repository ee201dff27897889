// SPDX-License-Identifier: MIT
#include "lessons/expression.h"

#include "lessons/suggest.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace polhode {
namespace {

struct Function {
  std::string_view name;
  int arguments;
};
constexpr std::array<Function, 9> kFunctions = {{{"dot", 2},
                                                 {"cross", 2},
                                                 {"norm2", 1},
                                                 {"inertia", 1},
                                                 {"apply", 2},
                                                 {"comp", 2},
                                                 {"trace", 1},
                                                 {"star", 1},
                                                 {"ddt", 1}}};

const Function* find_function(std::string_view name) {
  const auto found = std::find_if(kFunctions.begin(), kFunctions.end(),
                                  [name](const Function& function) { return function.name == name; });
  return found == kFunctions.end() ? nullptr : &*found;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// Reads from left to right and knows only whether an operand or an operator comes next, so it needs no
// recursion.
class ExpressionScan {
 public:
  ExpressionScan(std::string_view text, SourcePlace start, Report& report)
      : text_(text), cursor_(text, start), report_(report) {}

  bool run() {
    for (skip_spaces(); ok_ && i_ < text_.size(); skip_spaces()) step();
    if (!ok_) return false;
    if (wants_operand_) return fail(text_.size(), "an expression is missing here");
    if (!open_.empty()) return fail_at(open_.back().place, "this ( is never closed");
    return true;
  }

 private:
  struct Open {
    SourcePlace place;
    const Function* function;  // nullptr: plain brackets
    int arguments;             // begun so far
  };

  void skip_spaces() { i_ = std::min(text_.find_first_not_of(" \t\r", i_), text_.size()); }

  bool fail_at(SourcePlace place, std::string message, std::string hint = {}) {
    report_.error(place, std::move(message), std::move(hint));
    return ok_ = false;
  }
  bool fail(std::size_t offset, std::string message, std::string hint = {}) {
    return fail_at(cursor_.advance_to(offset), std::move(message), std::move(hint));
  }

  void step() {
    const char c = text_[i_];
    if (is_digit(c) || c == '.')
      number();
    else if (is_letter(c))
      name();
    else if (c == '(')
      open(nullptr, i_);
    else if (c == ')')
      close();
    else if (c == ',')
      comma();
    else if (std::string_view("+-*/^").find(c) != std::string_view::npos)
      sign(c);
    else
      unknown_character();
  }

  bool begin_operand() {
    if (wants_operand_) return true;
    return fail(i_, "an operator is missing before this", "write * between factors");
  }

  void number() {
    if (!begin_operand()) return;
    const std::size_t begin = i_;
    const auto digits = [this] {
      while (i_ < text_.size() && is_digit(text_[i_])) ++i_;
    };
    digits();
    if (i_ < text_.size() && text_[i_] == '.') ++i_, digits();
    if (i_ == begin + 1 && text_[begin] == '.') {
      fail(begin, "a number needs digits");
      return;
    }
    if (i_ < text_.size() && (text_[i_] == 'e' || text_[i_] == 'E')) exponent();
    wants_operand_ = false;
  }

  // Of a number such as 1e-9; an e that no digit follows is left for the name after it.
  void exponent() {
    std::size_t next = i_ + 1;
    if (next < text_.size() && (text_[next] == '+' || text_[next] == '-')) ++next;
    if (next >= text_.size() || !is_digit(text_[next])) return;
    i_ = next;
    while (i_ < text_.size() && is_digit(text_[i_])) ++i_;
  }

  void name() {
    if (!begin_operand()) return;
    const std::size_t begin = i_;
    while (i_ < text_.size() && (is_letter(text_[i_]) || is_digit(text_[i_]))) ++i_;
    const std::string_view word = text_.substr(begin, i_ - begin);
    skip_spaces();
    if (i_ < text_.size() && text_[i_] == '(') {
      function_call(word, begin);
      return;
    }
    const auto& symbols = expression_symbols();
    if (std::find(symbols.begin(), symbols.end(), word) == symbols.end()) {
      const bool function = find_function(word) != nullptr;
      fail(begin, function ? in_quotes(word) + " is a function" : "unknown symbol " + in_quotes(word),
           function ? "write " + std::string(word) + "(…)" : suggestion(word, symbols));
      return;
    }
    wants_operand_ = false;
  }

  void function_call(std::string_view word, std::size_t begin) {
    if (const Function* function = find_function(word)) {
      open(function, begin);
      return;
    }
    const auto& symbols = expression_symbols();
    const bool symbol = std::find(symbols.begin(), symbols.end(), word) != symbols.end();
    fail(begin, symbol ? in_quotes(word) + " is no function" : "unknown function " + in_quotes(word),
         symbol ? "write * between factors" : suggestion(word, expression_functions()));
  }

  void open(const Function* function, std::size_t begin) {
    if (!begin_operand()) return;
    if (static_cast<int>(open_.size()) == kMaxExpressionNesting) {
      fail(begin, "brackets are nested deeper than " + std::to_string(kMaxExpressionNesting));
      return;
    }
    open_.push_back({cursor_.advance_to(begin), function, 1});
    ++i_;
  }

  bool end_operand() {
    if (!wants_operand_) return true;
    return fail(i_, "an expression is missing here");
  }

  void close() {
    if (open_.empty()) {
      fail(i_, "this ) closes nothing");
      return;
    }
    if (!end_operand()) return;
    const Open& group = open_.back();
    if (group.function != nullptr && group.arguments != group.function->arguments) {
      const int wanted = group.function->arguments;
      fail_at(group.place, in_quotes(group.function->name) + " takes " + std::to_string(wanted) +
                               (wanted == 1 ? " argument" : " arguments") + ", found " +
                               std::to_string(group.arguments));
      return;
    }
    open_.pop_back();
    ++i_;
  }

  void comma() {
    if (!end_operand()) return;
    if (open_.empty() || open_.back().function == nullptr) {
      fail(i_, "a comma stands between the arguments of a function only");
      return;
    }
    ++open_.back().arguments;
    wants_operand_ = true;
    ++i_;
  }

  void sign(char c) {
    const bool prefix = c == '+' || c == '-';
    if (wants_operand_ && !prefix) {
      end_operand();
      return;
    }
    wants_operand_ = true;
    ++i_;
  }

  void unknown_character() {
    std::size_t end = i_ + 1;
    while (end < text_.size() && (static_cast<unsigned char>(text_[end]) & 0xC0U) == 0x80U) ++end;
    const std::string_view character = text_.substr(i_, end - i_);
    std::string hint;
    if (character == "=") hint = "one = in each line";
    if (character == "×") hint = "write cross(a, b)";
    if (character == "·") hint = "write dot(a, b), or * between factors";
    if (character == "\\" || character == "$") hint = "claims are not TeX: write omega, L, cross(omega, L)";
    fail(i_, "unknown character " + in_quotes(character), std::move(hint));
  }

  std::string_view text_;
  PlaceCursor cursor_;
  Report& report_;
  std::size_t i_ = 0;
  bool wants_operand_ = true;
  bool ok_ = true;
  std::vector<Open> open_;
};

}  // namespace

bool check_expression(std::string_view text, SourcePlace start, Report& report) {
  return ExpressionScan(text, start, report).run();
}

const std::vector<std::string>& expression_symbols() {
  static const std::vector<std::string> symbols = {
      "T", "I1", "I2", "I3", "w1", "w2", "w3", "dw1", "dw2", "dw3", "N1",  "N2",  "N3",  "m",   "omega", "L",
      "N", "p",  "v",  "F",  "A",  "e1", "e2", "e3",  "J",   "Jxx", "Jxy", "Jxz", "Jyy", "Jyz", "Jzz"};
  return symbols;
}

std::vector<std::string> expression_functions() {
  std::vector<std::string> names;
  for (const Function& function : kFunctions) names.emplace_back(function.name);
  return names;
}

}  // namespace polhode
