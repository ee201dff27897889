// SPDX-License-Identifier: MIT
#include "lessons/derivation/slips.h"

#include "lessons/claims/expressions/expression_names.h"
#include "lessons/claims/expressions/expression_variants.h"
#include "lessons/claims/expressions/vocabulary.h"
#include "lessons/derivation/rewriting.h"
#include "lessons/diagnostics/report.h"
#include "lessons/notation/typed/expression_typing.h"

#include <algorithm>
#include <array>

namespace polhode {
namespace {

using O = Operation;
using Q = Quantity;

/// First of three quantities that are one on each axis.
constexpr std::array<Q, 6> kOnAxes = {Q::I1, Q::w1, Q::dw1, Q::N1, Q::e1, Q::ex};

std::optional<std::pair<Q, int>> axis_of(Q quantity) {
  for (const Q first : kOnAxes) {
    const int axis = static_cast<int>(quantity) - static_cast<int>(first);
    if (axis >= 0 && axis < 3) return std::pair(first, axis);
  }
  return std::nullopt;
}

Q on_axis(Q first, int axis) { return static_cast<Q>(static_cast<int>(first) + axis); }

class SlipSearch {
 public:
  SlipSearch(const Equality& wrong, const std::vector<std::string>& terms,
             const std::function<bool(const Equality&)>& holds, const Vocabulary& vocabulary,
             MendedSides sides)
      : wrong_(wrong), terms_(terms), holds_(holds), vocabulary_(vocabulary), sides_(sides) {}

  FoundSlip find() {
    using Look = bool (SlipSearch::*)();
    constexpr std::array<Look, 12> kLooks = {
        &SlipSearch::signs,    &SlipSearch::sign,    &SlipSearch::extra,     &SlipSearch::factor,
        &SlipSearch::index,    &SlipSearch::frame,   &SlipSearch::transport, &SlipSearch::rate,
        &SlipSearch::exponent, &SlipSearch::inertia, &SlipSearch::factors,   &SlipSearch::missing};
    for (const Look look : kLooks)
      if ((this->*look)()) return found_;
    if (indices()) return found_;
    return {Slip::other, ""};
  }

 private:
  const Expression& side(int which) const { return which == 0 ? wrong_.left : wrong_.right; }

  bool try_equality(const Equality& mended, Slip slip, const std::string& reason) {
    if (tried_ >= kMostMends) return false;
    ++tried_;
    if (!fit(mended.left.type(), mended.right.type()) || !is_provable(mended) || !holds_(mended))
      return false;
    if (sides_ == MendedSides::both && canonical_form(mended).empty())
      return false;  // nothing is said any more
    found_ = {slip, reason};
    return true;
  }

  bool try_side(int which, std::optional<Expression> changed, Slip slip, const std::string& reason) {
    if (!changed || which < first_side()) return false;
    return try_equality(
        which == 0 ? Equality{std::move(*changed), wrong_.right} : Equality{wrong_.left, std::move(*changed)},
        slip, reason);
  }

  bool try_change(int which, int node, const Rewriting::Change& change, Slip slip,
                  const std::string& reason) {
    return try_side(which, Rewriting(side(which), node, change).write(), slip, reason);
  }

  /// What stands between the signs around a node, as it is typed.
  std::string place_of(int which, int node) const {
    const Expression& expression = side(which);
    int at = node;
    const auto parent_of = [&](int child) {
      for (std::size_t i = static_cast<std::size_t>(child) + 1; i < expression.nodes.size(); ++i)
        if (expression.nodes[i].a == child || expression.nodes[i].b == child) return static_cast<int>(i);
      return -1;
    };
    while (true) {
      const int parent = parent_of(at);
      if (parent < 0) break;
      const O operation = expression.nodes[static_cast<std::size_t>(parent)].operation;
      if (operation == O::add || operation == O::subtract || operation == O::negate) break;
      at = parent;
    }
    return in_quotes(typing_of(expression, at));
  }

  int first_side() const { return sides_ == MendedSides::both ? 0 : 1; }

  template <class Do>
  bool for_each_node(const Do& act) const {
    for (int which = first_side(); which < 2; ++which)
      for (std::size_t i = 0; i < side(which).nodes.size(); ++i)
        if (act(which, static_cast<int>(i), side(which).nodes[i])) return true;
    return false;
  }

  /// Whole sides, and what stands in their sums.
  template <class Do>
  bool for_each_term(const Do& act) const {
    for (int which = first_side(); which < 2; ++which) {
      std::vector<int> terms = summands_of(side(which));
      const int whole = static_cast<int>(side(which).nodes.size()) - 1;
      if (terms.empty()) terms.push_back(whole);
      for (const int term : terms)
        if (act(which, term)) return true;
    }
    return false;
  }

  bool signs() {
    return (summands_of(wrong_.left).size() > 1 || summands_of(wrong_.right).size() > 1) &&
           try_side(1, negated(wrong_.right), Slip::signs,
                    "all the signs of one side are the other way round");
  }

  bool sign() {
    const Rewriting::Change turned = [](Rewriting& r, const ExpressionNode& n) -> std::optional<int> {
      const auto same = r.copy(n);
      return same ? std::optional(r.builder().negate(*same, 0)) : std::nullopt;
    };
    if (for_each_term([&](int which, int term) {
          return try_change(which, term, turned, Slip::sign,
                            "the sign of " + in_quotes(typing_of(side(which), term)) + " is not right");
        }))
      return true;
    return for_each_node([&](int which, int node, const ExpressionNode& n) {
      return n.operation == O::cross &&
             try_change(which, node, turned, Slip::sign,
                        "in " + place_of(which, node) +
                            " the factors of the cross product stand the wrong way round");
    });
  }

  bool add_terms(const std::vector<std::string>& terms, Slip slip, const std::string& reason) {
    for (const std::string& text : terms) {
      const SourceText source(text);
      Report report(source, "");
      const auto term = read_expression(text, {1, 1}, report, &vocabulary_);
      if (!term || !fit(term->type(), wrong_.left.type())) continue;
      for (const O sign : {O::add, O::subtract}) {
        const Rewriting::Change with_term = [&](Rewriting& r, const ExpressionNode& n) -> std::optional<int> {
          const auto same = r.copy(n);
          if (!same) return std::nullopt;
          const int more = r.builder().insert(*term, 0, 0);
          return r.builder().add(sign, *same, more, 0);
        };
        const int whole = static_cast<int>(wrong_.right.nodes.size()) - 1;
        if (try_change(1, whole, with_term, slip, reason)) return true;
      }
    }
    return false;
  }

  bool transport() {
    std::vector<std::string> terms = {"cross(omega, L)"};
    for (int k = 1; k <= 3; ++k) terms.push_back("comp(cross(omega, L), " + std::to_string(k) + ')');
    terms.insert(terms.end(), {"cross(omega, A)", "cross(omega, omega)", "dot(omega, cross(omega, L))"});
    // What a rate is taken of, once as seen from space and once from the body.
    for_each_node([&](int which, int, const ExpressionNode& n) {
      if ((n.operation == O::star || n.operation == O::ddt) && n.type == ExpressionType::vector) {
        const ExpressionNode& of = side(which).nodes[static_cast<std::size_t>(n.a)];
        if (of.operation == O::quantity)
          terms.push_back("cross(omega, " + std::string(facts_of(of.quantity).name) + ')');
      }
      return false;
    });
    if (add_terms(terms, Slip::transport, "a term with ω× is missing: the axes turn with the body"))
      return true;
    return for_each_node([&](int which, int node, const ExpressionNode& n) {
      const Rewriting::Change change = [&](Rewriting& r, const ExpressionNode& same) -> std::optional<int> {
        const int omega = r.quantity(Q::omega);
        const auto of = r.copy(same);
        return of ? r.call(O::cross, omega, *of) : std::nullopt;
      };
      return n.type == ExpressionType::vector &&
             try_change(which, node, change, Slip::transport,
                        "in " + place_of(which, node) + " an ω× is missing");
    });
  }

  bool missing() {
    std::vector<std::string> terms = terms_;
    for (const char* i : {"1", "2", "3"}) {
      const auto with = [i](const char* before, const char* behind) {
        return before + std::string(i) + behind;
      };
      const std::string w = with("w", ""), I = with("I", ""), e = with("*e", ""), L = with("comp(L, ", ")");
      terms.insert(terms.end(), {w + with("*N", ""), w + '*' + L, I + '*' + w + '*' + with("dw", ""),
                                 I + '*' + w + e, with("comp(A, ", ")") + e, I + with("*dw", ""),
                                 I + '*' + I + '*' + w + '*' + w, I + '*' + w + '*' + w});
      for (const char* k : {"1", "2", "3"}) {
        if (k == std::string_view(i)) continue;
        terms.push_back(w + "*comp(L, " + k + ')');
        terms.push_back(w + "*e" + k);
        terms.push_back(w + "*comp(A, " + k + ')');
        for (const char* of : {"1", "2", "3"}) terms.push_back(std::string("I") + of + '*' + w + "*w" + k);
      }
    }
    return add_terms(terms, Slip::missing, "a term is missing");
  }

  bool extra() {
    return for_each_term([&](int which, int term) {
      return side(which).nodes.size() > 1 &&
             try_side(which, without_summand(side(which), term), Slip::extra,
                      in_quotes(typing_of(side(which), term)) + " does not belong there");
    });
  }

  bool index() {
    return for_each_node([&](int which, int node, const ExpressionNode& n) {
      if (n.operation == O::comp) {
        for (int axis = 0; axis < 3; ++axis) {
          ExpressionNode other = n;
          other.integer = axis;
          const Rewriting::Change change = [&](Rewriting& r, const ExpressionNode&) { return r.copy(other); };
          if (axis != n.integer && try_index(which, node, change, Slip::index,
                                             "an index in " + place_of(which, node) + " is not right"))
            return true;
        }
        return false;
      }
      const auto axis = n.operation == O::quantity ? axis_of(n.quantity) : std::nullopt;
      if (!axis) return false;
      for (int other = 0; other < 3; ++other) {
        const Rewriting::Change change = [&](Rewriting& r, const ExpressionNode&) {
          return std::optional(r.quantity(on_axis(axis->first, other)));
        };
        if (other != axis->second && try_index(which, node, change, Slip::index,
                                               "an index in " + place_of(which, node) + " is not right"))
          return true;
      }
      return false;
    });
  }

  /// Of Ṫ = (I₂ − I₃)ω₁ω₂ω₃ another index leaves Ṫ = 0, which is true; but it was terms that were missing. So
  /// what stands around the index has to stay.
  bool try_index(int which, int node, const Rewriting::Change& change, Slip slip, const std::string& reason) {
    if (!try_change(which, node, change, slip, reason)) return false;
    const auto term = Rewriting(part_of(which, term_around(which, node)), node, change).write();
    return term && !holds_({*term, zero_expression()});
  }

  /// The summand of the whole side that a node belongs to.
  int term_around(int which, int node) const {
    int at = whole(which);
    while (at != node) {
      const ExpressionNode& n = node_at(which, at);
      const bool is_sum = n.operation == O::add || n.operation == O::subtract;
      if (!is_sum && n.operation != O::negate) break;
      at = is_sum && node > n.a ? n.b : n.a;
    }
    return at;
  }

  bool frame() {
    return for_each_node([&](int which, int node, const ExpressionNode& n) {
      if ((n.operation != O::ddt && n.operation != O::star) || n.type != ExpressionType::vector) return false;
      const Rewriting::Change change = [&](Rewriting& r, const ExpressionNode&) -> std::optional<int> {
        const auto of = r.again(n.a);
        return of ? r.call(n.operation == O::ddt ? O::star : O::ddt, *of) : std::nullopt;
      };
      return try_change(
          which, node, change, Slip::frame,
          in_quotes(typing_of(side(which), node)) + " is the rate as seen from the other frame");
    });
  }

  bool rate() {
    return for_each_node([&](int which, int node, const ExpressionNode& n) {
             const std::string here = place_of(which, node);
             const Rewriting::Change without = [&](Rewriting& r,
                                                   const ExpressionNode&) -> std::optional<int> {
               return n.operation == O::quantity
                          ? std::optional(r.quantity(
                                on_axis(Q::w1, static_cast<int>(n.quantity) - static_cast<int>(Q::dw1))))
                          : r.again(n.a);
             };
             if (is_rate(n) && try_change(which, node, without, Slip::rate,
                                          "in " + here + " there is a derivative too many"))
               return true;
             // What does not change has no rate that anybody forgets.
             if (n.operation == O::number || (n.operation == O::quantity && is_moment(n))) return false;
             for (const O operation : {O::ddt, O::star}) {
               const Rewriting::Change with = [&](Rewriting& r,
                                                  const ExpressionNode& same) -> std::optional<int> {
                 const auto of = r.copy(same);
                 return of ? r.call(operation, *of) : std::nullopt;
               };
               if (operation == O::star && n.type != ExpressionType::vector) continue;
               if (!is_constant(which, node) &&
                   try_change(which, node, with, Slip::rate, "in " + here + " a derivative is missing"))
                 return true;
             }
             return false;
           }) ||
           for_each_term([&](int which, int term) {
             for (const Q rate : {Q::dw1, Q::dw2, Q::dw3})
               if (try_times(which, term, {rate}, Slip::rate,
                             "in " + in_quotes(typing_of(side(which), term)) + " a derivative is missing"))
                 return true;
             return false;
           });
  }

  static bool is_moment(const ExpressionNode& n) {
    return n.operation == O::quantity && (n.quantity == Q::I1 || n.quantity == Q::I2 || n.quantity == Q::I3);
  }

  /// What a node stands for.
  Expression part_of(int which, int node) const {
    const Expression& whole = side(which);
    return {whole.text + " part", {whole.nodes.begin(), whole.nodes.begin() + node + 1}, whole.constants};
  }

  /// Whether what a node stands for does not change on any motion that is allowed.
  bool is_constant(int which, int node) const {
    const Expression part = part_of(which, node);
    const Rewriting::Change rate = [](Rewriting& r, const ExpressionNode& n) -> std::optional<int> {
      const auto same = r.copy(n);
      return same ? r.call(O::ddt, *same) : std::nullopt;
    };
    const auto changed = Rewriting(part, node, rate).write();
    return !changed || holds_({*changed, zero_expression()});
  }

  bool try_times(int which, int term, std::initializer_list<Q> factors, Slip slip,
                 const std::string& reason) {
    return try_change(
        which, term,
        [&](Rewriting& r, const ExpressionNode& n) -> std::optional<int> {
          auto product = r.copy(n);
          for (const Q factor : factors)
            if (product) product = r.builder().multiply(r.quantity(factor), *product, 0);
          return product;
        },
        slip, reason);
  }

  bool inertia() {
    using Change = Rewriting::Change;
    const Change with_inertia = [](Rewriting& r, const ExpressionNode& same) -> std::optional<int> {
      const auto of = r.copy(same);
      return of ? r.call(O::inertia, *of) : std::nullopt;
    };
    if (for_each_node([&](int which, int node, const ExpressionNode& n) {
          const std::string reason = "in " + place_of(which, node) + " the inertia is not where it belongs";
          const auto mends = [&](const Change& change) {
            return try_change(which, node, change, Slip::inertia, reason);
          };
          if (n.operation == O::inertia &&
              mends([&](Rewriting& r, const ExpressionNode&) { return r.again(n.a); }))
            return true;
          if (n.operation == O::quantity && n.quantity == Q::L)
            return mends(
                [](Rewriting& r, const ExpressionNode&) { return std::optional(r.quantity(Q::omega)); });
          if (n.type == ExpressionType::vector && mends(with_inertia)) return true;
          if (n.operation == O::divide && is_moment(node_at(which, n.b)))
            return mends([&](Rewriting& r, const ExpressionNode&) { return r.again(n.a); }) ||
                   mends([&](Rewriting& r, const ExpressionNode&) -> std::optional<int> {
                     const auto a = r.again(n.a), I = r.again(n.b);
                     return a && I ? std::optional(r.builder().multiply(*I, *a, 0)) : std::nullopt;
                   });
          if (n.operation == O::multiply)
            for (const int kept : {n.a, n.b})
              if (is_moment(node_at(which, kept == n.a ? n.b : n.a)) &&
                  mends([&](Rewriting& r, const ExpressionNode&) { return r.again(kept); }))
                return true;
          return false;
        }))
      return true;
    return for_each_term([&](int which, int term) {
      const std::string here = "in " + in_quotes(typing_of(side(which), term)) + " a moment of inertia is ";
      for (const Q moment : {Q::I1, Q::I2, Q::I3}) {
        const Change over = [&](Rewriting& r, const ExpressionNode& n) -> std::optional<int> {
          const auto same = r.copy(n);
          return same ? std::optional(r.builder().divide(*same, r.quantity(moment), 0)) : std::nullopt;
        };
        if (try_times(which, term, {moment}, Slip::inertia, here + "missing") ||
            try_times(which, term, {moment, moment}, Slip::inertia, here + "missing") ||
            try_change(which, term, over, Slip::inertia, here + "too many"))
          return true;
      }
      return false;
    });
  }

  const ExpressionNode& node_at(int which, int index) const {
    return side(which).nodes[static_cast<std::size_t>(index)];
  }

  /// Squares too many, and missing.
  bool exponent() {
    return for_each_node([&](int which, int node, const ExpressionNode& n) {
      const std::string here = "in " + place_of(which, node) + ' ';
      const auto mends = [&](const Rewriting::Change& change, const char* what) {
        return try_change(which, node, change, Slip::power, here + what);
      };
      if (n.operation == O::power) {
        const auto raised = [&](Rewriting& r, const ExpressionNode&) -> std::optional<int> {
          const auto of = r.again(n.a);
          return of ? std::optional(r.builder().power(*of, n.integer == 2 ? 3 : 2, 0, 0)) : std::nullopt;
        };
        return mends([&](Rewriting& r, const ExpressionNode&) { return r.again(n.a); },
                     "there is a square too many") ||
               mends(raised, "the power is not right");
      }
      if (n.operation == O::norm) {
        const auto squared = [&](Rewriting& r, const ExpressionNode&) -> std::optional<int> {
          const auto of = r.again(n.a);
          return of ? r.call(O::norm2, *of) : std::nullopt;
        };
        return mends(squared, "a square is missing");
      }
      const auto squared = [](Rewriting& r, const ExpressionNode& same) -> std::optional<int> {
        const auto of = r.copy(same);
        return of ? std::optional(r.builder().power(*of, 2, 0, 0)) : std::nullopt;
      };
      return n.type == ExpressionType::scalar && n.operation != O::number &&
             mends(squared, "a square is missing");
    });
  }

  /// Factors too many, and missing.
  bool factors() {
    if (for_each_node([&](int which, int node, const ExpressionNode& n) {
          if (n.operation != O::multiply) return false;
          for (const int kept : {n.a, n.b}) {
            const ExpressionNode& dropped = node_at(which, kept == n.a ? n.b : n.a);
            if (dropped.operation != O::number &&
                try_change(
                    which, node, [&](Rewriting& r, const ExpressionNode&) { return r.again(kept); },
                    Slip::power, "in " + place_of(which, node) + " there is a factor too many"))
              return true;
          }
          return false;
        }))
      return true;
    return for_each_term([&](int which, int term) {
      for (const Q w : {Q::w1, Q::w2, Q::w3})
        if (try_times(which, term, {w}, Slip::power,
                      "in " + in_quotes(typing_of(side(which), term)) + " a factor is missing"))
          return true;
      return false;
    });
  }

  bool factor() {
    constexpr std::array<std::pair<int, int>, 6> kFactors{{{2, 1}, {1, 2}, {3, 1}, {1, 3}, {4, 1}, {1, 4}}};
    const auto scaled = [](int above, int below) -> Rewriting::Change {
      return [above, below](Rewriting& r, const ExpressionNode& n) -> std::optional<int> {
        const auto same = r.copy(n);
        if (!same) return std::nullopt;
        const int top = r.builder().multiply(r.number(above), *same, 0);
        return r.builder().divide(top, r.number(below), 0);
      };
    };
    for (const auto& [above, below] : kFactors) {
      const int whole = static_cast<int>(wrong_.right.nodes.size()) - 1;
      if (try_change(1, whole, scaled(above, below), Slip::factor,
                     "a number as a factor is not right: the sides differ by one"))
        return true;
    }
    return for_each_term([&](int which, int term) {
      for (const auto& [above, below] : kFactors)
        if (try_change(which, term, scaled(above, below), Slip::factor,
                       "in " + in_quotes(typing_of(side(which), term)) + " the number in front is not right"))
          return true;
      return false;
    });
  }

  bool indices() {
    for (const AxisPermutation& permutation : kAxisPermutations)
      for (int which = 0; which < 2; ++which)
        if (try_side(which, renamed(side(which), permutation), Slip::indices,
                     "the indices of one side are mixed up"))
          return true;
    // Those of one term, of all its quantities or of one kind of them.
    for (int family = -2; family < static_cast<int>(kOnAxes.size()); ++family) {
      const bool is_whole = family >= -1;  // of a kind all terms have slipped together
      const auto mends = [&](int which, int term) {
        for (const AxisPermutation& permutation : kAxisPermutations) {
          const Rewriting::Change change = [&](Rewriting& r, const ExpressionNode& n) {
            return permuted(r, side(which), n, permutation, family);
          };
          if (try_index(which, term, change, Slip::indices,
                        "the indices in " + in_quotes(typing_of(side(which), term)) + " are mixed up"))
            return true;
        }
        return false;
      };
      if (!is_whole && for_each_term(mends)) return true;
      if (is_whole && (mends(1, whole(1)) || mends(0, whole(0)))) return true;
    }
    return false;
  }

  int whole(int which) const { return static_cast<int>(side(which).nodes.size()) - 1; }

  static std::optional<int> permuted(Rewriting& r, const Expression& old, const ExpressionNode& n,
                                     const AxisPermutation& permutation, int family) {
    const auto is_meant = [family](int of) { return family == -2 || of == family; };  // -1: components
    if (n.operation == O::quantity)
      if (const auto axis = axis_of(n.quantity);
          axis && is_meant(static_cast<int>(std::find(kOnAxes.begin(), kOnAxes.end(), axis->first) -
                                            kOnAxes.begin())))
        return r.quantity(on_axis(axis->first, permutation[static_cast<std::size_t>(axis->second)]));
    const auto operand = [&](int index) {
      return index < 0 ? std::optional(-1)
                       : permuted(r, old, old.nodes[static_cast<std::size_t>(index)], permutation, family);
    };
    const auto a = operand(n.a), b = operand(n.b);
    if (!a || !b) return std::nullopt;
    ExpressionNode other = n;
    if (n.operation == O::comp && is_meant(-1))
      other.integer = permutation[static_cast<std::size_t>(n.integer)];
    return r.over(other, *a, *b);
  }

  const Equality& wrong_;
  const std::vector<std::string>& terms_;
  const std::function<bool(const Equality&)>& holds_;
  const Vocabulary& vocabulary_;
  MendedSides sides_;
  FoundSlip found_;
  int tried_ = 0;
};

}  // namespace

FoundSlip find_slip(const Equality& wrong, const std::vector<std::string>& terms,
                    const std::function<bool(const Equality&)>& holds, const Vocabulary& vocabulary,
                    MendedSides sides) {
  return SlipSearch(wrong, terms, holds, vocabulary, sides).find();
}

}  // namespace polhode
