// SPDX-License-Identifier: MIT
// What pages of HTML have in common: a frame, from assets/, whose places are filled in.
#pragma once

#include "base/color.h"
#include "base/files/atomic_file.h"
#include "base/result.h"

#include <functional>
#include <string>
#include <string_view>

namespace polhode {

/// "#b04a00", without the opacity.
std::string hex(const Color& color);

/// Appends the frame; each {{name}} of it, in order, is what `put` appends for it. A name in what is put is
/// none.
Status append_frame(std::string_view frame, const AppendBytes& append,
                    const std::function<Status(const std::string& name)>& put);

}  // namespace polhode
