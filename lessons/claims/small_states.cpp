// SPDX-License-Identifier: MIT
#include "lessons/claims/small_states.h"

#include <array>
#include <charconv>
#include <span>

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
constexpr std::array<Whole3, 5> kRates{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 2, 3}}};

/// What else there is; the eigenvalues of J lie between 6 and 12 (Gershgorin), so that it is possible.
struct Company {
  std::array<Whole, 6> J;
  Whole3 v, dv, A, dA, F;
  Whole m, h, k;
};
constexpr std::array<Company, 5> kCompany{
    {{{8, 1, 0, 9, 0, 10}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 0}, 2, 2, 3},
     {{8, 0, 1, 9, -1, 10}, {0, 1, 0}, {1, 0, 1}, {1, 0, 1}, {0, 0, 1}, {1, 1, 0}, 3, 3, 1},
     {{10, 1, 1, 9, 1, 8}, {1, 2, 3}, {3, 1, -1}, {2, -1, 3}, {2, -1, 1}, {1, 2, -1}, 2, 1, 2},
     {{8, 1, 0, 9, 0, 10}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 0}, {0, 0, 0}, 1, 1, 1},
     {{8, 1, 0, 9, 0, 10}, {0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 0}, {1, 0, 0}, 1, -1, 2}}};

struct SmallNumbers {
  Whole3 I, w, dw, N;
  Company company;
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
  copy(small.N, numbers.N_B);
  copy(small.company.J, numbers.J);
  copy(small.company.v, numbers.v_S);
  copy(small.company.dv, numbers.dv_S);
  copy(small.company.A, numbers.A_S);
  copy(small.company.dA, numbers.dA_S);
  copy(small.company.F, numbers.F_S);
  numbers.m = N(small.company.m);
  numbers.h = N(small.company.h);
  numbers.k = N(small.company.k);
  return numbers;
}

/// What the sides of an equality depend on, of what is free to choose.
struct Dependence {
  bool I = false, J = false, w = false, dw = false, N = false, v = false, dv = false, A = false, dA = false,
       F = false, m = false, h = false, k = false;
  bool no_torque = false;  ///< on there being none

  void operator|=(const Dependence& other) {
    for (bool Dependence::*part : kParts) this->*part = this->*part || other.*part;
  }
  static const std::array<bool Dependence::*, 13> kParts;
};
const std::array<bool Dependence::*, 13> Dependence::kParts = {
    &Dependence::I, &Dependence::J,  &Dependence::w, &Dependence::dw, &Dependence::N,
    &Dependence::v, &Dependence::dv, &Dependence::A, &Dependence::dA, &Dependence::F,
    &Dependence::m, &Dependence::h,  &Dependence::k};

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
  d.dw = d.dw || d.w;
  d.dv = d.dv || d.v;
  d.dA = d.dA || d.A;
  d.w = d.w || vector;
}

Dependence dependence_of(const Expression& expression) {
  std::vector<Dependence> all;
  for (const ExpressionNode& node : expression.nodes) {
    Dependence d;
    if (node.operation == Operation::quantity) d = of_quantity(node.quantity);
    if (node.operation == Operation::inertia) d.I = true;
    if (node.operation == Operation::apply || node.operation == Operation::trace) d.J = true;
    if (node.a >= 0) d |= all[static_cast<std::size_t>(node.a)];
    if (node.b >= 0) d |= all[static_cast<std::size_t>(node.b)];
    if (node.operation == Operation::ddt || node.operation == Operation::star)
      differentiate(d, node.type == ExpressionType::vector);
    all.push_back(d);
  }
  return all.back();
}

Dependence dependence_of(const Equality& equality, Assumption assumption) {
  Dependence d = dependence_of(equality.left);
  d |= dependence_of(equality.right);
  if (assumption == Assumption::identity) return d;
  if (d.dw) d.I = d.w = d.N = true;
  if (d.dv) d.F = d.m = true;
  d.dw = d.dv = false;
  if (assumption == Assumption::free) d.no_torque = d.N, d.N = false;
  return d;
}

template <class Numbers>
std::string list_text(const Numbers& numbers) {
  std::string text;
  for (const auto& number : numbers)
    text += (text.empty() ? "(" : ", ") + number_text(static_cast<double>(number));
  return text + ")";
}

std::string words_of(const SmallNumbers& s, const Dependence& d) {
  std::string text;
  const auto add = [&text](bool wanted, const char* name, const auto& numbers) {
    if (wanted) text += (text.empty() ? "" : ", ") + std::string(name) + " = " + list_text(numbers);
  };
  add(d.I, "I", s.I);
  add(d.w, "ω", s.w);
  add(d.dw, "ω̇", s.dw);
  add(d.N, "N", s.N);
  if (d.no_torque) text += ", N = 0";
  add(d.A, "A", s.company.A);
  add(d.dA, "dA/dt", s.company.dA);
  add(d.v, "v", s.company.v);
  add(d.dv, "dv/dt", s.company.dv);
  add(d.F, "F", s.company.F);
  const auto add_number = [&text](bool wanted, const char* name, Whole number) {
    if (wanted) text += (text.empty() ? "" : ", ") + std::string(name) + " = " + std::to_string(number);
  };
  add_number(d.m, "m", s.company.m);
  add_number(d.h, "h", s.company.h);
  add_number(d.k, "k", s.company.k);
  add(d.J, "J (xx, xy, xz, yy, yz, zz)", s.company.J);
  return text.empty() ? "any state" : text;
}

std::string value_text(const Triple<SizedNumber>& value, ExpressionType type) {
  if (type == ExpressionType::zero) return "0";
  if (type == ExpressionType::scalar) return number_text(value[0].value.value);
  return list_text(std::array{value[0].value.value, value[1].value.value, value[2].value.value});
}

/// Calls `use` with every combination that makes a difference until it returns true.
template <class Use>
void for_each_state(const Dependence& d, const Use& use) {
  const auto firsts = [](const auto& all, bool vary) { return std::span(all).first(vary ? all.size() : 1); };
  const bool company = d.J || d.v || d.dv || d.A || d.dA || d.F || d.m || d.h || d.k;
  for (const Whole3& I : firsts(kMoments, d.I))
    for (const Company& c : firsts(kCompany, company))
      for (const Whole3& w : firsts(kSpins, d.w))
        for (const Whole3& N : firsts(kTorques, d.N))
          for (const Whole3& dw : firsts(kRates, d.dw))
            if (use(SmallNumbers{I, w, dw, N, c})) return;
}

/// Whole numbers so small that what is zero is far below this, and what is not far above.
constexpr double kZero = 1e-9;

bool fails(const Equality& equality, const ClaimState<FieldElement>& exact,
           const ClaimState<SizedNumber>& real) {
  const std::optional<Sides> sides = sides_of(equality, real);
  return sides && sides->residual > kZero && agree(equality, exact) == std::optional(false);
}

bool holds(const Equality& equality, const ClaimState<FieldElement>& exact,
           const ClaimState<SizedNumber>& real) {
  const std::optional<Sides> sides = sides_of(equality, real);
  return sides && sides->residual < kZero && agree(equality, exact) == std::optional(true);
}

/// Of states times nodes; what is longer is tried in fewer states.
constexpr std::size_t kMostWork = 1'000'000;

std::size_t size_of(const Equality& equality) {
  return equality.left.nodes.size() + equality.right.nodes.size();
}

}  // namespace

std::string number_text(double value) {
  std::array<char, 32> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value == 0 ? 0.0 : value,  // no −0
                                 std::chars_format::general, 6);
  return text.front() == '-' ? "−" + std::string(text.data() + 1, end.ptr)
                             : std::string(text.data(), end.ptr);
}

std::optional<Counterexample> first_small_state(const Equality& equality, const Equality* premise,
                                                Assumption assumption) {
  Dependence depends = dependence_of(equality, assumption);
  if (premise) depends |= dependence_of(*premise, assumption);
  std::optional<Counterexample> found;
  const std::size_t work = size_of(equality) + (premise ? size_of(*premise) : 0);
  std::size_t work_left = kMostWork;
  for_each_state(depends, [&](const SmallNumbers& numbers) {
    if (work_left < work) return true;
    work_left -= work;
    const auto exact = state_of(as<FieldElement>(numbers), assumption);
    const auto real = state_of(as<SizedNumber>(numbers), assumption);
    if (!fails(equality, exact, real) || (premise && !holds(*premise, exact, real))) return false;
    const Sides sides = *sides_of(equality, real);
    found = Counterexample{words_of(numbers, depends), value_text(sides.left, equality.left.type()),
                           value_text(sides.right, equality.right.type())};
    return true;
  });
  return found;
}

}  // namespace polhode
