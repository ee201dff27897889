// SPDX-License-Identifier: MIT
#include "lessons/claims/claim.h"

#include <algorithm>
#include <array>

namespace polhode {
namespace {

constexpr std::array<std::string_view, 8> kKindNames = {"identity", "definition", "law",      "motion",
                                                        "free",     "false",      "measured", "non-sequitur"};

}  // namespace

std::string_view name_of(ClaimKind kind) { return kKindNames[static_cast<std::size_t>(kind)]; }

std::optional<ClaimKind> claim_kind_from(std::string_view name) {
  const auto found = std::find(kKindNames.begin(), kKindNames.end(), name);
  if (found == kKindNames.end()) return std::nullopt;
  return static_cast<ClaimKind>(found - kKindNames.begin());
}

std::vector<std::string> claim_kind_names() { return {kKindNames.begin(), kKindNames.end()}; }

namespace {

struct RelationTexts {
  std::string_view text, sign, tex;
};
constexpr std::array<RelationTexts, 6> kRelationTexts = {{{"=", "=", "="},
                                                          {"<", "<", "<"},
                                                          {"<=", "≤", "\\le"},
                                                          {">", ">", ">"},
                                                          {">=", "≥", "\\ge"},
                                                          {"~=", "≈", "\\approx"}}};

const RelationTexts& texts_of(Relation relation) {
  return kRelationTexts[static_cast<std::size_t>(relation)];
}

}  // namespace

std::string_view text_of(Relation relation) { return texts_of(relation).text; }
std::string_view sign_of(Relation relation) { return texts_of(relation).sign; }
std::string_view tex_of(Relation relation) { return texts_of(relation).tex; }

std::string to_string(const Counterexample& counterexample) {
  return "at " + counterexample.state + " the left side is " + counterexample.left + ", the right side " +
         counterexample.right;
}

}  // namespace polhode
