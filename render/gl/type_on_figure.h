// SPDX-License-Identifier: MIT
// What a renderer writes into a figure: names, readouts and titles, each where it stands.
#pragma once

#include "render/gl/renderer.h"

#include <vector>

namespace polhode {

/// In px of the inset, each with the text that it was set from; placed anew, which takes as long as drawing
/// it.
std::vector<PlacedType> type_on_figure(const Inset& inset, const Fonts& fonts);

}  // namespace polhode
