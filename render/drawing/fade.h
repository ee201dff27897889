// SPDX-License-Identifier: MIT
// A drawing on its way in or out.
#pragma once

#include "render/drawing/sheet.h"

namespace polhode {

/// The sheet with the alpha of all its colours times `opacity`, 0…1; at 0 an empty one.
Sheet faded(Sheet sheet, double opacity);

}  // namespace polhode
