// SPDX-License-Identifier: MIT
// Slips of the pen: an expression with one thing wrong.
#pragma once

#include "tests/oracle/term.h"

namespace polhode::oracle {

/// Every expression with one sign, index, factor, term, function or order of arguments changed; some of them
/// say the same as before. None twice, none the original, all can be read.
std::vector<Expression> mutants_of(const Expression& expression);

}  // namespace polhode::oracle
