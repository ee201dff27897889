// SPDX-License-Identifier: MIT
// What a lecturer sees beside the page while presenting: the next step, and what is to be said of this one.
#pragma once

#include "app/window/panels/panel_context.h"
#include "render/image/image.h"

namespace polhode {

/// Where the picture of the next step lies, to the right of the page.
Region preview_region(const Region& page, Size window);

/// The words round it and below it.
void draw_notes(PanelContext& context, const Region& page, Size window);

}  // namespace polhode
