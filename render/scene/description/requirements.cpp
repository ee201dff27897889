// SPDX-License-Identifier: MIT
#include "render/scene/description/requirements.h"

#include <array>

namespace polhode {
namespace {

using R = Requirements;

constexpr std::array<RequirementFacts, 17> kFacts = {{
    {&R::omega, "omega", "ω(t)"},
    {&R::attitude, "attitude", "attitude"},
    {&R::polhode, "polhode", "polhode"},
    {&R::polhode_family, "polhode-family", "family of polhodes"},
    {&R::separatrix, "separatrix", "separatrices"},
    {&R::herpolhode, "herpolhode", "herpolhode"},
    {&R::rolling_ticks, "rolling-ticks", "ticks of rolling"},
    {&R::trail_L, "trail-L", "trail of L"},
    {&R::trail_omega, "trail-omega", "trail of ω"},
    {&R::cones, "cones", "cones"},
    {&R::solid, "solid", "shape of the body"},
    {&R::meters, "meters", "plots against time"},
    {&R::terms, "terms", "lengths of the terms"},
    {&R::ghost, "ghost", "exact motion beside it"},
    {&R::methods, "methods", "table of methods"},
    {&R::orders, "orders", "orders of the methods"},
    {&R::marks, "marks", "vectors of the lesson's own"},
}};

}  // namespace

std::span<const RequirementFacts> requirement_facts() { return kFacts; }

std::vector<std::string> names_of(const Requirements& needs) {
  std::vector<std::string> names;
  for (const RequirementFacts& facts : kFacts)
    if (needs.*facts.part) names.emplace_back(facts.name);
  return names;
}

}  // namespace polhode
