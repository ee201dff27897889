// SPDX-License-Identifier: MIT
// Where the formulas of a line of plain text are: what labels, captions and titles share.
#pragma once

#include "render/typeset/display_list.h"

#include <string_view>
#include <vector>

namespace polhode {

/// The bytes between two `$`, which are not among them. A formula is not empty and neither begins nor ends
/// with a space; `\$` is a dollar sign, and so is a `$` without a partner.
std::vector<SourceSpan> formulas_of_line(std::string_view text);

}  // namespace polhode
