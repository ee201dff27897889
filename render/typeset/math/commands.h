// SPDX-License-Identifier: MIT
// The commands of TeX mathematics that are known, and the characters that may be typed as they are.
#pragma once

#include "render/typeset/math/tree.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

struct MathCommand {
  enum class Action : std::uint8_t {
    symbol,          ///< `character`, `atom`
    large_operator,  ///< `character`, `limits`
    named_operator,  ///< `text`, `limits`
    accent,          ///< `character`, `wide`
    bar,
    brace,
    space,     ///< `amount` em
    style,     ///< `amount`
    alphabet,  ///< `amount` is the Alphabet
    text,      ///< `amount` is the Face
    atom,      ///< \mathrel{…}: `atom`
    fraction,  ///< `amount` is the forced style or −1
    binomial,
    infix_over,
    infix_choose,
    infix_atop,
    radical,
    left,
    middle,
    right,
    big,  ///< `amount` is the factor of \big, 1 … 4; `atom`
    begin,
    end,
    operator_name,
    text_color,
    color,
    term,
    proved,
    live,
    value,
    tag,
    reference,
    cancel,  ///< `character`
    box,
    phantom,  ///< `amount`
    overset,
    underset,
    stackrel,
    arrow,  ///< `character`
    negate,
    limits,  ///< `limits`
    hspace,
    substack,
    row_end,
    line,
    nothing,  ///< is read and does nothing: \notag
    macro     ///< stands for `text`
  };
  std::string_view name = {};
  Action action = Action::symbol;
  char32_t character = 0;
  MathClass atom = MathClass::ordinary;
  Limits limits = Limits::beside;
  bool wide = false;
  double amount = 0;
  std::string_view text = {};
};

/// Of the name behind the backslash; null if it is not known.
const MathCommand* math_command(std::string_view name);
/// Of every command, in the order of the tables.
const std::vector<std::string_view>& math_command_names();

/// The name of a symbol's command, without backslash; empty if it has none.
std::string_view name_of_symbol(char32_t character);

/// What a character typed as it is stands for: '-' is a minus sign.
struct TypedSymbol {
  char32_t character = 0;
  MathClass atom = MathClass::ordinary;
};
TypedSymbol typed_symbol(char32_t character);

/// The delimiter after \left: '<' is ⟨. 0 if the character is none.
char32_t delimiter_of(char32_t character);

/// `relation` struck through, as a character of its own; 0 if there is none.
char32_t negated(char32_t relation);

/// Environments: nothing if the name is not known.
std::optional<MathGrid> math_environment(std::string_view name);
const std::vector<std::string_view>& math_environment_names();

std::optional<Color> named_color(std::string_view name);
const std::vector<std::string_view>& color_names();

}  // namespace polhode
