// SPDX-License-Identifier: MIT
// The symbols that a lesson has of its own, in words: for pages that print them after the step that explains
// them.
#pragma once

#include "lessons/reader/lesson.h"
#include "render/typeset/math/math.h"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace polhode {

/// Symbols of [constants] and [define] that have a `note`. Those of [symbols] are the field's, and need no
/// words.
class SymbolGlossary {
 public:
  /// `symbols` as pages set them. Reads the texts of all steps, if the lesson has such symbols.
  SymbolGlossary(const Lesson& lesson, const std::vector<MathSymbol>& symbols);

  /// "$u$: cosine of the tilt; …", of those among `names` that stand in a text before `from`: that step
  /// and those behind it are on the page. In the order of `names`; empty: none.
  std::string explained(const std::vector<std::string>& names, const StepPlace& from) const;

 private:
  struct Entry {
    std::string words;  ///< with the symbol between dollars
    StepPlace first;    ///< where it is printed first
  };
  std::map<std::string, Entry> entries_;
};

}  // namespace polhode
