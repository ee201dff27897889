// SPDX-License-Identifier: MIT
#include "render/gl/type_on_figure.h"

#include "render/gl/passes/flat_pass.h"

namespace polhode {

std::vector<PlacedType> type_on_figure(const Inset& inset, const Fonts& fonts) {
  return FlatPass::type_on(inset.figure, {inset.place.width, inset.place.height}, halo_of(inset.background),
                           fonts);
}

}  // namespace polhode
