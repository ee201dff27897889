// SPDX-License-Identifier: MIT
#include "lessons/derivation/canonical_form.h"

#include "lessons/notation/typed/expression_typing.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace polhode {
namespace {

using O = Operation;

/// A number times a product of what cannot be taken apart.
struct Term {
  double factor = 1;
  std::vector<std::string> parts;
  int sum = -1;  ///< the one bracket that is among them, if it is one
};

class Canonical {
 public:
  explicit Canonical(const Expression& expression) : expression_(expression) {}

  void add(int index, double sign, CanonicalForm& into) const {
    const ExpressionNode& n = at(index);
    switch (n.operation) {
      case O::add:
      case O::subtract:
        add(n.a, sign, into);
        return add(n.b, n.operation == O::add ? sign : -sign, into);
      case O::negate:
        return add(n.a, -sign, into);
      default: {
        Term term;
        gather(index, term);
        if (term.factor == 0) return;
        if (term.sum >= 0 && term.parts.empty()) return add(term.sum, sign * term.factor, into);
        if (term.sum >= 0) term.parts.push_back(text_of(term.sum));
        std::sort(term.parts.begin(), term.parts.end());
        std::string key;
        for (const std::string& part : term.parts) key += part + ' ';
        into[key] += sign * term.factor;
      }
    }
  }

 private:
  const ExpressionNode& at(int index) const { return expression_.nodes[static_cast<std::size_t>(index)]; }

  void gather(int index, Term& term) const {
    const ExpressionNode& n = at(index);
    switch (n.operation) {
      case O::number:
        term.factor *= n.number.value;
        return;
      case O::negate:
        term.factor = -term.factor;
        return gather(n.a, term);
      case O::multiply:
        gather(n.a, term);
        return gather(n.b, term);
      case O::divide:
        if (at(n.b).operation == O::number && at(n.b).number.value != 0) {
          term.factor /= at(n.b).number.value;
          return gather(n.a, term);
        }
        gather(n.a, term);
        term.parts.push_back("/" + text_of(n.b));
        return;
      case O::power:
        if (n.integer >= 1 && n.integer <= 4) {
          for (int i = 0; i < n.integer; ++i) gather(n.a, term);
          return;
        }
        [[fallthrough]];
      case O::add:
      case O::subtract:
        if (n.operation != O::power && is_number(index, term.factor)) return;
        if (term.sum < 0) {
          term.sum = index;
          return;
        }
        [[fallthrough]];
      default:
        if (n.operation == O::cross && text_of(n.a) == text_of(n.b)) term.factor = 0;  // a × a
        term.parts.push_back(text_of(index));
    }
  }

  /// Multiplies a factor by a sum that is no more than a number, "(1 + 0)"; false for another.
  bool is_number(int index, double& factor) const {
    CanonicalForm form;
    add(index, 1, form);
    std::erase_if(form, [](const auto& one) { return one.second == 0; });
    if (form.size() > 1 || (form.size() == 1 && !form.begin()->first.empty())) return false;
    factor *= form.empty() ? 0 : form.begin()->second;
    return true;
  }

  /// Of a sum the terms in the order of their texts.
  std::string text_of(int index) const {
    const ExpressionNode& n = at(index);
    const std::string name = std::to_string(static_cast<int>(n.operation));
    switch (n.operation) {
      case O::number:
      case O::add:
      case O::subtract:
      case O::negate:
      case O::multiply:
      case O::divide: {
        CanonicalForm form;
        add(index, 1, form);
        std::string text = "(";
        for (const auto& [key, factor] : form) text += std::to_string(factor) + '*' + key + ' ';
        return text + ')';
      }
      case O::quantity:
        return 'q' + std::to_string(static_cast<int>(n.quantity));
      case O::constant:
        return 'c' + std::to_string(n.integer);
      case O::dot: {
        std::string a = text_of(n.a), b = text_of(n.b);
        if (b < a) std::swap(a, b);
        return name + '[' + a + ',' + b + ']';
      }
      default:
        return name + ':' + std::to_string(n.integer) + '[' + (n.a >= 0 ? text_of(n.a) : "") + ',' +
               (n.b >= 0 ? text_of(n.b) : "") + ']';
    }
  }

  const Expression& expression_;
};

/// Terms multiplied out: products of what cannot be taken apart, "a b ", and their numbers.
class Expansion {
 public:
  explicit Expansion(const Expression& expression) : expression_(expression) {}

  /// Nothing where there are too many terms.
  std::optional<CanonicalForm> of(int index) const {
    const ExpressionNode& n = expression_.nodes[static_cast<std::size_t>(index)];
    std::optional<CanonicalForm> a = n.a >= 0 ? of(n.a) : CanonicalForm(),
                                 b = n.b >= 0 ? of(n.b) : CanonicalForm();
    if (!a || !b) return std::nullopt;
    const std::string name = std::to_string(static_cast<int>(n.operation)) + ':' + std::to_string(n.integer);
    switch (n.operation) {
      case O::number:
        return n.number.value == 0 ? CanonicalForm() : CanonicalForm{{"", n.number.value}};
      case O::quantity:
        return CanonicalForm{{'q' + std::to_string(static_cast<int>(n.quantity)) + ' ', 1.0}};
      case O::constant:
        return CanonicalForm{{'c' + std::to_string(n.integer) + ' ', 1.0}};
      case O::negate:
        return times(*a, {{"", -1.0}});
      case O::add:
      case O::subtract:
        for (const auto& [key, factor] : *b) (*a)[key] += n.operation == O::add ? factor : -factor;
        return a;
      case O::multiply:
        return times(*a, *b);
      case O::divide:
        if (b->size() == 1 && b->begin()->first.empty()) return times(*a, {{"", 1 / b->begin()->second}});
        return times(*a, {{"/(" + text(*b) + ") ", 1.0}});
      case O::power: {
        if (n.integer < 1 || n.integer > 4) return CanonicalForm{{name + '(' + text(*a) + ") ", 1.0}};
        std::optional<CanonicalForm> product = CanonicalForm{{"", 1.0}};
        for (int i = 0; product && i < n.integer; ++i) product = times(*product, *a);
        return product;
      }
      case O::norm2:
        return of_two(std::to_string(static_cast<int>(O::dot)) + ":0", *a, *a, 1);
      case O::dot:
        return of_two(name, *a, *b, 1);
      case O::cross:
        return of_two(name, *a, *b, -1);
      case O::comp:
      case O::inertia:
      case O::ddt:
      case O::star: {
        CanonicalForm sum;
        for (const auto& [key, factor] : *a) sum[name + '(' + key + ") "] += factor;
        return sum;
      }
      default:
        return CanonicalForm{{name + '(' + text(*a) + ',' + text(*b) + ") ", 1.0}};
    }
  }

 private:
  static std::string text(const CanonicalForm& form) {
    std::string text;
    for (const auto& [key, factor] : form) text += std::to_string(factor) + '*' + key;
    return text;
  }

  static std::string product_of(const std::string& a, const std::string& b) {
    // Parts end with a blank that stands in no bracket.
    std::vector<std::string> parts;
    int depth = 0;
    std::string part;
    for (const char c : a + b) {
      depth += c == '(' ? 1 : c == ')' ? -1 : 0;
      part += c;
      if (c == ' ' && depth == 0) parts.push_back(std::exchange(part, ""));
    }
    std::sort(parts.begin(), parts.end());
    std::string key;
    for (const std::string& one : parts) key += one;
    return key;
  }

  static std::optional<CanonicalForm> times(const CanonicalForm& a, const CanonicalForm& b) {
    if (a.size() * b.size() > kMostTerms) return std::nullopt;
    CanonicalForm product;
    for (const auto& [x, f] : a)
      for (const auto& [y, g] : b) product[product_of(x, y)] += f * g;
    return product;
  }

  /// `turned`: what it is times when its factors change places.
  static std::optional<CanonicalForm> of_two(const std::string& name, const CanonicalForm& a,
                                             const CanonicalForm& b, double turned) {
    if (a.size() * b.size() > kMostTerms) return std::nullopt;
    CanonicalForm product;
    for (const auto& [x, f] : a)
      for (const auto& [y, g] : b)
        if (!(turned < 0 && x == y))
          product[name + '(' + std::min(x, y) + ',' + std::max(x, y) + ") "] +=
              f * g * (y < x ? turned : 1.0);
    return product;
  }

  const Expression& expression_;
};

CanonicalForm normalized(CanonicalForm form) {
  std::erase_if(form, [](const auto& term) { return std::abs(term.second) < 1e-12; });
  if (form.empty()) return form;
  // The first term's factor is made 1: so equations that differ by a number are one.
  const double first = form.begin()->second;
  for (auto& [key, factor] : form) factor = std::round(factor / first * 1e9) / 1e9;
  return form;
}

int whole(const Expression& side) { return static_cast<int>(side.nodes.size()) - 1; }

}  // namespace

CanonicalForm canonical_form(const Equality& equality) {
  CanonicalForm form;
  Canonical(equality.left).add(whole(equality.left), 1, form);
  Canonical(equality.right).add(whole(equality.right), -1, form);
  return normalized(std::move(form));
}

CanonicalForm expanded_form(const Equality& equality) {
  auto left = Expansion(equality.left).of(whole(equality.left)),
       right = Expansion(equality.right).of(whole(equality.right));
  if (!left || !right) return canonical_form(equality);
  for (const auto& [key, factor] : *right) (*left)[key] -= factor;
  return normalized(std::move(*left));
}

bool Words::contains(const Words& others) const {
  return std::includes(letters.begin(), letters.end(), others.letters.begin(), others.letters.end());
}

namespace {

class WordSearch {
 public:
  explicit WordSearch(const Expression& expression) : expression_(expression) {}

  std::string find() {
    add(static_cast<int>(expression_.nodes.size()) - 1);
    return std::move(letters_);
  }

 private:
  const ExpressionNode& at(int index) const { return expression_.nodes[static_cast<std::size_t>(index)]; }

  void note(Quantity quantity) { letters_ += static_cast<char>(1 + static_cast<int>(quantity)); }
  void note(O operation) {
    constexpr int kFirstOperation = 64;  // behind the quantities
    letters_ += static_cast<char>(kFirstOperation + static_cast<int>(operation));
  }

  void add(int index) {
    if (index < 0) return;
    const ExpressionNode& n = at(index);
    if (n.operation == O::quantity) return note(n.quantity);
    if (n.operation == O::ddt || n.operation == O::star) {
      const ExpressionNode& of = at(n.a);
      const bool is_quantity = of.operation == O::quantity;
      for (int axis = 0; axis < 3; ++axis)
        if (is_quantity && of.quantity == static_cast<Quantity>(static_cast<int>(Quantity::w1) + axis))
          return note(static_cast<Quantity>(static_cast<int>(Quantity::dw1) + axis));
      note(is_quantity && of.quantity == Quantity::omega ? O::star : n.operation);
      if (!is_quantity) letters_ += kRateOfMore;
      return add(n.a);
    }
    if (n.operation == O::dot && typing_of(expression_, n.a) == typing_of(expression_, n.b)) {
      note(O::norm2);
      return add(n.a);
    }
    for (const O kept : {O::dot, O::cross, O::norm2, O::norm, O::inertia, O::comp, O::constant})
      if (n.operation == kept) note(kept);
    add(n.a);
    add(n.b);
  }

  /// Of a product or a sum: d*(I ω)/dt is not yet I ω̇.
  static constexpr char kRateOfMore = 0x7E;

  const Expression& expression_;
  std::string letters_;
};

}  // namespace

Words words_of(const Equality& equality) {
  std::string letters = WordSearch(equality.left).find() + WordSearch(equality.right).find();
  std::sort(letters.begin(), letters.end());
  letters.erase(std::unique(letters.begin(), letters.end()), letters.end());
  return {std::move(letters)};
}

}  // namespace polhode
