// SPDX-License-Identifier: MIT
#include "lessons/diagnostic.h"

namespace polhode {

std::string to_string(const Diagnostic& d) {
  std::string text = d.file + ':' + std::to_string(d.place.line) + ':' + std::to_string(d.place.column) +
                     (d.severity == Severity::error ? ": error: " : ": warning: ") + d.message;
  if (!d.hint.empty()) text += " (" + d.hint + ')';
  return text;
}

}  // namespace polhode
