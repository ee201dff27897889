// SPDX-License-Identifier: MIT
#include "lessons/claims/proof/signs.h"

#include "lessons/claims/proof/rational_function.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace polhode {
namespace {

/// What I1, I2, I3 are of a, b, c, or J_xx, J_yy, J_zz of others such: row by row.
using Forms = std::array<std::array<Ratio, 3>, 3>;
const Forms kPossible{{{0, 1, 1}, {1, 0, 1}, {1, 1, 0}}};
constexpr std::array<SymbolIndex, 3> kMomentsOfI{symbols::kMoments, symbols::kMoments + 1,
                                                 symbols::kMoments + 2},
    kMomentsOfJ{symbols::kTensor, symbols::kTensor + 3, symbols::kTensor + 5};

bool is_positive(SymbolIndex symbol) {
  const auto is_in = [symbol](const auto& all) {
    return std::find(all.begin(), all.end(), symbol) != all.end();
  };
  return symbol == symbols::kMass || is_in(kMomentsOfI) || is_in(kMomentsOfJ);
}

/// What is known of the sign of each symbol: never negative, and never 0 either.
struct KnownSigns {
  std::array<bool, kSymbols> not_negative{}, not_zero{};
};

bool is_never_negative(const Monomial& monomial, const KnownSigns& signs) {
  for (SymbolIndex symbol = 0; symbol < kSymbols; ++symbol)
    if (monomial[symbol] % 2 != 0 && !signs.not_negative[symbol]) return false;
  return true;
}

bool is_never_zero(const Monomial& monomial, const KnownSigns& signs) {
  for (SymbolIndex symbol = 0; symbol < kSymbols; ++symbol)
    if (monomial[symbol] != 0 && !signs.not_zero[symbol]) return false;
  return true;
}

Ratio absolute(const Ratio& x) { return x.sign() < 0 ? -x : x; }
bool is_less(const Ratio& a, const Ratio& b) { return (a + -b).sign() < 0; }

/// γ²/s; the exponents of γ are at most half of what they can be.
Monomial partner(const Monomial& gamma, const Monomial& s) {
  Monomial inverse;
  for (std::size_t i = 0; i < kSymbols; ++i) inverse[i] = static_cast<std::int8_t>(-s[i]);
  return times(times(gamma, gamma), inverse);
}

/// Takes of the terms `good` what makes up for c γ; false if they do not.
bool make_up_for(const Monomial& gamma, Ratio c, Terms& good) {
  c = absolute(c);
  const Ratio half = Ratio(2).reciprocal();
  for (auto s = good.begin(); s != good.end() && c.sign() > 0; ++s) {
    const auto t = good.find(partner(gamma, s->first));
    if (t == good.end() || t == s) continue;
    Ratio &of_s = s->second, &of_t = t->second;
    if (of_s.sign() == 0 || of_t.sign() == 0) continue;
    Ratio &less = is_less(of_s, of_t) ? of_s : of_t, &more = &less == &of_s ? of_t : of_s;
    const Ratio each = c * half;  // λ = μ
    if (!is_less(less, each)) {
      less = less + -each, more = more + -each;
      return true;
    }
    const Ratio other = each * each * less.reciprocal();  // λ μ = (c/2)², λ all that is there
    if (!is_less(more, other)) {
      more = more + -other, less = 0;
      return true;
    }
    c = c + -(Ratio(2) * less);
    more = more + -less, less = 0;
  }
  return c.sign() == 0;
}

bool is_sum_of_what_is_not_negative(const Terms& terms, bool strict, const KnownSigns& signs) {
  Terms good, others;
  for (const auto& [monomial, coefficient] : terms)
    (coefficient.sign() > 0 && is_never_negative(monomial, signs) ? good : others)
        .emplace(monomial, coefficient);
  for (const auto& [monomial, coefficient] : others)
    if (!make_up_for(monomial, coefficient, good)) return false;
  return !strict || std::any_of(good.begin(), good.end(), [&](const auto& term) {
    return term.second.sign() > 0 && is_never_zero(term.first, signs);
  });
}

/// The terms with three symbols, which are positive, written by others; free of powers of them in divisors.
Terms rewritten(const Terms& terms, const std::array<SymbolIndex, 3>& three, const Forms& forms) {
  Monomial clearing{};
  for (const auto& [monomial, coefficient] : terms)
    for (const SymbolIndex symbol : three)
      clearing[symbol] = std::max(clearing[symbol], static_cast<std::int8_t>(-monomial[symbol]));
  std::array<Terms, 3> moments;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      Monomial one{};
      one[three[k]] = 1;
      if (forms[i][k].sign() != 0) moments[i].emplace(one, forms[i][k]);
    }
  Terms all;
  for (const auto& [monomial, coefficient] : terms) {
    Monomial rest = times(monomial, clearing);
    std::array<int, 3> exponents{};
    for (std::size_t i = 0; i < 3; ++i)  // none is negative
      exponents[i] = static_cast<unsigned char>(std::exchange(rest[three[i]], std::int8_t{0}));
    Terms product{{rest, coefficient}};
    for (std::size_t i = 0; i < 3; ++i)
      for (int n = 0; n < exponents[i]; ++n) product = multiplied(product, moments[i]);
    all = added(std::move(all), product, 1);
  }
  return all;
}

/// The moment as a sum of moments times numbers; nothing if it is something else.
std::optional<std::array<Ratio, 3>> linear(const RationalFunction& moment) {
  if (!moment.is_polynomial()) return std::nullopt;
  std::array<Ratio, 3> form;
  for (const auto& [monomial, coefficient] : moment.above()) {
    std::optional<std::size_t> only;
    for (std::size_t i = 0; i < 3; ++i) {
      Monomial alone{};
      alone[kMomentsOfI[i]] = 1;
      if (monomial == alone) only = i;
    }
    if (!only) return std::nullopt;
    form[*only] = coefficient;
  }
  return form;
}

/// The moments by a, b, c ≥ 0, and which of these are never 0.
struct PossibleMoments {
  Forms forms = kPossible;
  std::array<bool, 3> not_zero{};
};

/// With f·(I1, I2, I3) > 0, or ≥ 0. Where one of a, b, c alone has a positive factor it is replaced by what
/// it exceeds the others by: these are then all moments of which that is so, and no others.
void restrict_by(const std::array<Ratio, 3>& f, bool strict, PossibleMoments& moments) {
  std::array<Ratio, 3> e;
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t x = 0; x < 3; ++x) e[x] = e[x] + f[k] * moments.forms[k][x];
  std::optional<std::size_t> positive;
  for (std::size_t x = 0; x < 3; ++x) {
    if (e[x].sign() <= 0) continue;
    if (positive) return;
    positive = x;
  }
  if (!positive) return;
  const std::size_t d = *positive;
  const Ratio reciprocal = e[d].reciprocal();  // a = (d + Σ (−e) x)/e
  for (auto& moment : moments.forms) {
    const Ratio share = moment[d] * reciprocal;
    for (std::size_t x = 0; x < 3; ++x)
      if (x != d) moment[x] = moment[x] + -(share * e[x]);
    moment[d] = share;
  }
  moments.not_zero[d] = strict;
}

/// The moments so that what they are set to holds; nothing where that is not so simple.
std::optional<Forms> possible_moments(const std::array<RationalFunction, 3>& I) {
  Forms moments = kPossible;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto form = linear(I[i]);
    if (!form) return std::nullopt;
    // 0 = e·(a, b, c), solved for the one whose coefficient alone has its sign.
    std::array<Ratio, 3> e = moments[i];
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t x = 0; x < 3; ++x) e[x] = e[x] + -((*form)[k] * moments[k][x]);
    if (std::all_of(e.begin(), e.end(), [](const Ratio& r) { return r.sign() == 0; })) continue;
    std::optional<std::size_t> solved;
    for (std::size_t x = 0; x < 3; ++x) {
      const auto is_alone = [&] {
        for (std::size_t y = 0; y < 3; ++y)
          if (y != x && e[y].sign() == e[x].sign()) return false;
        return e[x].sign() != 0;
      };
      if (is_alone()) solved = x;
    }
    if (!solved) return std::nullopt;
    const Ratio reciprocal = e[*solved].reciprocal();
    for (auto& moment : moments) {
      const Ratio share = moment[*solved];
      moment[*solved] = 0;
      for (std::size_t y = 0; y < 3; ++y)
        if (y != *solved) moment[y] = moment[y] + -(share * e[y] * reciprocal);
    }
  }
  return moments;
}

KnownSigns signs_of_every_body() {
  KnownSigns signs;
  for (SymbolIndex symbol = 0; symbol < kSymbols; ++symbol)
    signs.not_negative[symbol] = signs.not_zero[symbol] = is_positive(symbol);
  return signs;
}

/// Puts an inequality that is given to use, where it is one of those that can be.
void use(const Bound& bound, const ClaimState<RationalFunction>& state, KnownSigns& signs,
         std::array<bool, kSymbols>& is_turned_round, PossibleMoments& moments) {
  const bool is_upward = bound.relation == Relation::greater || bound.relation == Relation::greater_or_equal;
  const bool strict = bound.relation == Relation::greater || bound.relation == Relation::less;
  const auto left = value_in(state, bound.sides.left), right = value_in(state, bound.sides.right);
  if (!left || !right) return;
  const RationalFunction excess =
      is_upward ? (*left)[0].value - (*right)[0].value : (*right)[0].value - (*left)[0].value;
  if (excess.is_zero()) return;
  if (const auto form = linear(excess)) return restrict_by(*form, strict, moments);
  if (!excess.is_polynomial() || excess.above().size() != 1) return;
  const auto& [monomial, coefficient] = *excess.above().begin();
  std::optional<SymbolIndex> only;
  for (SymbolIndex symbol = 0; symbol < kSymbols; ++symbol) {
    if (monomial[symbol] == 0) continue;
    if (only || monomial[symbol] != 1) return;
    only = symbol;
  }
  if (!only) return;
  is_turned_round[*only] = coefficient.sign() < 0;
  signs.not_negative[*only] = true;
  signs.not_zero[*only] = signs.not_zero[*only] || strict;
}

/// Of −x in place of each x that is turned round.
Terms turned_round(Terms terms, const std::array<bool, kSymbols>& is_turned_round) {
  for (auto& [monomial, coefficient] : terms)
    for (SymbolIndex symbol = 0; symbol < kSymbols; ++symbol)
      if (is_turned_round[symbol] && monomial[symbol] % 2 != 0) coefficient = -coefficient;
  return terms;
}

bool uses_axes_of_space(const Expression& expression) {
  return expression.uses(Quantity::ex) || expression.uses(Quantity::ey) || expression.uses(Quantity::ez);
}

}  // namespace

bool is_never_less(const Equality& stated, bool strict, LawsAssumed laws, const Given& given) {
  const Equality sides = with_lengths_squared(stated);
  const bool turned = uses_axes_of_space(sides.left) || uses_axes_of_space(sides.right) ||
                      std::any_of(given.settings.begin(), given.settings.end(),
                                  [](const Setting& setting) { return uses_axes_of_space(setting.value); });
  try {
    start_algebra();
    const auto state = state_of(symbolic_numbers(turned), laws, given);
    const auto left = state ? value_in(*state, sides.left) : std::nullopt;
    const auto right = state ? value_in(*state, sides.right) : std::nullopt;
    if (!left || !right) return false;
    KnownSigns signs = signs_of_every_body();
    PossibleMoments moments;
    const auto forms = possible_moments(state->I);
    if (forms) moments.forms = *forms;
    std::array<bool, kSymbols> is_turned_round{};  // negative ones, replaced by what they are less than 0
    for (const Bound& bound : given.bounds) use(bound, *state, signs, is_turned_round, moments);
    const RationalFunction difference = (*left)[0].value - (*right)[0].value;
    const Terms terms = turned_round(
        difference.is_polynomial() ? difference.above() : multiplied(difference.above(), difference.below()),
        is_turned_round);
    if (is_sum_of_what_is_not_negative(terms, strict, signs)) return true;
    Terms by_bodies = rewritten(terms, kMomentsOfJ, kPossible);
    for (const SymbolIndex moment : kMomentsOfJ) signs.not_zero[moment] = false;
    if (forms) {
      by_bodies = rewritten(by_bodies, kMomentsOfI, moments.forms);
      for (std::size_t i = 0; i < 3; ++i) signs.not_zero[kMomentsOfI[i]] = moments.not_zero[i];
    }
    return is_sum_of_what_is_not_negative(by_bodies, strict, signs);
  } catch (const BeyondAlgebra&) {
    return false;
  }
}

}  // namespace polhode
