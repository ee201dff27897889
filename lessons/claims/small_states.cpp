// SPDX-License-Identifier: MIT
#include "lessons/claims/small_states.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
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
constexpr std::array<Whole3, 5> kRates{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 2, 3}}};

/// Attitudes, of any length: body to space.
constexpr std::array<std::array<Whole, 4>, 5> kAttitudes{
    {{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 1, 1, 1}, {2, 1, 0, 0}, {3, 1, -1, 2}}};
/// The constants of a lesson have these values, one after the other, from some place on.
constexpr std::array<Whole, 7> kConstants{2, 3, 1, 5, -1, 4, 7};

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
  copy(small.q, numbers.q);
  for (std::size_t i = 0; i < kMaxConstants; ++i)
    numbers.constants[i] = N(kConstants[(small.first_constant + i) % kConstants.size()]);
  return numbers;
}

/// What the sides of an equality depend on, of what is free to choose.
struct Dependence {
  bool I = false, J = false, w = false, dw = false, N = false, v = false, dv = false, A = false, dA = false,
       F = false, m = false, h = false, k = false, q = false;
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
  static const std::array<bool Dependence::*, 14> kParts;
};
const std::array<bool Dependence::*, 14> Dependence::kParts = {
    &Dependence::I, &Dependence::J,  &Dependence::w, &Dependence::dw, &Dependence::N,
    &Dependence::v, &Dependence::dv, &Dependence::A, &Dependence::dA, &Dependence::F,
    &Dependence::m, &Dependence::h,  &Dependence::k, &Dependence::q};

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
    if ((set.I && d.I) || (set.w && d.w) || (set.N && d.N) || (set.F && d.F))
      d |= dependence_of(setting->value);
  }
}

Dependence dependence_of(const Equality& equality, Assumption assumption, const Given& given) {
  Dependence d = dependence_of(equality.left);
  d |= dependence_of(equality.right);
  if (assumption != Assumption::identity) {
    if (d.dw) d.I = d.w = d.N = true;
    if (d.dv) d.F = d.m = true;
    d.dw = d.dv = false;
    if (assumption == Assumption::free) d.no_torque = d.N, d.N = false;
  }
  add_given(d, given);
  return d;
}

template <class Numbers>
std::string list_text(const Numbers& numbers) {
  std::string text;
  for (const SizedNumber number : numbers) text += (text.empty() ? "(" : ", ") + number_text(number.value);
  return text + ")";
}

std::string words_of(const StateNumbers<SizedNumber>& s, const Dependence& d) {
  std::string text;
  const auto add = [&text](bool wanted, const char* name, const auto& numbers) {
    if (wanted) text += (text.empty() ? "" : ", ") + std::string(name) + " = " + list_text(numbers);
  };
  add(d.I, "I", s.I);
  add(d.w, "ω", s.w);
  add(d.dw, "ω̇", s.dw);
  add(d.N, "N", s.N_B);
  if (d.no_torque) text += ", N = 0";
  add(d.A, "A", s.A_S);
  add(d.dA, "dA/dt", s.dA_S);
  add(d.v, "v", s.v_S);
  add(d.dv, "dv/dt", s.dv_S);
  add(d.F, "F", s.F_S);
  const auto add_number = [&text](bool wanted, const std::string& name, const SizedNumber& number) {
    if (wanted) text += (text.empty() ? "" : ", ") + name + " = " + number_text(number.value);
  };
  add_number(d.m, "m", s.m);
  add_number(d.h, "h", s.h);
  add_number(d.k, "k", s.k);
  for (const int constant : d.constants) {
    const auto index = static_cast<std::size_t>(constant);
    add_number(index < d.names.size(), d.names[index], s.constants[index]);
  }
  add(d.J, "J (xx, xy, xz, yy, yz, zz)", s.J);
  add(d.q, "attitude", s.q);
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
  const bool company = d.J || d.v || d.dv || d.A || d.dA || d.F || d.m || d.h || d.k || !d.constants.empty();
  for (const Whole3& I : firsts(kMoments, d.I))
    for (const Company& c : firsts(kCompany, company))
      for (const auto& q : firsts(kAttitudes, d.q))
        for (const Whole3& w : firsts(kSpins, d.w))
          for (const Whole3& N : firsts(kTorques, d.N))
            for (const Whole3& dw : firsts(kRates, d.dw))
              if (use(SmallNumbers{I, w, dw, N, c, q, static_cast<std::size_t>(&c - kCompany.data())}))
                return;
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
    for (std::size_t i = 0; i < kCompany.size(); ++i)
      for (int doublings = -kMostDoublings; doublings <= kMostDoublings; ++doublings) {
        auto numbers = as<SizedNumber>({I, turning, rate, torque, kCompany[i], kAttitudes.back(), i});
        for (SizedNumber& moment : numbers.I) moment = std::ldexp(moment.value, doublings);
        const auto replaced = with_given(numbers, given);
        if (replaced && is_possible_body(replaced->I) && is_finite(*replaced)) return true;
      }
  return false;
}

std::optional<Counterexample> first_small_state(const Equality& equality, const Equality* premise,
                                                Assumption assumption, const Given& given) {
  Dependence depends = dependence_of(equality, assumption, given);
  if (premise) depends |= dependence_of(*premise, assumption, given);
  std::optional<Counterexample> found;
  const std::size_t work = size_of(equality) + (premise ? size_of(*premise) : 0);
  std::size_t work_left = kMostWork;
  for_each_state(depends, [&](const SmallNumbers& numbers) {
    if (work_left < work) return true;
    work_left -= work;
    const auto exact_numbers = with_given(as<FieldElement>(numbers), given);
    const auto real_numbers = with_given(as<SizedNumber>(numbers), given);
    if (!exact_numbers || !real_numbers || !is_possible_body(real_numbers->I)) return false;
    const auto exact = state_of(*exact_numbers, assumption);
    const auto real = state_of(*real_numbers, assumption);
    if (!fails(equality, exact, real) || (premise && !holds(*premise, exact, real))) return false;
    const Sides sides = *sides_of(equality, real);
    found = Counterexample{words_of(*real_numbers, depends), value_text(sides.left, equality.left.type()),
                           value_text(sides.right, equality.right.type())};
    return true;
  });
  return found;
}

}  // namespace polhode
