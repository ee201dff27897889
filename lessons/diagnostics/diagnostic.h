// SPDX-License-Identifier: MIT
// What is wrong with a lesson, and where.
#pragma once

#include <string>
#include <vector>

namespace polhode {

/// A place in a text, both counted from 1; columns count bytes of UTF-8 that start a character.
struct SourcePlace {
  int line = 1;
  int column = 1;
  bool operator==(const SourcePlace&) const = default;
};

enum class Severity { warning, error };

struct Diagnostic {
  Severity severity = Severity::error;
  std::string file;
  SourcePlace place;
  std::string message;  ///< what was found and what was expected
  std::string hint;     ///< what to do ("did you mean \"omega\"?"), may be empty
};

/// `file:line:column: error: message (hint)`, one line, printable.
std::string to_string(const Diagnostic& diagnostic);

}  // namespace polhode
