// SPDX-License-Identifier: MIT
// What the program says to its user, on stderr.
#pragma once

#include <fmt/core.h>

#include <string_view>

namespace polhode {

/// Writes a text of lines to stderr, at once; what would steer the terminal is written out (printable.h). A
/// message that cannot be written, because the disk is full, stderr is closed or nobody reads its pipe any
/// more, is lost, and nothing else is: no exception, no signal.
void write_message(std::string_view text);

/// The same for the program's own steering of the terminal: the text as it is.
void steer_terminal(std::string_view text);

/// Formats a message and writes it.
template <class... Arguments>
void say(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
  write_message(fmt::format(format, std::forward<Arguments>(arguments)...));
}

/// Gives the numbers 0, 1 and 2 back to a program that was started without one of its standard streams: until
/// then the next file opened would get the number, and messages would be written into it. Reading or writing
/// such a stream still fails.
void reserve_standard_streams();

}  // namespace polhode
