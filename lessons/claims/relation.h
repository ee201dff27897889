// SPDX-License-Identifier: MIT
// How two sides are related.
#pragma once

#include <string_view>

namespace polhode {

/// approximate: equal to some order in what is small (given.h), or within a tolerance that is said.
enum class Relation { equal, less, less_or_equal, greater, greater_or_equal, approximate };
/// "=", "<", "<=", ">", ">=", "~=", as claims are written; and as it is read: "≤".
std::string_view text_of(Relation relation);
std::string_view sign_of(Relation relation);
/// TeX: "\\le".
std::string_view tex_of(Relation relation);
/// Whether it says which side is the greater.
constexpr bool is_order(Relation relation) {
  return relation != Relation::equal && relation != Relation::approximate;
}

}  // namespace polhode
