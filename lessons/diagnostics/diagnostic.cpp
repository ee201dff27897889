// SPDX-License-Identifier: MIT
#include "lessons/diagnostics/diagnostic.h"

#include "base/printable.h"

namespace polhode {

std::string to_string(const Diagnostic& d) {
  std::string text =
      printable_line(d.file) + ':' + std::to_string(d.place.line) + ':' + std::to_string(d.place.column) +
      (d.severity == Severity::error ? ": error: " : ": warning: ") + printable_line(d.message);
  if (!d.hint.empty()) text += " (" + printable_line(d.hint) + ')';
  return text;
}

}  // namespace polhode
