// SPDX-License-Identifier: MIT
#include "lessons/claims/proof/counterexample_text.h"

#include "base/numbers.h"
#include "lessons/claims/proof/rational_function.h"

#include <array>
#include <cmath>

namespace polhode {
namespace {

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

std::array<SizedNumber, 3> rates_of(const ComponentJets<SizedNumber>& x) {
  return {x[0].rate, x[1].rate, x[2].rate};
}

/// Behind the whole components of a quaternion what makes its length 1: "/\\sqrt{2}".
std::string over_its_length(const std::array<SizedNumber, 4>& q) {
  double square = 0;
  for (const SizedNumber& component : q) square += component.value * component.value;
  const double length = std::round(std::sqrt(square));
  if (length * length != square) return "/\\sqrt{" + number_text(square) + '}';
  return length == 1 ? "" : '/' + number_text(length);
}

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

}  // namespace

std::string number_text(double value) {
  constexpr int kDigits = 6;
  const std::string text = digits(value == 0 ? 0.0 : value, kDigits);  // no −0
  return text.front() == '-' ? "−" + text.substr(1) : text;
}

std::string name_in_tex(std::string_view name) {
  std::string tex = "\\text{";
  for (const char c : name) tex += c == '_' ? std::string("\\_") : std::string(1, c);
  return tex + '}';
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

std::string value_text(const ComponentJets<SizedNumber, 0>& value, ExpressionType type) {
  if (type == ExpressionType::zero) return "0";
  if (type == ExpressionType::scalar) return number_text(value[0].value.value);
  return list_text(std::array{value[0].value.value, value[1].value.value, value[2].value.value});
}

std::string text_of(const Expansion<Ratio>& side, ExpressionType type, int last) {
  if (type == ExpressionType::zero) return "0";
  if (type == ExpressionType::scalar) return text_of(side[0], last);
  return '(' + text_of(side[0], last) + ", " + text_of(side[1], last) + ", " + text_of(side[2], last) + ')';
}

}  // namespace polhode
