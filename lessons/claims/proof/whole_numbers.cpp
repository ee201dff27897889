// SPDX-License-Identifier: MIT
#include "lessons/claims/proof/whole_numbers.h"

#include <span>

namespace polhode {
namespace {

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

}  // namespace

void for_each_whole_number_state(const Dependence& d, const std::function<bool(const WholeNumbers&)>& use) {
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
              if (use(WholeNumbers{I, w, kRates[i], ddw, N, dN, c, q,
                                   static_cast<std::size_t>(&c - kOtherQuantities.data())}))
                return;
            }
}

std::vector<WholeNumbers> whole_number_bodies() {
  const Whole3 turning{1, 2, 3}, torque{-1, 2, 1}, rate{1, 2, 3};
  std::vector<WholeNumbers> bodies;
  for (const Whole3& I : kMoments)
    for (std::size_t i = 0; i < kOtherQuantities.size(); ++i)
      bodies.push_back({I, turning, rate, rate, torque, rate, kOtherQuantities[i], kAttitudes.back(), i});
  return bodies;
}

WholeNumbers mixed_numbers(std::mt19937_64& random) {
  const auto below = [&random](Whole count) {
    return static_cast<Whole>(random() % static_cast<std::uint64_t>(count));
  };
  const auto three = [&below] { return Whole3{below(11) - 5, below(11) - 5, below(11) - 5}; };
  WholeNumbers whole{};
  const Whole a = below(5), b = 1 + below(5), c = below(5);
  whole.I = {b + c, a + c + (a + c == 0 ? 1 : 0), a + b};  // possible but for this 1; that is looked at
  for (Whole3* vector : {&whole.w, &whole.dw, &whole.ddw, &whole.N, &whole.dN}) *vector = three();
  const auto place = static_cast<std::size_t>(below(static_cast<Whole>(kOtherQuantities.size())));
  whole.other = kOtherQuantities[place];
  for (Whole3 OtherQuantities::*vector :
       {&OtherQuantities::v, &OtherQuantities::dv, &OtherQuantities::ddv, &OtherQuantities::A,
        &OtherQuantities::dA, &OtherQuantities::ddA, &OtherQuantities::F, &OtherQuantities::dF})
    whole.other.*vector = three();
  whole.other.h = below(11) - 5;
  whole.other.k = below(11) - 5;
  whole.other.m = 1 + below(5);
  whole.q = {1 + below(3), below(7) - 3, below(7) - 3, below(7) - 3};
  whole.first_constant = static_cast<std::size_t>(below(static_cast<Whole>(kConstants.size())));
  return whole;
}

WholeNumbers uneven_numbers(std::mt19937_64& random) {
  WholeNumbers whole = mixed_numbers(random);
  const auto power = [&random](Whole number) {
    Whole scale = 1;
    for (auto n = random() % 5; n > 0; --n) scale *= 10;
    return number * scale;
  };
  const auto side = [&] { return power(static_cast<Whole>(random() % 4)); };
  const Whole a = side(), b = side() + 1, c = side();
  whole.I = {b + c, a + c + (a + c == 0 ? 1 : 0), a + b};
  for (Whole3* vector : {&whole.w, &whole.N})
    for (Whole& component : *vector) component = power(component);
  whole.other.h = power(whole.other.h);
  whole.other.k = power(whole.other.k);
  return whole;
}

}  // namespace polhode
