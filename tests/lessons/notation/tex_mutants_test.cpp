// SPDX-License-Identifier: MIT
// Slips of the pen in printed equations: what is read must be what is printed, and false must stay false.
//
// Equations are made here as trees of their own, printed as TeX, and evaluated by formulas on the body axes
// that share nothing with the reader, its language or its prover. So the meaning of a mutant is known however
// it is read.
#include "lessons/claims/proof/proof.h"
#include "lessons/notation/tex_equation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <set>

namespace polhode {
namespace {

enum class Op {
  number,
  moment,
  spin,
  spin_rate,
  torque,
  component,
  energy,
  mass,
  vector,
  axis,
  inertia,
  add,
  subtract,
  negative,
  times,
  over,
  square,
  dot,
  cross,
  length2,
  ddt,
  star
};

struct Term;
using T = std::shared_ptr<const Term>;
struct Term {
  Op op;
  int index = 0;  ///< a number, an axis, or a vector's letter
  T a, b;
};

T make(Op op, int index, T a = nullptr, T b = nullptr) {
  return std::make_shared<const Term>(Term{op, index, std::move(a), std::move(b)});
}
T operator+(T a, T b) { return make(Op::add, 0, a, b); }
T operator-(T a, T b) { return make(Op::subtract, 0, a, b); }
T operator-(T a) { return make(Op::negative, 0, a); }
T operator*(T a, T b) { return make(Op::times, 0, a, b); }
T operator/(T a, T b) { return make(Op::over, 0, a, b); }
T n(int value) { return make(Op::number, value); }
T I(int i) { return make(Op::moment, i); }
T w(int i) { return make(Op::spin, i); }
T dw(int i) { return make(Op::spin_rate, i); }
T N(int i) { return make(Op::torque, i); }
T A(int i) { return make(Op::component, i); }
T e(int i) { return make(Op::axis, i); }
T sq(T a) { return make(Op::square, 0, a); }
T dot(T a, T b) { return make(Op::dot, 0, a, b); }
T cross(T a, T b) { return make(Op::cross, 0, a, b); }
T In(T a) { return make(Op::inertia, 0, a); }
T ddt(T a) { return make(Op::ddt, 0, a); }
T star(T a) { return make(Op::star, 0, a); }
T len2(T a) { return make(Op::length2, 0, a); }
enum Letter { kOmega, kL, kN, kP, kV, kA };
const T om = make(Op::vector, kOmega), L = make(Op::vector, kL), Nv = make(Op::vector, kN),
        p = make(Op::vector, kP), v = make(Op::vector, kV), Av = make(Op::vector, kA);
const T energy = make(Op::energy, 0), m = make(Op::mass, 0), zero = n(0);

// --- printed ---------------------------------------------------------------------------------------------

bool is_sum(const T& t) { return t->op == Op::add || t->op == Op::subtract || t->op == Op::negative; }
bool is_product(const T& t) {
  return t->op == Op::times || t->op == Op::dot || t->op == Op::cross || t->op == Op::inertia;
}
std::string tex(const T& t);
std::string in_brackets(const T& t, bool brackets) {
  return brackets ? "\\left(" + tex(t) + "\\right)" : tex(t);
}
std::string atom(const T& t) { return in_brackets(t, is_sum(t) || is_product(t)); }
std::string factor(const T& t) {
  return in_brackets(t, is_sum(t) || t->op == Op::dot || t->op == Op::cross || t->op == Op::inertia);
}

std::string rate(const std::string& d, const T& of) {
  const bool simple = !is_sum(of) && !is_product(of) && of->op != Op::over && of->op != Op::number;
  return simple ? "\\frac{" + d + tex(of) + "}{dt}" : "\\frac{" + d + "}{dt}\\left(" + tex(of) + "\\right)";
}

std::string tex(const T& t) {
  const std::string i = std::to_string(t->index);
  switch (t->op) {
    case Op::number:
      return i;
    case Op::moment:
      return "I_" + i;
    case Op::spin:
      return "\\omega_" + i;
    case Op::spin_rate:
      return "\\dot\\omega_" + i;
    case Op::torque:
      return "N_" + i;
    case Op::component:
      return "A_{" + i + "}";
    case Op::energy:
      return "T";
    case Op::mass:
      return "m";
    case Op::vector:
      return std::array<std::string, 6>{
          "\\vec\\omega", "\\vec L", "\\vec N", "\\vec p", "\\vec v", "\\vec A"}[static_cast<std::size_t>(
          t->index)];
    case Op::axis:
      return "\\hat e_" + i;
    case Op::inertia:
      return "\\mathbf I\\cdot " + atom(t->a);
    case Op::add:
      return tex(t->a) + " + " + in_brackets(t->b, t->b->op == Op::negative);
    case Op::subtract:
      return tex(t->a) + " - " + in_brackets(t->b, is_sum(t->b));
    case Op::negative:
      return "-" + in_brackets(t->a, is_sum(t->a));
    case Op::times:
      return (t->a->op == Op::times ? tex(t->a) : factor(t->a)) +
             (t->b->op == Op::number ? "\\cdot " : "\\,") + factor(t->b);
    case Op::over:
      return "\\frac{" + tex(t->a) + "}{" + tex(t->b) + "}";
    case Op::square:
      return atom(t->a) + "^2";
    case Op::dot:
      return atom(t->a) + "\\cdot " + atom(t->b);
    case Op::cross:
      return atom(t->a) + "\\times " + atom(t->b);
    case Op::length2:
      return "|" + tex(t->a) + "|^2";
    case Op::ddt:
      return rate("d", t->a);
    case Op::star:
      return rate("d^*", t->a);
  }
  return "";
}

// --- evaluated -------------------------------------------------------------------------------------------

/// Components on the body axes and their rates there; of a scalar the first.
struct Value {
  bool vector = false;
  std::array<double, 3> x{}, dx{};
};
struct Nonsense {};  ///< the types do not fit, or a rate is not known

struct World {
  StateNumbers<SizedNumber> numbers;  ///< the attitude is 1, so that space and body components coincide
  std::array<double, 3> I, w, dw, N, v, dv, A, dA_B;
  double m;
};

std::array<double, 3> crossed(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

World drawn(std::mt19937_64& random, LawsAssumed laws) {
  const auto draw = [&random] { return 0.25 + static_cast<double>(random() >> 11) / 9007199254740992.0 * 2; };
  World one;
  for (auto* x : {&one.I, &one.w, &one.dw, &one.N, &one.v, &one.dv, &one.A, &one.dA_B})
    for (double& component : *x) component = draw();
  one.m = draw();
  if (laws == LawsAssumed::free) one.N = {0, 0, 0};
  if (laws != LawsAssumed::identity) {
    const std::array<double, 3> l{one.I[0] * one.w[0], one.I[1] * one.w[1], one.I[2] * one.w[2]};
    const auto turn = crossed(one.w, l);
    for (std::size_t i = 0; i < 3; ++i) one.dw[i] = (one.N[i] - turn[i]) / one.I[i];
  }
  const auto turning = crossed(one.w, one.A);
  auto& numbers = one.numbers;
  for (std::size_t i = 0; i < 3; ++i) {
    numbers.I[i] = one.I[i];
    numbers.w[i] = one.w[i];
    numbers.dw[i] = one.dw[i];
    numbers.N_B[i] = one.N[i];
    numbers.v_S[i] = one.v[i];
    numbers.dv_S[i] = one.dv[i];
    numbers.F_S[i] = one.m * one.dv[i];
    numbers.A_S[i] = one.A[i];
    numbers.dA_S[i] = one.dA_B[i] + turning[i];
  }
  numbers.m = one.m;
  return one;
}

struct Evaluated {
  Value value;
  bool has_rate = true;
};

Evaluated evaluate(const T& t, const World& s) {
  const auto scalar = [](double x, double dx, bool has_rate = true) {
    return Evaluated{{false, {x, 0, 0}, {dx, 0, 0}}, has_rate};
  };
  const auto i = static_cast<std::size_t>(t->index - 1);
  Evaluated a, b;
  if (t->a) a = evaluate(t->a, s);
  if (t->b) b = evaluate(t->b, s);
  const bool is_zero_a = t->a && t->a->op == Op::number && t->a->index == 0;
  const bool is_zero_b = t->b && t->b->op == Op::number && t->b->index == 0;
  const auto want = [](bool good) {
    if (!good) throw Nonsense();
  };
  const bool rates = a.has_rate && b.has_rate;
  switch (t->op) {
    case Op::number:
      return scalar(t->index, 0);
    case Op::moment:
      return scalar(s.I[i], 0);
    case Op::spin:
      return scalar(s.w[i], s.dw[i]);
    case Op::spin_rate:
      return scalar(s.dw[i], 0, false);
    case Op::torque:
      return scalar(s.N[i], 0, false);
    case Op::component:
      return scalar(s.A[i], s.dA_B[i]);
    case Op::mass:
      return scalar(s.m, 0);
    case Op::energy: {
      double x = 0, dx = 0;
      for (std::size_t k = 0; k < 3; ++k) x += s.I[k] * s.w[k] * s.w[k] / 2, dx += s.I[k] * s.w[k] * s.dw[k];
      return scalar(x, dx);
    }
    case Op::axis: {
      Evaluated unit{{true, {}, {}}, true};
      unit.value.x[i] = 1;
      return unit;
    }
    case Op::vector: {
      Evaluated out{{true, {}, {}}, t->index != kN};
      const auto turning = crossed(s.w, s.v);
      for (std::size_t k = 0; k < 3; ++k) {
        const double factor = t->index == kL ? s.I[k] : t->index == kP ? s.m : 1;
        const bool moving = t->index == kP || t->index == kV;
        const double x = t->index == kN ? s.N[k] : moving ? s.v[k] : t->index == kA ? s.A[k] : s.w[k];
        const double dx = moving ? s.dv[k] - turning[k] : t->index == kA ? s.dA_B[k] : s.dw[k];
        out.value.x[k] = factor * x;
        out.value.dx[k] = factor * dx;
      }
      return out;
    }
    case Op::inertia: {
      want(a.value.vector);
      for (std::size_t k = 0; k < 3; ++k) a.value.x[k] *= s.I[k], a.value.dx[k] *= s.I[k];
      return a;
    }
    case Op::add:
    case Op::subtract: {
      want(a.value.vector == b.value.vector || is_zero_a || is_zero_b);
      const double sign = t->op == Op::add ? 1 : -1;
      for (std::size_t k = 0; k < 3; ++k)
        a.value.x[k] += sign * b.value.x[k], a.value.dx[k] += sign * b.value.dx[k];
      a.value.vector = a.value.vector || b.value.vector;
      a.has_rate = rates;
      return a;
    }
    case Op::negative:
      for (std::size_t k = 0; k < 3; ++k) a.value.x[k] *= -1, a.value.dx[k] *= -1;
      return a;
    case Op::times: {
      want(!a.value.vector || !b.value.vector);
      if (a.value.vector) std::swap(a, b);
      Evaluated out{{b.value.vector, {}, {}}, rates};
      for (std::size_t k = 0; k < 3; ++k) {
        out.value.x[k] = a.value.x[0] * b.value.x[k];
        out.value.dx[k] = a.value.dx[0] * b.value.x[k] + a.value.x[0] * b.value.dx[k];
      }
      return out;
    }
    case Op::over: {
      want(!b.value.vector && !is_zero_b);
      for (std::size_t k = 0; k < 3; ++k) {
        a.value.dx[k] = (a.value.dx[k] - a.value.x[k] * b.value.dx[0] / b.value.x[0]) / b.value.x[0];
        a.value.x[k] /= b.value.x[0];
      }
      a.has_rate = rates;
      return a;
    }
    case Op::square:
    case Op::length2: {
      want(a.value.vector || t->op == Op::square);
      double x = 0, dx = 0;
      for (std::size_t k = 0; k < 3; ++k)
        x += a.value.x[k] * a.value.x[k], dx += 2 * a.value.x[k] * a.value.dx[k];
      return scalar(x, dx, rates);
    }
    case Op::dot: {
      want(a.value.vector && b.value.vector);
      double x = 0, dx = 0;
      for (std::size_t k = 0; k < 3; ++k)
        x += a.value.x[k] * b.value.x[k], dx += a.value.dx[k] * b.value.x[k] + a.value.x[k] * b.value.dx[k];
      return scalar(x, dx, rates);
    }
    case Op::cross: {
      want(a.value.vector && b.value.vector);
      Evaluated out{{true, crossed(a.value.x, b.value.x), crossed(a.value.dx, b.value.x)}, rates};
      const auto other = crossed(a.value.x, b.value.dx);
      for (std::size_t k = 0; k < 3; ++k) out.value.dx[k] += other[k];
      return out;
    }
    case Op::ddt:
    case Op::star: {
      want(a.has_rate);
      Evaluated out{{a.value.vector, a.value.dx, {}}, false};
      const auto turning = crossed(s.w, a.value.x);
      if (a.value.vector && t->op == Op::ddt)
        for (std::size_t k = 0; k < 3; ++k) out.value.x[k] += turning[k];
      return out;
    }
  }
  throw Nonsense();
}

// --- changed ---------------------------------------------------------------------------------------------

/// Every term with one thing wrong.
void add_mutants(const T& t, std::vector<T>& to) {
  const auto with = [&](Op op, T a, T b) { to.push_back(make(op, t->index, std::move(a), std::move(b))); };
  switch (t->op) {
    case Op::moment:
    case Op::spin:
    case Op::spin_rate:
    case Op::torque:
    case Op::component:
    case Op::axis:
      to.push_back(make(t->op, t->index % 3 + 1));
      to.push_back(make(t->op, (t->index + 1) % 3 + 1));
      if (t->op == Op::spin_rate) to.push_back(w(t->index));
      break;
    case Op::number:
      to.push_back(n(t->index + 1));
      if (t->index == 0) to.push_back(Nv), to.push_back(energy);
      break;
    case Op::vector:
      if (t->index == kOmega) to.push_back(L);
      if (t->index == kL) to.push_back(om);
      break;
    case Op::add:
    case Op::subtract:
      with(t->op == Op::add ? Op::subtract : Op::add, t->a, t->b);
      to.push_back(t->a);
      to.push_back(t->b);
      break;
    case Op::negative:
      to.push_back(t->a);
      break;
    case Op::times:
      to.push_back(t->a);
      to.push_back(t->b);
      to.push_back(-t);
      break;
    case Op::over:
      with(Op::over, t->b, t->a);
      to.push_back(t->a);
      break;
    case Op::square:
      to.push_back(t->a);
      break;
    case Op::inertia:
      to.push_back(t->a);
      break;
    case Op::dot:
    case Op::cross:
      with(t->op, t->b, t->a);
      with(t->op == Op::dot ? Op::cross : Op::dot, t->a, t->b);
      break;
    case Op::ddt:
    case Op::star:
      with(t->op == Op::ddt ? Op::star : Op::ddt, t->a, nullptr);
      to.push_back(t->a);
      break;
    default:
      break;
  }
  for (const bool first : {true, false}) {
    const T& child = first ? t->a : t->b;
    if (!child) continue;
    std::vector<T> changed;
    add_mutants(child, changed);
    for (const T& one : changed) with(t->op, first ? one : t->a, first ? t->b : one);
  }
}

struct True {
  LawsAssumed laws;
  T left, right;
};

std::vector<True> true_equations() {
  const auto identity = LawsAssumed::identity, motion = LawsAssumed::motion, free = LawsAssumed::free;
  const auto squares = [](int power) {
    const auto term = [power](int i) { return (power == 1 ? I(i) : sq(I(i))) * sq(w(i)); };
    return term(1) + term(2) + term(3);
  };
  const T rates = I(1) * w(1) * dw(1) + I(2) * w(2) * dw(2) + I(3) * w(3) * dw(3);
  return {
      {motion, ddt(L), Nv},
      {motion, star(L) + cross(om, L), Nv},
      {motion, In(star(om)) + cross(om, In(om)), Nv},
      {motion, ddt(In(om)), Nv},
      {motion, ddt(energy), dot(Nv, om)},
      {motion, ddt(len2(L)), n(2) * dot(L, Nv)},
      {motion, ddt(dot(L, L)), n(2) * dot(L, ddt(L))},
      {motion, I(1) * dw(1) + w(2) * w(3) * (I(3) - I(2)), N(1)},
      {motion, I(2) * dw(2) + w(3) * w(1) * (I(1) - I(3)), N(2)},
      {motion, I(3) * dw(3) + w(1) * w(2) * (I(2) - I(1)), N(3)},
      {free, I(1) * dw(1), -((I(3) - I(2)) * w(2) * w(3))},
      {free, star(L), -cross(om, L)},
      {free, star(L), cross(L, w(1) * e(1)) + cross(L, w(2) * e(2)) + cross(L, w(3) * e(3))},
      {free, rates, zero},
      {free, sq(I(1)) * w(1) * dw(1) + sq(I(2)) * w(2) * dw(2) + sq(I(3)) * w(3) * dw(3), zero},
      {free, ddt(squares(1)), zero},
      {free, dot(om, In(star(om))) + dot(om, cross(om, In(om))), zero},
      {free, I(1) * I(3) * dw(1) * dw(3), (I(2) - I(1)) * (I(3) - I(2)) * sq(w(2)) * w(1) * w(3)},
      {identity, energy, squares(1) / n(2)},
      {identity, n(2) * energy, dot(om, In(om))},
      {identity, dot(L, L), squares(2)},
      {identity, ddt(energy), rates},
      {identity, len2(L) - n(2) * energy * I(1),
       I(2) * (I(2) - I(1)) * sq(w(2)) + I(3) * (I(3) - I(1)) * sq(w(3))},
      {identity, sq(I(1) * sq(w(1)) + I(3) * sq(w(3))),
       n(4) * I(1) * I(3) * sq(w(1)) * sq(w(3)) + sq(I(1) * sq(w(1)) - I(3) * sq(w(3)))},
      {identity, ddt(Av), star(Av) + cross(om, Av)},
      {identity, ddt(om), star(om)},
      {identity, ddt(e(2)), cross(om, e(2))},
      {identity, ddt(m * v), m * ddt(v)},
      {identity, cross(p, v), zero},
      {identity, Av, A(1) * e(1) + A(2) * e(2) + A(3) * e(3)},
      {identity, star(Av), ddt(A(1)) * e(1) + ddt(A(2)) * e(2) + ddt(A(3)) * e(3)},
      {identity, cross(e(1), cross(e(2), Av)) - cross(e(2), cross(e(1), Av)), cross(e(3), Av)},
      {identity, cross(Av, cross(om, Av)), len2(Av) * om - dot(Av, om) * Av},
      {identity, ddt(w(2) * w(3)), dw(2) * w(3) + w(2) * dw(3)},
      {identity, cross(om, In(om)),
       w(2) * w(3) * (I(3) - I(2)) * e(1) + w(3) * w(1) * (I(1) - I(3)) * e(2) +
           w(1) * w(2) * (I(2) - I(1)) * e(3)},
  };
}

/// Whether both sides agree, as far as doubles tell: their size is about 1, a few hundred roundings apart.
bool agree(const Value& a, const Value& b) {
  constexpr double kNear = 1e-9;  // a slip changes them by some per cent
  double size = 1;
  for (std::size_t i = 0; i < 3; ++i) size = std::max({size, std::abs(a.x[i]), std::abs(b.x[i])});
  for (std::size_t i = 0; i < 3; ++i)
    if (std::abs(a.x[i] - b.x[i]) > kNear * size) return false;
  return true;
}
Value read_value(const ComponentJets<SizedNumber, 0>& side) {
  Value value;
  for (std::size_t i = 0; i < 3; ++i) value.x[i] = side[i].value.value;
  return value;
}

struct Tally {
  int mutants = 0, read = 0, proved = 0, refused = 0;
};

/// Reads what is printed, and compares each side and the verdict with what they are.
void check(const True& one, const std::array<std::vector<World>, 3>& worlds, const Prover& prover,
           Tally& tally) {
  const std::string text = tex(one.left) + " = " + tex(one.right);
  const auto math = parse_math(text);
  ASSERT_TRUE(math.ok()) << text;
  const auto read = read_equation(*math, {});
  ++tally.mutants;
  bool holds = true, sense = true;
  std::vector<std::pair<Value, Value>> values;
  try {
    for (const World& world : worlds[static_cast<std::size_t>(one.laws)]) {
      values.emplace_back(evaluate(one.left, world).value, evaluate(one.right, world).value);
      const auto is_zero = [](const T& side) { return side->op == Op::number && side->index == 0; };
      if (values.back().first.vector != values.back().second.vector && !is_zero(one.left) &&
          !is_zero(one.right))
        throw Nonsense();
      holds = holds && agree(values.back().first, values.back().second);
    }
  } catch (const Nonsense&) {
    sense = false;
  }
  if (!read.ok()) {
    ++tally.refused;
    EXPECT_FALSE(sense) << text << ": " << read.error().reason;
    return;
  }
  EXPECT_TRUE(sense) << text;
  if (!sense) return;
  ++tally.read;
  ASSERT_EQ(read->sentences.size(), 1U) << text;
  ASSERT_EQ(read->sentences[0].links.size(), 1U) << text;
  const Equality& equality = read->sentences[0].links[0].equality;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const World& world = worlds[static_cast<std::size_t>(one.laws)][i];
    const auto sides = sides_of(equality, state_of(world.numbers, one.laws));
    ASSERT_TRUE(sides) << text;
    EXPECT_TRUE(agree(read_value(sides->left), values[i].first) &&
                agree(read_value(sides->right), values[i].second))
        << text << " is read as " << equality.left.text << " = " << equality.right.text;
  }
  const bool proved = prover.settle(equality, one.laws) == Verdict::holds;
  tally.proved += proved ? 1 : 0;
  EXPECT_EQ(proved, holds) << text << " is read as " << equality.left.text << " = " << equality.right.text;
}

TEST(TexMutants, AreReadAsPrintedAndProvedOnlyWhereTheyHold) {
  std::mt19937_64 random(1);
  std::array<std::vector<World>, 3> worlds;
  for (std::size_t laws = 0; laws < 3; ++laws)
    for (int k = 0; k < 3; ++k) worlds[laws].push_back(drawn(random, static_cast<LawsAssumed>(laws)));
  const Prover prover;
  Tally truths, mutants;
  std::set<std::string> seen;
  for (const True& one : true_equations()) {
    check(one, worlds, prover, truths);
    for (const bool left : {true, false}) {
      std::vector<T> changed;
      add_mutants(left ? one.left : one.right, changed);
      for (const T& side : changed) {
        const True mutant{one.laws, left ? side : one.left, left ? one.right : side};
        if (seen.insert(tex(mutant.left) + "=" + tex(mutant.right) +
                        std::to_string(static_cast<int>(one.laws)))
                .second)
          check(mutant, worlds, prover, mutants);
      }
    }
  }
  EXPECT_EQ(truths.proved, truths.mutants);
  EXPECT_GE(mutants.read, 500);
  EXPECT_LT(mutants.proved, mutants.read / 10);  // those that are true all the same
  RecordProperty("mutants", mutants.mutants);
  RecordProperty("read", mutants.read);
  RecordProperty("proved", mutants.proved);
  RecordProperty("refused", mutants.refused);
}

}  // namespace
}  // namespace polhode
