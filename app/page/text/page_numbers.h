// SPDX-License-Identifier: MIT
// The computed numbers in the text of a page.
#pragma once

#include "app/page/live_numbers.h"
#include "app/page/page.h"

namespace polhode {

/// The numbers of all steps up to the page's. Those of earlier steps whose motion the page's step has
/// replaced by another are as they are on the stills of their own: what the formula says of one motion does
/// not turn into a number of the other.
PageNumbers numbers_of(const PageRequest& request, const Fonts& fonts);

}  // namespace polhode
