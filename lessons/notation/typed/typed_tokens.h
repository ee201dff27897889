// SPDX-License-Identifier: MIT
// A typed line as tokens: names, numbers, signs.
#pragma once

#include "lessons/notation/typed/typed_names.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

/// Bytes of a line that is typed: what is longer is refused.
inline constexpr std::size_t kMaxTypedBytes = 400;

/// What is wrong with what was typed.
struct TypedFault {
  std::size_t at = 0;  ///< byte of the line
  std::string message, hint;
};

struct TypedToken {
  enum class Kind { name, number, sign, end } kind = Kind::end;
  std::string text;    ///< of a sign what it stands for: "x" of ×, "." of ·, "^2" of ²
  std::size_t at = 0;  ///< byte of the line
  bool is(std::string_view sign) const { return kind == Kind::sign && text == sign; }
};

struct TypedTokens {
  std::vector<TypedToken> tokens;   ///< the last is an end
  std::optional<TypedFault> fault;  ///< the first; what is not read is left out
};

/// Names that are written together, "kT", are told apart by `names`.
TypedTokens read_typed_tokens(std::string_view line, const TypedNames& names);

}  // namespace polhode
