// SPDX-License-Identifier: MIT
// The text column between two pages: one step of a derivation becomes the next before the reader's eyes.
#pragma once

#include "app/page/text/page_text.h"

namespace polhode {

/// The column of `to` on its way from that of `from`, in px of the page; `way` is 0…1 in proportion to time,
/// and all begins and ends softly. At 0 all that one sees stands as on the page before (but for live values,
/// which are not here), at 1 as on the next. What both pages show moves straight, with its size; words that
/// change lines vanish here and appear there. The new equation in focus is a morph out of the one before,
/// which itself stays where the page keeps it. What is gone fades early, what else is new appears late, when
/// room has been made for it; what the equation flies over is faint meanwhile. Without `from` all stands and
/// what is newest appears.
Sheet column_on_its_way(const FittedText* from, const FittedText& to, double way);

/// The opacity of what is new when this part of the way is done.
double appeared(double way);

}  // namespace polhode
