// SPDX-License-Identifier: MIT
// Mathematical alphanumerics (The Unicode Standard, block U+1D400 … U+1D7FF).
#pragma once

#include "render/typeset/math/tree.h"

namespace polhode {

/// A letter or digit in an alphabet; what an alphabet lacks stays as it is. As TeX has it: letters are
/// italic, capital Greek is upright.
char32_t in_alphabet(char32_t character, Alphabet alphabet);

}  // namespace polhode
