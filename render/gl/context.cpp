// SPDX-License-Identifier: MIT
#include "render/gl/context.h"

namespace polhode {

Result<std::unique_ptr<GlContext>> open_context(ContextKind) { return failure("not yet"); }

}  // namespace polhode
