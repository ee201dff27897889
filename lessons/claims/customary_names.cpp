// SPDX-License-Identifier: MIT
#include "lessons/claims/customary_names.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace polhode {
namespace {

constexpr Dimension kAngularMomentum{1, 2, -1}, kMass{1, 0, 0}, kMomentum{1, 1, -1}, kVelocity{0, 1, -1},
    kForce{1, 1, -2}, kPower{1, 2, -3}, kLength{0, 1, 0};

struct Letters {
  std::u32string_view letters;
  Dimension dimension;
};
/// A letter of several rows can be each of them. A torque is measured in units of energy; what is last are
/// letters of ratios and counts, too.
constexpr std::array<Letters, 15> kLetters{{{U"TEHUK", kEnergy},
                                            {U"NMτ", kEnergy},
                                            {U"H", kAngularMomentum},
                                            {U"tτP", kTime},
                                            {U"θϑφϕψ", kNumber},
                                            {U"ωΩ", kRate},
                                            {U"L", kAngularMomentum},
                                            {U"I", kInertia},
                                            {U"mM", kMass},
                                            {U"p", kMomentum},
                                            {U"v", kVelocity},
                                            {U"v", kRate},
                                            {U"F", kForce},
                                            {U"P", kPower},
                                            {U"NpvFMUPK", kNumber}}};

struct Words {
  std::string_view words;
  Dimension dimension;
};
constexpr std::array<Words, 26> kWords{{{"angular velocity", kRate},
                                        {"angular momentum", kAngularMomentum},
                                        {"angular acceleration", {0, 0, -2}},
                                        {"energy", kEnergy},
                                        {"kinetic energy", kEnergy},
                                        {"potential energy", kEnergy},
                                        {"rotational energy", kEnergy},
                                        {"power", kPower},
                                        {"torque", kEnergy},
                                        {"moment of force", kEnergy},
                                        {"moment of inertia", kInertia},
                                        {"principal moment", kInertia},
                                        {"momentum", kMomentum},
                                        {"momentum", kAngularMomentum},
                                        {"linear momentum", kMomentum},
                                        {"velocity", kVelocity},
                                        {"force", kForce},
                                        {"mass", kMass},
                                        {"time", kTime},
                                        {"period", kTime},
                                        {"angle", kNumber},
                                        {"tilt", kNumber},
                                        {"cosine", kNumber},
                                        {"sine", kNumber},
                                        {"linear velocity", kVelocity},
                                        {"distance", kLength}}};

/// What is said more of a quantity leaves it one of its kind. Not all that may follow does: the velocity of
/// the tip of a vector is of the kind of that vector's rate, and what is drawn has a scale of its own.
constexpr std::array<std::string_view, 8> kBehind{" of the body",     " of a body",   " of this body",
                                                  " of the rotation", " of the spin", " in space",
                                                  " in the body",     " vector"};
/// Of what these are the quantity has the unit.
constexpr std::array<std::string_view, 7> kPartOf{"component of ", "part of ",      "length of ", "norm of ",
                                                  "size of ",      "magnitude of ", "total "};

/// What may stand before a name without making it another.
constexpr std::array<std::string_view, 9> kBefore{"the ",   "its ",    "an ",       "a ",       "total ",
                                                  "whole ", "body's ", "constant ", "external "};

}  // namespace

std::vector<Dimension> dimensions_of_letter(char32_t letter) {
  std::vector<Dimension> dimensions;
  for (const Letters& row : kLetters)
    if (row.letters.find(letter) != row.letters.npos) dimensions.push_back(row.dimension);
  return dimensions;
}

namespace {

std::vector<Dimension> dimensions_of_name(std::string_view name) {
  std::vector<Dimension> dimensions;
  for (const Words& row : kWords)
    if (row.words == name) dimensions.push_back(row.dimension);
  return dimensions;
}

}  // namespace

std::vector<Dimension> dimensions_of_words(std::string_view words) {
  std::string text;
  for (const char c : words) text += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const std::size_t first = text.find_first_not_of(' ');
  if (first == text.npos || text.find(" per ") != text.npos) return {};
  text = text.substr(first, text.find_last_not_of(" ,:") - first + 1);
  std::string_view name(text);
  for (bool has_more = true; has_more;) {
    has_more = false;
    const auto take = [&](std::string_view before) {
      if (!name.starts_with(before)) return;
      name.remove_prefix(before.size());
      has_more = true;
    };
    for (const std::string_view before : kBefore) take(before);
    for (const std::string_view before : kPartOf) take(before);
  }
  for (bool has_more = true; has_more;) {
    if (auto dimensions = dimensions_of_name(name); !dimensions.empty()) return dimensions;
    has_more = false;
    for (const std::string_view behind : kBehind)
      if (name.ends_with(behind)) {
        name.remove_suffix(behind.size());
        has_more = true;
      }
  }
  return {};
}

bool can_have(const std::vector<Dimension>& of_name, const std::optional<Dimension>& dimension) {
  return of_name.empty() || !dimension ||
         std::find(of_name.begin(), of_name.end(), *dimension) != of_name.end();
}

}  // namespace polhode
