// SPDX-License-Identifier: MIT
// What the text of a page says of the claims on it.
#pragma once

#include "app/page/page.h"
#include "app/page/text/text_column.h"

#include <map>
#include <string>

namespace polhode {

/// On the claims of the stage up to the page's step: the same at every size of type.
using Verdicts = std::map<const Claim*, VerdictRow>;
Verdicts verdicts_of(const PageRequest& request);

/// Whether a claim is not the formula that it stands at, and holds: on a slide its badge would seem to be
/// of the formula.
bool is_beside(const Claim& claim, const VerdictRow& row);

/// A title without emphasis, its formulas between dollars, as set_line has it.
std::string in_a_line(const RichText& title);

/// The title of its step, the kind of the first claim on it, and what that is given: without that a recalled
/// one would seem to hold always.
EarlierLabel label_of_earlier(const Verdicts& verdicts, const Equation& equation, const Step& step,
                              Language language);

}  // namespace polhode
