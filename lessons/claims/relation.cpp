// SPDX-License-Identifier: MIT
#include "lessons/claims/relation.h"

#include <array>
#include <cstddef>

namespace polhode {
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

}  // namespace polhode
