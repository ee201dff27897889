// SPDX-License-Identifier: MIT
// Text of others on a terminal: what would steer it is written out instead.
//
// Names in lessons, file names, arguments and manifests may hold anything. Whatever is echoed of them goes
// through here, so that it can neither colour, move or clear what is on the screen, nor turn its reading
// order.
#pragma once

#include <string>
#include <string_view>

namespace polhode {

/// A text of several lines: line feeds stay, other controls become \u001b, bytes that are no UTF-8 \xff. JSON
/// that holds no raw control within its strings is still the same JSON.
std::string printable(std::string_view text);

/// A name, or another text that is to be one line: line feeds are written out too.
std::string printable_line(std::string_view text);

/// A name that is the same after printable_line: it can be copied from where it is shown.
bool shows_as_it_is(const std::string& text);

}  // namespace polhode
