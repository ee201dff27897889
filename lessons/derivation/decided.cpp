// SPDX-License-Identifier: MIT
#include "lessons/derivation/decided.h"

#include "lessons/derivation/canonical_form.h"
#include "lessons/derivation/rewriting.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace polhode {
namespace {

using O = Operation;
using Q = Quantity;

struct SignedTerm {
  int node = 0;
  bool is_plus = true;
};

/// What stands between the signs of a node, in the order in which it is written.
void add_terms(const Expression& expression, int index, bool is_plus, std::vector<SignedTerm>& terms) {
  const ExpressionNode& n = expression.nodes[static_cast<std::size_t>(index)];
  if (n.operation == O::add || n.operation == O::subtract) {
    add_terms(expression, n.a, is_plus, terms);
    add_terms(expression, n.b, is_plus == (n.operation == O::add), terms);
  } else if (n.operation == O::negate) {
    add_terms(expression, n.a, !is_plus, terms);
  } else {
    terms.push_back({index, is_plus});
  }
}

std::vector<SignedTerm> terms_of(const Expression& expression) {
  std::vector<SignedTerm> terms;
  add_terms(expression, static_cast<int>(expression.nodes.size()) - 1, true, terms);
  return terms;
}

Expression part_of(const Expression& whole, int node) {
  return {whole.text, {whole.nodes.begin(), whole.nodes.begin() + node + 1}, whole.constants};
}

/// 0, 0·ω₁, ω × ω: nobody takes it for anything else. A sum that cancels is another thing: it may be a slip.
bool is_written_as_zero(const Expression& side) {
  return side.type() == ExpressionType::zero ||
         (!side.uses(O::add) && !side.uses(O::subtract) && canonical_form({side, zero_expression()}).empty());
}

class Decision {
 public:
  Decision(const Equality& link, const Derivation& derivation, const Prover& prover)
      : link_(link), derivation_(derivation), prover_(prover) {}

  bool decide() const {
    const LawsAssumed laws = derivation_.laws;
    const Given& given = derivation_.given;
    if (!has_a_part_that_is_0(laws, given)) return true;
    const std::pair<LawsAssumed, Given> less[] = {
        {LawsAssumed::identity, {}}, {LawsAssumed::motion, {}}, {laws, {}}, {LawsAssumed::motion, given}};
    const bool is_least = laws == LawsAssumed::identity && given.empty();
    for (const auto& [other, other_given] : less) {
      const bool is_weaker = other != laws || (!given.empty() && other_given.empty());
      if ((is_weaker || is_least) && holds(link_, other, other_given) &&
          !both_sides_are_0(link_, other, other_given))
        return true;
    }
    return holds_under_another_law() || is_worked_line();
  }

 private:
  bool holds(const Equality& equality, LawsAssumed laws, const Given& given) const {
    return prover_.settle(equality, laws, given) == Verdict::holds;
  }
  bool is_0(const Expression& expression, LawsAssumed laws, const Given& given) const {
    return is_provable({expression, zero_expression()}) &&
           holds({expression, zero_expression()}, laws, given);
  }
  bool both_sides_are_0(const Equality& link, LawsAssumed laws, const Given& given) const {
    return !is_written_as_zero(link.left) && !is_written_as_zero(link.right) &&
           is_0(link.left, laws, given) && is_0(link.right, laws, given);
  }

  /// Of more than one: "dT/dt = 0" says what it says.
  bool has_a_part_that_is_0(LawsAssumed laws, const Given& given) const {
    if (both_sides_are_0(link_, laws, given)) return true;
    std::vector<Expression> terms;
    for (const Expression* side : {&link_.left, &link_.right})
      for (const SignedTerm& term : terms_of(*side))
        if (Expression part = part_of(*side, term.node); !is_written_as_zero(part))
          terms.push_back(std::move(part));
    return terms.size() > 1 && std::any_of(terms.begin(), terms.end(),
                                           [&](const Expression& term) { return is_0(term, laws, given); });
  }

  /// The axis whose equation has the difference of two moments: I2 − I3 is that of axis 1, from 0.
  static std::optional<std::pair<int, bool>> axis_of_difference(Q plus, Q minus) {
    const int i = static_cast<int>(plus) - static_cast<int>(Q::I1),
              k = static_cast<int>(minus) - static_cast<int>(Q::I1);
    if (i == k) return std::nullopt;
    return std::pair(3 - i - k, (i + 1) % 3 == k);
  }

  static bool is_moment(const ExpressionNode& n) {
    return n.operation == O::quantity && (n.quantity == Q::I1 || n.quantity == Q::I2 || n.quantity == Q::I3);
  }

  static int plus_or_minus(Rewriting& r, int to, int more, bool is_plus) {
    return r.builder().add(is_plus ? O::add : O::subtract, to, more, 0);
  }

  /// What is put back: without torque N, and with one a part of it, that of the vector A.
  Q part() const { return derivation_.laws == LawsAssumed::free ? Q::N : Q::A; }

  int component(Rewriting& r, int axis) const {
    if (part() == Q::N) return r.quantity(static_cast<Q>(static_cast<int>(Q::N1) + axis));
    return r.builder().component(r.quantity(Q::A), axis, 0, 0);
  }

  /// I2 - I3 + I3 - I1: each difference with N1/(w2 w3) to it; nothing if it is no such sum.
  std::optional<int> changed_differences(Rewriting& r, const Expression& old, const ExpressionNode& n) const {
    std::vector<SignedTerm> terms;
    add_terms(old, static_cast<int>(&n - old.nodes.data()), true, terms);
    if (terms.size() % 2 != 0) return std::nullopt;
    std::vector<std::pair<int, bool>> axes;
    for (std::size_t i = 0; i < terms.size(); i += 2) {
      const SignedTerm &a = terms[i], &b = terms[i + 1];
      if (!is_moment(r.old(a.node)) || !is_moment(r.old(b.node)) || a.is_plus == b.is_plus)
        return std::nullopt;
      const auto axis = axis_of_difference(r.old((a.is_plus ? a : b).node).quantity,
                                           r.old((a.is_plus ? b : a).node).quantity);
      if (!axis) return std::nullopt;
      axes.push_back(*axis);
    }
    int sum = r.number(0);
    for (const SignedTerm& term : terms) {
      const int moment = r.quantity(r.old(term.node).quantity);
      sum = plus_or_minus(r, sum, moment, term.is_plus);
    }
    for (const auto& [axis, is_plus] : axes) {
      const auto on_axis = [&, at = axis](Q first, int further) {
        return r.quantity(static_cast<Q>(static_cast<int>(first) + (at + further) % 3));
      };
      const int torque = component(r, axis), next = on_axis(Q::w1, 1), last = on_axis(Q::w1, 2);
      const int below = r.builder().multiply(next, last, 0);
      sum = plus_or_minus(r, sum, r.builder().divide(torque, below, 0), is_plus);
    }
    return sum;
  }

  /// A side as it would be if Euler's equations had N, or A, to the terms with ω×.
  std::optional<Expression> under_another_law(const Expression& side, int& places) const {
    const auto is_omega = [&](int index) {
      const ExpressionNode& n = side.nodes[static_cast<std::size_t>(index)];
      return n.operation == O::quantity && n.quantity == Q::omega;
    };
    const auto is_L = [&](int index) {
      const ExpressionNode& n = side.nodes[static_cast<std::size_t>(index)];
      return (n.operation == O::quantity && n.quantity == Q::L) ||
             (n.operation == O::inertia && is_omega(n.a));
    };
    const Rewriting::Change change = [&](Rewriting& r, const ExpressionNode& n) -> std::optional<int> {
      if (n.operation == O::add || n.operation == O::subtract)
        if (auto sum = changed_differences(r, side, n)) return ++places, sum;
      const auto same = r.copy(n);
      if (!same) return same;
      const bool turns = n.operation == O::cross && is_omega(n.a) && is_L(n.b),
                 turns_back = n.operation == O::cross && is_L(n.a) && is_omega(n.b);
      if (turns || turns_back) return ++places, plus_or_minus(r, *same, r.quantity(part()), turns_back);
      if (n.operation != O::quantity) return same;
      if (n.quantity == Q::N) return plus_or_minus(r, *same, r.quantity(part()), false);
      const int axis = static_cast<int>(n.quantity) - static_cast<int>(Q::N1);
      return axis >= 0 && axis < 3 ? plus_or_minus(r, *same, component(r, axis), false) : *same;
    };
    return Rewriting(side, Rewriting::kEach, change).write();
  }

  std::optional<Equality> under_another_law(int& places) const {
    auto left = under_another_law(link_.left, places), right = under_another_law(link_.right, places);
    if (!left || !right || places == 0) return std::nullopt;
    return Equality{std::move(*left), std::move(*right)};
  }

  bool holds_under_another_law() const {
    if (derivation_.laws == LawsAssumed::identity || link_.left.uses(Q::A) || link_.right.uses(Q::A))
      return false;
    int places = 0;
    const auto link = under_another_law(places);
    return link && holds(*link, LawsAssumed::motion, derivation_.given) &&
           !both_sides_are_0(*link, LawsAssumed::motion, derivation_.given);
  }

  /// Every sign a plus: then nothing cancels.
  static Expression all_plus(Expression expression) {
    for (ExpressionNode& n : expression.nodes) {
      if (n.operation == O::subtract) n.operation = O::add;
      if (n.operation == O::negate) n.operation = O::power, n.integer = 1;
    }
    return expression;
  }
  static CanonicalForm terms_without_signs(const Equality& equality) {
    return expanded_form({all_plus(equality.left), all_plus(equality.right)});
  }

  /// Of one without brackets: a sign before a bracket would not be seen.
  bool is_worked_line() const {
    int places = 0;
    static_cast<void>(under_another_law(places));
    if (places > 0) return false;
    const CanonicalForm terms = terms_without_signs(link_), left_over = expanded_form(link_);
    const auto is_this = [&](const Equality& link) {
      return !is_written_as_zero(link.left) && !is_written_as_zero(link.right) &&
             terms_without_signs(link) == terms && expanded_form(link) == left_over;
    };
    return std::any_of(derivation_.worked.begin(), derivation_.worked.end(), [&](const WorkedLine& worked) {
      return std::any_of(worked.line.links.begin(), worked.line.links.end(), is_this);
    });
  }

  const Equality& link_;
  const Derivation& derivation_;
  const Prover& prover_;
};

}  // namespace

bool is_decided(const Equality& link, const Derivation& derivation, const Prover& prover) {
  return Decision(link, derivation, prover).decide();
}

bool is_mere_rearrangement(const Equality& equality) {
  const auto &left = equality.left, &right = equality.right;
  if (left.text == right.text) return true;
  if (!is_rational(left) || !is_rational(right) || !canonical_form(equality).empty()) return false;
  const auto is_zero = [](const Expression& side) { return side.type() == ExpressionType::zero; };
  // a × a = 0 says something, though the form drops it; b·a - a·b = 0 does not.
  if (is_zero(left) || is_zero(right)) return !left.uses(O::cross) && !right.uses(O::cross);
  std::vector<SignedTerm> of_left, of_right;  // what adds up, or cancels, says something
  add_terms(left, static_cast<int>(left.nodes.size()) - 1, true, of_left);
  add_terms(right, static_cast<int>(right.nodes.size()) - 1, true, of_right);
  return of_left.size() == of_right.size();
}

}  // namespace polhode
