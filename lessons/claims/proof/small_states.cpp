// SPDX-License-Identifier: MIT
#include "lessons/claims/proof/small_states.h"

#include "lessons/claims/proof/expansion.h"
#include "lessons/claims/proof/rational_function.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <random>
#include <span>
#include <utility>
#include <vector>

namespace polhode {
namespace {

using Whole = std::int64_t;
using Whole3 = std::array<Whole, 3>;

constexpr std::array<Whole3, 7> kMoments{
    {{2, 3, 4}, {1, 2, 2}, {4, 3, 5}, {2, 2, 3}, {2, 3, 2}, {1, 2, 3}, {2, 2, 2}}};
constexpr std::array<Whole3, 12> kSpins{{{1, 0, 0},
                                         {0, 1, 0},
                                         {0, 0, 1},
                                         {1, 1, 0},
                                         {0, 1, 1},
                                         {1, 0, 1},
                                         {1, 1, 1},
                                         {1, -1, 0},
                                         {1, 2, 0},
                                         {1, 2, 3},
                                         {2, -1, 1},
                                         {0, 0, 0}}};
constexpr std::array<Whole3, 11> kTorques{{{0, 0, 0},
                                           {1, 0, 0},
                                           {0, 1, 0},
                                           {0, 0, 1},
                                           {1, 1, 0},
                                           {0, 1, 1},
                                           {1, 0, 1},
                                           {1, -1, 0},
                                           {1, 1, 1},
                                           {1, 2, 3},
                                           {-1, 2, 1}}};
/// Of ω; those of N and of ω̇ are others of these, but none where there is none.
constexpr std::array<Whole3, 5> kRates{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 2, 3}}};

/// Attitudes, of any length: body to space.
constexpr std::array<std::array<Whole, 4>, 5> kAttitudes{
    {{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 1, 1, 1}, {2, 1, 0, 0}, {3, 1, -1, 2}}};
/// The constants of a lesson have these values, one after the other, from some place on.
constexpr std::array<Whole, 7> kConstants{2, 3, 1, 5, -1, 4, 7};

/// What else there is; the eigenvalues of J lie between 6 and 12 (Gershgorin), so that it is possible.
struct OtherQuantities {
  std::array<Whole, 6> J;
  Whole3 v, dv, A, dA, F;
  Whole m, h, k;
  Whole3 ddv, ddA, dF;
};
constexpr std::array<OtherQuantities, 5> kOtherQuantities{{
    {.J = {8, 1, 0, 9, 0, 10},
     .v = {1, 0, 0},
     .dv = {0, 1, 0},
     .A = {1, 0, 0},
     .dA = {0, 1, 0},
     .F = {0, 1, 0},
     .m = 2,
     .h = 2,
     .k = 3,
     .ddv = {0, 0, 1},
     .ddA = {0, 0, 1},
     .dF = {1, 0, 0}},
    {.J = {8, 0, 1, 9, -1, 10},
     .v = {0, 1, 0},
     .dv = {1, 0, 1},
     .A = {1, 0, 1},
     .dA = {0, 0, 1},
     .F = {1, 1, 0},
     .m = 3,
     .h = 3,
     .k = 1,
     .ddv = {1, 0, 0},
     .ddA = {1, 1, 0},
     .dF = {0, 0, 1}},
    {.J = {10, 1, 1, 9, 1, 8},
     .v = {1, 2, 3},
     .dv = {3, 1, -1},
     .A = {2, -1, 3},
     .dA = {2, -1, 1},
     .F = {1, 2, -1},
     .m = 2,
     .h = 1,
     .k = 2,
     .ddv = {1, -1, 2},
     .ddA = {3, 1, 2},
     .dF = {2, 1, 3}},
    {.J = {8, 1, 0, 9, 0, 10},
     .v = {1, 0, 0},
     .dv = {0, 1, 0},
     .A = {1, 0, 0},
     .dA = {0, 0, 0},
     .F = {0, 0, 0},
     .m = 1,
     .h = 1,
     .k = 1,
     .ddv = {0, 0, 0},
     .ddA = {0, 0, 0},
     .dF = {0, 0, 0}},
    {.J = {8, 1, 0, 9, 0, 10},
     .v = {0, 0, 0},
     .dv = {0, 1, 0},
     .A = {1, 0, 0},
     .dA = {0, 0, 0},
     .F = {1, 0, 0},
     .m = 1,
     .h = -1,
     .k = 2,
     .ddv = {0, 0, 0},
     .ddA = {0, 0, 0},
     .dF = {0, 0, 0}},
}};

struct SmallNumbers {
  Whole3 I, w, dw, ddw, N, dN;
  OtherQuantities other;
  std::array<Whole, 4> q;
  std::size_t first_constant = 0;  ///< its place in kConstants
};

template <class N>
StateNumbers<N> as(const SmallNumbers& small) {
  StateNumbers<N> numbers;
  const auto copy = [](const auto& from, auto& into) {
    for (std::size_t i = 0; i < from.size(); ++i) into[i] = N(from[i]);
  };
  copy(small.I, numbers.I);
  copy(small.w, numbers.w);
  copy(small.dw, numbers.dw);
  copy(small.ddw, numbers.ddw);
  copy(small.N, numbers.N_B);
  copy(small.dN, numbers.dN_B);
  copy(small.other.J, numbers.J);
  copy(small.other.v, numbers.v_S);
  copy(small.other.dv, numbers.dv_S);
  copy(small.other.A, numbers.A_S);
  copy(small.other.dA, numbers.dA_S);
  copy(small.other.F, numbers.F_S);
  copy(small.other.ddv, numbers.ddv_S);
  copy(small.other.ddA, numbers.ddA_S);
  copy(small.other.dF, numbers.dF_S);
  numbers.m = N(small.other.m);
  numbers.h = N(small.other.h);
  numbers.k = N(small.other.k);
  copy(small.q, numbers.q);
  for (std::size_t i = 0; i < kMaxConstants; ++i)
    numbers.constants[i] = N(kConstants[(small.first_constant + i) % kConstants.size()]);
  return numbers;
}

/// What the sides of an equality depend on, of what is free to choose.
struct Dependence {
  bool I = false, J = false, w = false, dw = false, ddw = false, N = false, dN = false, v = false, dv = false,
       ddv = false, A = false, dA = false, ddA = false, F = false, dF = false, m = false, h = false,
       k = false, q = false;
  bool no_torque = false;               ///< on there being none
  std::vector<int> constants;           ///< of the lesson, by their numbers
  std::vector<std::string> names = {};  ///< of all of these

  void operator|=(const Dependence& other) {
    for (bool Dependence::*part : kParts) this->*part = this->*part || other.*part;
    for (const int constant : other.constants)
      if (std::find(constants.begin(), constants.end(), constant) == constants.end())
        constants.push_back(constant);
    if (names.empty()) names = other.names;
  }
  static const std::array<bool Dependence::*, 19> kParts;
};
const std::array<bool Dependence::*, 19> Dependence::kParts = {
    &Dependence::I, &Dependence::J,  &Dependence::w,   &Dependence::dw, &Dependence::ddw,
    &Dependence::N, &Dependence::dN, &Dependence::v,   &Dependence::dv, &Dependence::ddv,
    &Dependence::A, &Dependence::dA, &Dependence::ddA, &Dependence::F,  &Dependence::dF,
    &Dependence::m, &Dependence::h,  &Dependence::k,   &Dependence::q};

Dependence of_quantity(Quantity quantity) {
  using S = Quantity;
  Dependence d;
  switch (quantity) {
    case S::I1:
    case S::I2:
    case S::I3:
      d.I = true;
      break;
    case S::T:
    case S::L:
      d.I = d.w = true;
      break;
    case S::w1:
    case S::w2:
    case S::w3:
    case S::omega:
      d.w = true;
      break;
    case S::dw1:
    case S::dw2:
    case S::dw3:
      d.dw = true;
      break;
    case S::N1:
    case S::N2:
    case S::N3:
    case S::N:
      d.N = true;
      break;
    case S::m:
      d.m = true;
      break;
    case S::h:
      d.h = true;
      break;
    case S::k:
      d.k = true;
      break;
    case S::p:
      d.m = d.v = true;
      break;
    case S::v:
      d.v = true;
      break;
    case S::F:
      d.F = true;
      break;
    case S::A:
      d.A = true;
      break;
    case S::e1:
    case S::e2:
    case S::e3:
      break;
    case S::ex:
    case S::ey:
    case S::ez:
      d.q = true;
      break;
    case S::Jxx:
    case S::Jxy:
    case S::Jxz:
    case S::Jyy:
    case S::Jyz:
    case S::Jzz:
      d.J = true;
      break;
  }
  return d;
}

/// A rate brings in the rates of what there is, and for a vector the turning of the axes.
void differentiate(Dependence& d, bool vector) {
  d.ddw = d.ddw || d.dw;
  d.ddv = d.ddv || d.dv;
  d.ddA = d.ddA || d.dA;
  d.dw = d.dw || d.w;
  d.dv = d.dv || d.v;
  d.dA = d.dA || d.A;
  d.dN = d.dN || d.N;
  d.dF = d.dF || d.F;
  d.w = d.w || vector;
}

Dependence dependence_of(const Expression& expression) {
  std::vector<Dependence> all;
  for (const ExpressionNode& node : expression.nodes) {
    Dependence d;
    if (node.operation == Operation::quantity) d = of_quantity(node.quantity);
    if (node.operation == Operation::constant) d.constants = {node.integer};
    if (node.operation == Operation::inertia) d.I = true;
    if (node.operation == Operation::apply || node.operation == Operation::trace) d.J = true;
    if (node.a >= 0) d |= all[static_cast<std::size_t>(node.a)];
    if (node.b >= 0) d |= all[static_cast<std::size_t>(node.b)];
    if (node.operation == Operation::ddt || node.operation == Operation::star)
      differentiate(d, node.type == ExpressionType::vector);
    all.push_back(std::move(d));
  }
  if (expression.constants) all.back().names = *expression.constants;
  return std::move(all.back());
}

/// What is given brings in what it is set to.
void add_given(Dependence& d, const Given& given) {
  for (auto setting = given.settings.rbegin(); setting != given.settings.rend(); ++setting) {
    const Dependence set = of_quantity(setting->quantity);
    const bool sets_rate = (set.N && d.dN) || (set.F && d.dF);
    if (!sets_rate && !(set.I && d.I) && !(set.w && d.w) && !(set.N && d.N) && !(set.F && d.F)) continue;
    Dependence value = dependence_of(setting->value);
    if (sets_rate) differentiate(value, setting->value.type() == ExpressionType::vector);
    d |= value;
  }
}

Dependence dependence_of(const Equality& equality, Assumption assumption, const Given& given) {
  Dependence d = dependence_of(equality.left);
  d |= dependence_of(equality.right);
  if (assumption != Assumption::identity) {
    if (d.ddw) d.dw = d.dN = true;
    if (d.ddv) d.dF = d.m = true;
    if (d.dw) d.I = d.w = d.N = true;
    if (d.dv) d.F = d.m = true;
    d.dw = d.ddw = d.dv = d.ddv = false;
    if (assumption == Assumption::free) d.no_torque = d.N || d.dN, d.N = d.dN = false;
  }
  for (const Bound& bound : given.bounds) {
    d |= dependence_of(bound.sides.left);
    d |= dependence_of(bound.sides.right);
  }
  add_given(d, given);
  if (given.sets(Quantity::N)) d.dN = false;
  if (given.sets(Quantity::F)) d.dF = false;
  return d;
}

/// "2ε", of what is small; else "2".
std::string text_of(const SizedNumber& number, bool is_small) {
  const double value = number.value;
  if (!is_small || value == 0) return number_text(value);
  return (value == 1 ? "" : value == -1 ? "−" : number_text(value)) + "ε";
}

using AreSmall = std::array<bool, 3>;
template <class Numbers>
std::string list_text(const Numbers& numbers, const AreSmall& are_small = {}) {
  std::string text;
  std::size_t i = 0;
  for (const SizedNumber number : numbers)
    text += (text.empty() ? "(" : ", ") + text_of(number, i < are_small.size() && are_small[i]), ++i;
  return text + ")";
}

std::array<SizedNumber, 3> rates_of(const Triple<SizedNumber>& x) {
  return {x[0].rate, x[1].rate, x[2].rate};
}

/// The quantities of a state: as plain text, and with TeX between dollars.
struct StateText {
  std::string plain, tex;

  void add(const std::string& name, const std::string& tex_name, const std::string& value) {
    if (!plain.empty()) plain += ", ", tex += ", ";
    plain += name + " = " + value;
    tex += '$' + tex_name + " = " + numbers_as_tex(value) + '$';
  }
};

/// Behind the whole components of a quaternion what makes its length 1: "/\\sqrt{2}".
std::string over_its_length(const std::array<SizedNumber, 4>& q) {
  double square = 0;
  for (const SizedNumber& component : q) square += component.value * component.value;
  const double length = std::round(std::sqrt(square));
  if (length * length != square) return "/\\sqrt{" + number_text(square) + '}';
  return length == 1 ? "" : '/' + number_text(length);
}

StateText text_of(const StateNumbers<SizedNumber>& s, const ClaimState<SizedNumber>& state,
                  const Dependence& d, const SmallQuantities& small) {
  StateText text;
  const auto add = [&text](bool wanted, const char* name, const char* tex, const auto& numbers,
                           const AreSmall& are_small = {}) {
    if (wanted) text.add(name, tex, list_text(numbers, are_small));
  };
  const auto small_ones = [&small](Quantity first, Quantity second, Quantity third) {
    return AreSmall{small.has(first), small.has(second), small.has(third)};
  };
  add(d.I, "I", "(I_1, I_2, I_3)", s.I);
  add(d.w, "ω", "\\vec\\omega", s.w, small_ones(Quantity::w1, Quantity::w2, Quantity::w3));
  add(d.dw, "ω̇", "\\dot{\\vec\\omega}", s.dw);
  add(d.ddw, "ω̈", "\\ddot{\\vec\\omega}", s.ddw);
  add(d.N, "N", "\\vec N", s.N_B, small_ones(Quantity::N1, Quantity::N2, Quantity::N3));
  add(d.dN, "dN/dt", "d\\vec N/dt", rates_of(state.N_B));
  if (d.no_torque) text.add("N", "\\vec N", "0");
  add(d.A, "A", "\\vec A", s.A_S);
  add(d.dA, "dA/dt", "d\\vec A/dt", s.dA_S);
  add(d.ddA, "d²A/dt²", "d^2\\vec A/dt^2", s.ddA_S);
  add(d.v, "v", "\\vec v", s.v_S);
  add(d.dv, "dv/dt", "d\\vec v/dt", s.dv_S);
  add(d.ddv, "d²v/dt²", "d^2\\vec v/dt^2", s.ddv_S);
  add(d.F, "F", "\\vec F", s.F_S);
  add(d.dF, "dF/dt", "d\\vec F/dt", rates_of(state.F_S));
  const auto add_number = [&text](bool wanted, const std::string& name, const std::string& tex,
                                  const SizedNumber& number, bool is_small = false) {
    if (wanted) text.add(name, tex, text_of(number, is_small));
  };
  add_number(d.m, "m", "m", s.m);
  add_number(d.h, "h", "h", s.h, small.has(Quantity::h));
  add_number(d.k, "k", "k", s.k, small.has(Quantity::k));
  for (const int constant : d.constants) {
    const auto index = static_cast<std::size_t>(constant);
    if (index >= d.names.size()) continue;
    add_number(true, d.names[index], name_in_tex(d.names[index]), s.constants[index]);
  }
  add(d.J, "J (xx, xy, xz, yy, yz, zz)", "(J_{xx}, J_{xy}, J_{xz}, J_{yy}, J_{yz}, J_{zz})", s.J);
  if (d.q) {
    text.add("attitude", "\\text{attitude}\\ q", list_text(s.q));
    text.tex.insert(text.tex.size() - 1, over_its_length(s.q));
  }
  return text.plain.empty() ? StateText{"any state", "any state"} : text;
}

CounterBody body_of(const StateNumbers<SizedNumber>& s, const Dependence& d) {
  CounterBody body;
  for (std::size_t i = 0; i < 3; ++i) {
    body.I[i] = s.I[i].value;
    body.w[i] = s.w[i].value;
    body.N[i] = d.N ? s.N_B[i].value : 0.0;
  }
  if (d.q)
    for (std::size_t i = 0; i < 4; ++i) body.q[i] = s.q[i].value;
  body.has_more = d.dw || d.ddw || d.dN || d.J || d.v || d.dv || d.ddv || d.A || d.dA || d.ddA || d.F ||
                  d.dF || d.m || d.h || d.k || !d.constants.empty();
  return body;
}

std::string value_text(const Triple<SizedNumber, 0>& value, ExpressionType type) {
  if (type == ExpressionType::zero) return "0";
  if (type == ExpressionType::scalar) return number_text(value[0].value.value);
  return list_text(std::array{value[0].value.value, value[1].value.value, value[2].value.value});
}

/// Calls `use` with every combination that makes a difference until it returns true.
template <class Use>
void for_each_state(const Dependence& d, const Use& use) {
  const auto firsts = [](const auto& all, bool vary) { return std::span(all).first(vary ? all.size() : 1); };
  const bool has_other = d.J || d.v || d.dv || d.ddv || d.A || d.dA || d.ddA || d.F || d.dF || d.m || d.h ||
                         d.k || !d.constants.empty();
  for (const Whole3& I : firsts(kMoments, d.I))
    for (const OtherQuantities& c : firsts(kOtherQuantities, has_other))
      for (const auto& q : firsts(kAttitudes, d.q))
        for (const Whole3& w : firsts(kSpins, d.w))
          for (const Whole3& N : firsts(kTorques, d.N))
            for (std::size_t i = 0; i < (d.dw || d.ddw || d.dN ? kRates.size() : 1); ++i) {
              const Whole3 &ddw = kRates[3 * i % kRates.size()], &dN = kRates[2 * i % kRates.size()];
              if (use(SmallNumbers{I, w, kRates[i], ddw, N, dN, c, q,
                                   static_cast<std::size_t>(&c - kOtherQuantities.data())}))
                return;
            }
}

/// So many states are tried where sides are compared by their order: a sign may change anywhere.
constexpr int kMixedStates = 500;

/// Small whole numbers of either sign, all of them at once.
SmallNumbers mixed_numbers(std::mt19937_64& random) {
  const auto below = [&random](Whole count) {
    return static_cast<Whole>(random() % static_cast<std::uint64_t>(count));
  };
  const auto three = [&below] { return Whole3{below(11) - 5, below(11) - 5, below(11) - 5}; };
  SmallNumbers small{};
  const Whole a = below(5), b = 1 + below(5), c = below(5);
  small.I = {b + c, a + c + (a + c == 0 ? 1 : 0), a + b};  // possible but for this 1; that is looked at
  for (Whole3* vector : {&small.w, &small.dw, &small.ddw, &small.N, &small.dN}) *vector = three();
  const auto place = static_cast<std::size_t>(below(static_cast<Whole>(kOtherQuantities.size())));
  small.other = kOtherQuantities[place];
  for (Whole3 OtherQuantities::*vector :
       {&OtherQuantities::v, &OtherQuantities::dv, &OtherQuantities::ddv, &OtherQuantities::A,
        &OtherQuantities::dA, &OtherQuantities::ddA, &OtherQuantities::F, &OtherQuantities::dF})
    small.other.*vector = three();
  small.other.h = below(11) - 5;
  small.other.k = below(11) - 5;
  small.other.m = 1 + below(5);
  small.q = {1 + below(3), below(7) - 3, below(7) - 3, below(7) - 3};
  small.first_constant = static_cast<std::size_t>(below(static_cast<Whole>(kConstants.size())));
  return small;
}

/// The same with numbers of very different sizes: for bodies as flat and as long as inequalities ask for.
SmallNumbers uneven_numbers(std::mt19937_64& random) {
  SmallNumbers small = mixed_numbers(random);
  const auto power = [&random](Whole number) {
    Whole scale = 1;
    for (auto n = random() % 5; n > 0; --n) scale *= 10;
    return number * scale;
  };
  const auto side = [&] { return power(static_cast<Whole>(random() % 4)); };
  const Whole a = side(), b = side() + 1, c = side();
  small.I = {b + c, a + c + (a + c == 0 ? 1 : 0), a + b};
  for (Whole3* vector : {&small.w, &small.N})
    for (Whole& component : *vector) component = power(component);
  small.other.h = power(small.other.h);
  small.other.k = power(small.other.k);
  return small;
}

/// Whole numbers so small that what is zero is far below this, and what is not far above.
constexpr double kZero = 1e-9;

bool fails(const Equality& equality, Relation relation, const ClaimState<FieldElement>& exact,
           const ClaimState<SizedNumber>& real) {
  const std::optional<Sides> sides = sides_of(equality, real);
  if (!sides) return false;
  const bool are_apart = sides->residual > kZero && agree(equality, exact) == std::optional(false);
  const bool is_less = sides->left[0].value.value < sides->right[0].value.value;
  const bool are_equal = sides->residual < kZero && agree(equality, exact) == std::optional(true);
  switch (relation) {
    case Relation::equal:
    case Relation::approximate:
      return are_apart;
    case Relation::less:
      return are_equal || (are_apart && !is_less);
    case Relation::less_or_equal:
      return are_apart && !is_less;
    case Relation::greater:
      return are_equal || (are_apart && is_less);
    case Relation::greater_or_equal:
      return are_apart && is_less;
  }
  return false;
}

bool holds(const Equality& equality, const ClaimState<FieldElement>& exact,
           const ClaimState<SizedNumber>& real) {
  const std::optional<Sides> sides = sides_of(equality, real);
  return sides && sides->residual < kZero && agree(equality, exact) == std::optional(true);
}

/// Whether all inequalities hold.
bool are_within(const Given& given, const ClaimState<SizedNumber>& state) {
  return std::all_of(given.bounds.begin(), given.bounds.end(),
                     [&](const Bound& bound) { return holds_in(bound, state, kZero, false); });
}

bool is_finite(const StateNumbers<SizedNumber>& numbers) {
  const auto all_finite = [](const std::array<SizedNumber, 3>& three) {
    return std::all_of(three.begin(), three.end(),
                       [](const SizedNumber& x) { return std::isfinite(x.value); });
  };
  return all_finite(numbers.w) && all_finite(numbers.N_B) && all_finite(numbers.F_S);
}

/// Of states times nodes; what is longer is tried in fewer states.
constexpr std::size_t kMostWork = 1'000'000;

std::size_t size_of(const Equality& equality) {
  return equality.left.nodes.size() + equality.right.nodes.size();
}

/// Of the inequalities that are given, which are looked at in each state.
std::size_t size_of(const std::vector<Bound>& bounds) {
  std::size_t nodes = 0;
  for (const Bound& bound : bounds) nodes += size_of(bound.sides);
  return nodes;
}

}  // namespace

std::string number_text(double value) {
  std::array<char, 32> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value == 0 ? 0.0 : value,  // no −0
                                 std::chars_format::general, 6);
  return text.front() == '-' ? "−" + std::string(text.data() + 1, end.ptr)
                             : std::string(text.data(), end.ptr);
}

bool is_possible(const Given& given) {
  constexpr int kMostDoublings = 140;
  const Whole3 turning{1, 2, 3}, torque{-1, 2, 1}, rate{1, 2, 3};
  for (const Whole3& I : kMoments)
    for (std::size_t i = 0; i < kOtherQuantities.size(); ++i)
      for (int doublings = -kMostDoublings; doublings <= kMostDoublings; ++doublings) {
        auto numbers = as<SizedNumber>(
            {I, turning, rate, rate, torque, rate, kOtherQuantities[i], kAttitudes.back(), i});
        for (SizedNumber& moment : numbers.I) moment = std::ldexp(moment.value, doublings);
        const auto replaced = with_given(numbers, given);
        if (replaced && is_possible_body(replaced->I) && is_finite(*replaced)) return true;
      }
  return false;
}

std::optional<Counterexample> first_small_state(const Equality& equality, const Equality* premise,
                                                Assumption assumption, const Given& given, Relation relation,
                                                int* tried) {
  Dependence depends = dependence_of(equality, assumption, given);
  if (premise) depends |= dependence_of(*premise, assumption, given);
  std::optional<Counterexample> found;
  const std::size_t work = size_of(equality) + (premise ? size_of(*premise) : 0) + size_of(given.bounds);
  std::size_t work_left = kMostWork;
  const auto look_at = [&](const SmallNumbers& numbers) {
    if (work_left < work) return true;
    work_left -= work;
    const auto exact_numbers = with_given(as<FieldElement>(numbers), given);
    const auto real_numbers = with_given(as<SizedNumber>(numbers), given);
    if (!exact_numbers || !real_numbers || !is_possible_body(real_numbers->I)) return false;
    const auto exact = state_of(*exact_numbers, assumption, given);
    const auto real = state_of(*real_numbers, assumption, given);
    if (!exact || !real || !are_within(given, *real) || (premise && !holds(*premise, *exact, *real)))
      return false;
    if (tried != nullptr && sides_of(equality, *real)) ++*tried;
    if (!fails(equality, relation, *exact, *real)) return false;
    const Sides sides = *sides_of(equality, *real);
    StateText state = text_of(*real_numbers, *real, depends, {});
    found = Counterexample{std::move(state.plain), value_text(sides.left, equality.left.type()),
                           value_text(sides.right, equality.right.type()), body_of(*real_numbers, depends),
                           std::move(state.tex)};
    return true;
  };
  for_each_state(depends, look_at);
  // Where inequalities are given, the states above may all be beyond them; and a premise may hold in none.
  if (!is_order(relation) && given.bounds.empty() && !premise) return found;
  std::mt19937_64 random(1);
  for (int n = 0; n < kMixedStates && !found; ++n) look_at(mixed_numbers(random));
  for (int n = 0; n < kMixedStates && !found && !given.bounds.empty(); ++n) look_at(uneven_numbers(random));
  return found;
}

namespace {

/// "ε²"; nothing for the power 0. Fonts of pages have no other raised digits.
std::string power_of_epsilon(int exponent) {
  if (exponent == 0) return "";
  if (exponent == 1) return "ε";
  if (exponent == 2 || exponent == 3) return exponent == 2 ? "ε²" : "ε³";
  return "ε^" + std::to_string(exponent);
}

double value_of(const Ratio& ratio) {
  return static_cast<double>(ratio.above()) / static_cast<double>(ratio.below());
}

/// The terms up to ε^last: "2 − 0.5ε".
std::string text_of(const PowerSeries<Ratio>& series, int last) {
  std::string text;
  for (int exponent = series.first(); exponent <= last && exponent < series.end(); ++exponent) {
    const Ratio c = series.coefficient(exponent);
    if (c.is_zero()) continue;
    const std::string power = power_of_epsilon(exponent);
    const double size = std::abs(value_of(c));
    const std::string term = size == 1 && !power.empty() ? power : number_text(size) + power;
    text += text.empty() ? (c.sign() < 0 ? "−" : "") + term : (c.sign() < 0 ? " − " : " + ") + term;
  }
  return text.empty() ? "0" : text;
}

std::string text_of(const Expansion<Ratio>& side, ExpressionType type, int last) {
  if (type == ExpressionType::zero) return "0";
  if (type == ExpressionType::scalar) return text_of(side[0], last);
  return '(' + text_of(side[0], last) + ", " + text_of(side[1], last) + ", " + text_of(side[2], last) + ')';
}

}  // namespace

std::optional<Counterexample> first_small_expansion(const Equality& equality, Assumption assumption,
                                                    const Given& given, int& differ_at) {
  const Dependence depends = dependence_of(equality, assumption, given);
  std::optional<Counterexample> found;
  // An expansion costs as much as some thirty states.
  constexpr std::size_t kCost = 30;
  std::size_t work_left = kMostWork / kCost;
  const std::size_t work = size_of(equality) + size_of(given.bounds) / kCost;
  const auto look_at = [&](const SmallNumbers& numbers) {
    if (work_left < work) return true;
    work_left -= work;
    const auto real_numbers = with_given(as<SizedNumber>(numbers), given);
    if (!real_numbers || !is_possible_body(real_numbers->I)) return false;
    const auto real = state_of(*real_numbers, assumption, given);
    if (!real || !are_within(given, *real)) return false;
    const auto sides = expanded_sides(equality, as<FieldElement>(numbers), assumption, given);
    if (!sides || !compare_to_order(*sides, given.small.order).differ_at) return false;
    try {
      const auto exact = expanded_sides(equality, as<Ratio>(numbers), assumption, given);
      const auto at = exact ? compare_to_order(*exact, given.small.order).differ_at : std::nullopt;
      if (!at) return false;
      differ_at = *at;
      StateText state = text_of(*real_numbers, *real, depends, given.small);
      found = Counterexample{std::move(state.plain),
                             text_of(exact->left, equality.left.type(), *at),
                             text_of(exact->right, equality.right.type(), *at),
                             {},
                             std::move(state.tex)};
    } catch (const BeyondAlgebra&) {  // a number too large to be written
      return false;
    }
    return true;
  };
  for_each_state(depends, look_at);
  std::mt19937_64 random(1);
  for (int n = 0; n < kMixedStates && !found; ++n) look_at(mixed_numbers(random));
  return found;
}

bool bounds_are_possible(const Given& given) {
  if (given.bounds.empty()) return true;
  std::mt19937_64 random(1);
  constexpr int kTried = 4000;
  std::size_t work = size_of(given.bounds), work_left = kMostWork / 2;
  for (const Setting& setting : given.settings) work += 2 * setting.value.nodes.size();
  for (int n = 0; n < kTried && work_left >= work; ++n) {
    work_left -= work;
    auto numbers = as<SizedNumber>(n % 2 == 0 ? mixed_numbers(random) : uneven_numbers(random));
    if (n % 4 > 1) {  // as small and as large as numbers in SI units may be
      const auto scaled = [&random](auto&... all) {
        const int doublings = static_cast<int>(random() % 121) - 60;
        const auto scale = [doublings](SizedNumber& x) { x = std::ldexp(x.value, doublings); };
        (std::for_each(all.begin(), all.end(), scale), ...);
      };
      scaled(numbers.I);
      scaled(numbers.w);
      scaled(numbers.N_B);
      scaled(numbers.constants);
    }
    const auto replaced = with_given(numbers, given);
    if (!replaced || !is_possible_body(replaced->I) || !is_finite(*replaced)) continue;
    const auto state = state_of(numbers, Assumption::identity, given);
    if (state && std::all_of(given.bounds.begin(), given.bounds.end(),
                             [&](const Bound& bound) { return holds_in(bound, *state, kZero, true); }))
      return true;
  }
  return false;
}

std::string name_in_tex(std::string_view name) {
  std::string tex = "\\text{";
  for (const char c : name) tex += c == '_' ? std::string("\\_") : std::string(1, c);
  return tex + '}';
}

}  // namespace polhode
