// SPDX-License-Identifier: MIT
#include "lessons/claims/expressions/expression.h"

#include "base/numbers.h"
#include "base/spelling.h"
#include "lessons/claims/expressions/expression_builder.h"
#include "lessons/claims/expressions/lengths.h"
#include "lessons/claims/expressions/vocabulary.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>

namespace polhode {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

// Recursive descent: sum → product → signed → power → operand. Brackets alone lead back to sum, so that
// kMaxExpressionNesting bounds the depth.
class ExpressionReader {
 public:
  ExpressionReader(std::string_view text, const Vocabulary* vocabulary)
      : text_(text), vocabulary_(vocabulary) {}

  std::vector<ExpressionNode> read() {
    skip_spaces();
    sum();
    if (i_ < text_.size()) fail_after_operand();
    return builder_.take();
  }

 private:
  void skip_spaces() { i_ = std::min(text_.find_first_not_of(" \t\r", i_), text_.size()); }
  char next() const { return i_ < text_.size() ? text_[i_] : '\0'; }
  void pass() {
    ++i_;
    skip_spaces();
  }
  bool take(char c) {
    if (next() != c) return false;
    pass();
    return true;
  }
  [[noreturn]] void fail(std::size_t at, const std::string& message, std::string hint = {}) const {
    throw ExpressionFault(at, message, std::move(hint));
  }

  int sum() {
    int left = product();
    while (next() == '+' || next() == '-') {
      const std::size_t at = i_;
      const Operation operation = next() == '+' ? Operation::add : Operation::subtract;
      pass();
      left = builder_.add(operation, left, product(), at);
    }
    return left;
  }

  int product() {
    int left = signed_power();
    while (next() == '*' || next() == '/') {
      const std::size_t at = i_;
      const bool times = next() == '*';
      pass();
      const int right = signed_power();
      left = times ? builder_.multiply(left, right, at) : builder_.divide(left, right, at);
    }
    return left;
  }

  int signed_power() {
    const std::size_t at = i_;
    bool negative = false;
    for (; next() == '+' || next() == '-'; pass()) negative = negative != (next() == '-');
    const int operand = power();
    return negative ? builder_.negate(operand, at) : operand;
  }

  int power() {
    const int base = operand();
    if (next() != '^') return base;
    const std::size_t at = i_;
    pass();
    const int exponent = exponent_number();
    const int result = builder_.power(base, exponent, at, end_);
    if (next() == '^') fail(i_, "a power of a power needs brackets");
    return result;
  }

  // A whole number with a sign, perhaps in brackets: no expression, for exponents do not vary.
  int exponent_number() {
    const bool bracket = take('(');
    const std::size_t at = i_;
    const bool negative = take('-');
    std::size_t end = i_;
    while (end < text_.size() && is_digit(text_[end])) ++end;
    const bool whole = end > i_ && (end == text_.size() || (text_[end] != '.' && !is_letter(text_[end])));
    int value = 0;
    const auto read = std::from_chars(text_.data() + i_, text_.data() + end, value);
    if (i_ == text_.size()) fail(i_, "an expression is missing here");
    if (!whole || read.ec != std::errc() || value > kMaxExponent)
      fail(at, "an exponent is a whole number, at most " + std::to_string(kMaxExponent));
    end_ = end;
    i_ = end;
    skip_spaces();
    if (bracket && next() != ')') fail(i_, "an exponent is one whole number: a ) is missing here");
    if (bracket) end_ = i_ + 1, pass();
    return negative ? -value : value;
  }

  int operand() {
    const char c = next();
    if (is_digit(c) || c == '.') return number();
    if (is_letter(c)) return name();
    if (c == '(') return brackets();
    if (i_ == text_.size() || std::string_view("),*/^").find(c) != std::string_view::npos) fail_missing();
    fail_unknown_character();
  }

  [[noreturn]] void fail_missing() const {
    if (next() == ')' && open_.empty()) fail(i_, "this ) closes nothing");
    fail(i_, "an expression is missing here");
  }

  // What stands behind an operand and cannot: in the order in which a reader would trip over it.
  [[noreturn]] void fail_after_operand() const {
    const char c = next();
    if (is_digit(c) || is_letter(c) || c == '.' || c == '(')
      fail(i_, "an operator is missing before this", "write * between factors");
    if (c == ')') fail(i_, "this ) closes nothing");
    if (c == ',') fail(i_, "a comma stands between the arguments of a function only");
    fail_unknown_character();
  }

  void open(std::size_t at) {
    if (static_cast<int>(open_.size()) == kMaxExpressionNesting)
      fail(at, "brackets are nested deeper than " + std::to_string(kMaxExpressionNesting));
    open_.push_back(at);
    pass();
  }
  void close() {
    if (next() != ')') {
      if (i_ == text_.size()) fail(open_.back(), "this ( is never closed");
      fail_after_operand();
    }
    open_.pop_back();
    end_ = i_ + 1;
    pass();
  }

  int brackets() {
    const std::size_t begin = i_;
    open(i_);
    const int inside = sum();
    close();
    builder_.widen(inside, begin, end_);
    return inside;
  }

  int number() {
    const std::size_t begin = i_;
    DecimalNumber number;
    int digits = 0;
    const auto read_digits = [&](int power_each) {
      for (; is_digit(next()); ++i_) {
        if (number.mantissa != 0 || next() != '0') ++digits;
        if (digits > kMaxDigits)
          fail(begin, "a number has at most " + std::to_string(kMaxDigits) + " digits");
        number.mantissa = 10 * number.mantissa + (next() - '0');
        number.power_of_ten += power_each;
      }
    };
    read_digits(0);
    if (next() == '.') ++i_, read_digits(-1);
    if (i_ == begin + 1 && text_[begin] == '.') fail(begin, "a number needs digits");
    if (next() == 'e' || next() == 'E') number.power_of_ten += exponent();
    if (std::abs(number.power_of_ten) > kMaxPowerOfTen)
      fail(begin, "a number carries at most 18 powers of ten");
    end_ = i_;
    number.value = parse_number(text_.substr(begin, i_ - begin)).value();
    const int node = builder_.number(number, begin, i_);
    skip_spaces();
    return node;
  }

  // Of a number such as 1e-9; an e that no digit follows is left for the name after it.
  int exponent() {
    std::size_t at = i_ + 1;
    const bool negative = at < text_.size() && text_[at] == '-';
    if (at < text_.size() && (text_[at] == '+' || text_[at] == '-')) ++at;
    if (at >= text_.size() || !is_digit(text_[at])) return 0;
    int power = 0;
    for (; at < text_.size() && is_digit(text_[at]); ++at)
      power = std::min(10 * power + (text_[at] - '0'), 10 * kMaxPowerOfTen);
    i_ = at;
    return negative ? -power : power;
  }

  int name() {
    const std::size_t begin = i_;
    while (is_letter(next()) || is_digit(next())) ++i_;
    const std::string_view word = text_.substr(begin, i_ - begin);
    end_ = i_;
    skip_spaces();
    if (next() == '(') return function_call(word, begin);
    if (const QuantityFacts* facts = find_quantity(word)) return builder_.quantity(*facts, begin, end_);
    if (const Vocabulary::Word* said = own_word(word)) return builder_.insert(said->means, begin, end_);
    if (word == kPiName) return builder_.pi(begin, end_);
    if (word == kTensorName) fail(begin, "J is a tensor", "write apply(J, a), trace(J) or a component: Jxy");
    if (find_function(word) != nullptr)
      fail(begin, in_quotes(word) + " is a function", "write " + std::string(word) + "(…)");
    if (vocabulary_ != nullptr && vocabulary_->is_announced(word))
      fail(begin, in_quotes(word) + " is defined further down", "a definition uses those above it");
    fail(begin, "unknown symbol " + in_quotes(word), suggestion(word, symbols()));
  }

  const Vocabulary::Word* own_word(std::string_view word) const {
    return vocabulary_ == nullptr ? nullptr : vocabulary_->find(word);
  }
  std::vector<std::string> symbols() const {
    std::vector<std::string> all = expression_symbols();
    if (vocabulary_ != nullptr)
      for (std::string& name : vocabulary_->names()) all.push_back(std::move(name));
    return all;
  }

  int function_call(std::string_view word, std::size_t begin) {
    const FunctionFacts* function = find_function(word);
    if (function == nullptr) {
      const auto known = symbols();
      const bool symbol = std::find(known.begin(), known.end(), word) != known.end();
      fail(begin, symbol ? in_quotes(word) + " is no function" : "unknown function " + in_quotes(word),
           symbol ? "write * between factors" : suggestion(word, expression_functions()));
    }
    open(i_);
    open_.back() = begin;
    const bool of_tensor = function->operation == Operation::apply || function->operation == Operation::trace;
    if (of_tensor) tensor_name();
    std::vector<int> arguments;
    int count = of_tensor ? 1 : 0;
    int index = 0;
    while (count == 0 || next() == ',') {
      if (count > 0) pass();
      if (function->operation == Operation::comp && count == 1)
        index = axis();
      else
        arguments.push_back(sum());
      ++count;
    }
    if (next() == ')' && count != function->arguments)
      fail(begin, in_quotes(word) + " takes " + std::to_string(function->arguments) +
                      (function->arguments == 1 ? " argument" : " arguments") + ", found " +
                      std::to_string(count));
    close();
    switch (function->operation) {
      case Operation::comp:
        return builder_.component(arguments.front(), index, begin, end_);
      case Operation::apply:
        return builder_.apply_tensor(arguments.front(), begin, end_);
      case Operation::trace:
        return builder_.trace_of_tensor(begin, end_);
      default:
        return builder_.call(*function, arguments, begin, end_);
    }
  }

  void tensor_name() {
    const bool alone = text_.substr(i_, 1) == kTensorName &&
                       (i_ + 1 == text_.size() || !(is_letter(text_[i_ + 1]) || is_digit(text_[i_ + 1])));
    if (!alone) fail(i_, "the first argument here is the tensor J");
    pass();
  }

  int axis() {
    const char c = next();
    const bool single = i_ + 1 >= text_.size() || !(is_digit(text_[i_ + 1]) || text_[i_ + 1] == '.');
    if (c < '1' || c > '3' || !single) fail(i_, "a component is 1, 2 or 3");
    pass();
    return c - '1';
  }

  [[noreturn]] void fail_unknown_character() const {
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
  const Vocabulary* vocabulary_;
  std::size_t i_ = 0;
  std::size_t end_ = 0;  // of what was read last, without the spaces behind it
  std::vector<std::size_t> open_;
  ExpressionBuilder builder_;
};

template <class Facts>
const typename Facts::value_type* find_named(const Facts& facts, std::string_view name) {
  const auto found =
      std::find_if(facts.begin(), facts.end(), [name](const auto& f) { return f.name == name; });
  return found == facts.end() ? nullptr : &*found;
}

}  // namespace

const QuantityFacts& facts_of(Quantity quantity) {
  return *std::find_if(kQuantities.begin(), kQuantities.end(),
                       [quantity](const QuantityFacts& facts) { return facts.quantity == quantity; });
}
const QuantityFacts* find_quantity(std::string_view name) { return find_named(kQuantities, name); }
const FunctionFacts* find_function(std::string_view name) { return find_named(kFunctions, name); }

std::string_view name_of(ExpressionType type) {
  if (type == ExpressionType::zero) return "0";
  return type == ExpressionType::scalar ? "a scalar" : "a vector";
}

bool fit(ExpressionType a, ExpressionType b) {
  return a == b || a == ExpressionType::zero || b == ExpressionType::zero;
}

bool Expression::uses(Operation operation) const {
  return std::any_of(nodes.begin(), nodes.end(),
                     [operation](const ExpressionNode& node) { return node.operation == operation; });
}

bool Expression::uses(Quantity quantity) const {
  return std::any_of(nodes.begin(), nodes.end(), [quantity](const ExpressionNode& node) {
    return node.operation == Operation::quantity && node.quantity == quantity;
  });
}

namespace {

const ExpressionNode& node_of(const Expression& expression, int index) {
  return expression.nodes[static_cast<std::size_t>(index)];
}

/// A moment, the mass or a number above 0, and what is made of them without a minus.
bool is_positive(const Expression& expression, int index) {
  const ExpressionNode& n = node_of(expression, index);
  switch (n.operation) {
    case Operation::number:
      return n.number.value > 0;
    case Operation::quantity:
      return n.quantity == Quantity::I1 || n.quantity == Quantity::I2 || n.quantity == Quantity::I3 ||
             n.quantity == Quantity::m;
    case Operation::add:
    case Operation::multiply:
    case Operation::divide:
      return is_positive(expression, n.a) && is_positive(expression, n.b);
    case Operation::power:
      return is_positive(expression, n.a);
    default:
      return false;
  }
}

bool is_length(const Expression& expression, int index) {
  const ExpressionNode& n = node_of(expression, index);
  if (n.operation == Operation::norm) return true;
  if (n.operation == Operation::divide) return is_length(expression, n.a) && is_positive(expression, n.b);
  return n.operation == Operation::multiply &&
         ((is_length(expression, n.a) && is_positive(expression, n.b)) ||
          (is_positive(expression, n.a) && is_length(expression, n.b)));
}

/// A node with what it is made of, by itself.
int copy_node(const Expression& expression, int index, std::vector<ExpressionNode>& nodes) {
  ExpressionNode n = node_of(expression, index);
  if (n.a >= 0) n.a = copy_node(expression, n.a, nodes);
  if (n.b >= 0) n.b = copy_node(expression, n.b, nodes);
  nodes.push_back(n);
  return static_cast<int>(nodes.size()) - 1;
}

/// The square of a length, with its factors squared one by one.
int add_square(ExpressionBuilder& builder, const Expression& expression, int index) {
  const ExpressionNode& n = node_of(expression, index);
  if (n.operation != Operation::norm && is_length(expression, index)) {
    const int a = add_square(builder, expression, n.a), b = add_square(builder, expression, n.b);
    return n.operation == Operation::multiply ? builder.multiply(a, b, n.begin)
                                              : builder.divide(a, b, n.begin);
  }
  Expression part{expression.text, {}, expression.constants};
  copy_node(expression, index, part.nodes);
  if (n.operation == Operation::norm) {
    part.nodes.back().operation = Operation::norm2;
    return builder.insert(part, n.begin, n.end);
  }
  return builder.power(builder.insert(part, n.begin, n.end), 2, n.begin, n.end);
}

/// Whether nodes have no roots and no angles: cosines of acos have none.
bool are_algebraic(const std::vector<ExpressionNode>& nodes) {
  int angles = 0, cosines_of_angles = 0;
  for (const ExpressionNode& node : nodes) {
    switch (node.operation) {
      case Operation::pi:
      case Operation::sqrt:
      case Operation::sin:
      case Operation::atan2:
      case Operation::exp:
      case Operation::log:
        return false;
      case Operation::acos:
        ++angles;
        break;
      case Operation::cos:
        if (nodes[static_cast<std::size_t>(node.a)].operation != Operation::acos) return false;
        ++cosines_of_angles;
        break;
      default:
        break;
    }
  }
  return angles == cosines_of_angles;
}

}  // namespace

bool is_rational(const Expression& expression) {
  return are_algebraic(expression.nodes) && !expression.uses(Operation::norm);
}

bool has_angles(const Equality& equality) {
  return !are_algebraic(equality.left.nodes) || !are_algebraic(equality.right.nodes);
}

bool is_length(const Expression& side) { return is_length(side, static_cast<int>(side.nodes.size()) - 1); }

bool is_provable(const Equality& equality) {
  const auto has_more_lengths = [](const Expression& side) {
    const auto lengths = std::count_if(side.nodes.begin(), side.nodes.end(), [](const ExpressionNode& node) {
      return node.operation == Operation::norm;
    });
    return lengths > (is_length(side) ? 1 : 0);
  };
  return is_length(equality.left) == is_length(equality.right) && !has_more_lengths(equality.left) &&
         !has_more_lengths(equality.right) && !has_angles(equality);
}

Equality with_lengths_squared(Equality equality) {
  if (!is_length(equality.left) || !is_length(equality.right)) return equality;
  for (Expression* side : {&equality.left, &equality.right}) {
    if (side->nodes.back().operation == Operation::norm) {
      side->nodes.back().operation = Operation::norm2;
      continue;
    }
    ExpressionBuilder builder;
    add_square(builder, *side, static_cast<int>(side->nodes.size()) - 1);
    side->nodes = builder.take();
  }
  return equality;
}

Expression zero_expression() {
  ExpressionNode zero;
  zero.type = ExpressionType::zero;
  zero.end = 1;
  return {"0", {zero}};
}

std::optional<Expression> read_expression(std::string_view text, SourcePlace start, Report& report,
                                          const Vocabulary* vocabulary) {
  try {
    if (text.size() > kMaxExpressionBytes)
      throw ExpressionFault(0, "an expression has at most " + std::to_string(kMaxExpressionBytes) + " bytes");
    return Expression{std::string(text), ExpressionReader(text, vocabulary).read(),
                      vocabulary == nullptr ? nullptr : vocabulary->constants()};
  } catch (const ExpressionFault& fault) {
    report.error(advanced(start, text, fault.offset), fault.what(), fault.hint);
    return std::nullopt;
  }
}

const std::vector<std::string>& expression_symbols() {
  static const std::vector<std::string> kSymbols = [] {
    std::vector<std::string> names;
    for (const QuantityFacts& facts : kQuantities) names.emplace_back(facts.name);
    names.emplace_back(kTensorName);
    names.emplace_back(kPiName);
    return names;
  }();
  return kSymbols;
}

std::vector<std::string> expression_functions() {
  std::vector<std::string> names;
  for (const FunctionFacts& function : kFunctions) names.emplace_back(function.name);
  return names;
}

}  // namespace polhode
