// SPDX-License-Identifier: MIT
// The WebGL 2 context of a canvas in a page, where polhode is built for browsers.
#pragma once

#include "render/gl/context/context.h"

#include <memory>
#include <string>

namespace polhode {

/// Of the canvas that this CSS selector finds: premultiplied, without antialiasing, depth and stencil of its
/// own (all is drawn off-screen), and it keeps what was drawn, so that it may be moved in the document and
/// saved as a picture. Current from now on; given back, not destroyed, with the context: a browser does that
/// with the canvas. The error says that there is none, in words for readers.
Result<std::unique_ptr<GlContext>> context_of_canvas(const std::string& selector);

}  // namespace polhode
