// SPDX-License-Identifier: MIT
#include "app/page/text/symbol_glossary.h"

#include "app/narration/step_formulas.h"
#include "lessons/claims/expressions/vocabulary.h"

#include <algorithm>

namespace polhode {

SymbolGlossary::SymbolGlossary(const Lesson& lesson, const std::vector<MathSymbol>& symbols) {
  std::map<std::string, std::string, std::less<>> wanted;
  for (const auto& [name, symbol] : lesson.symbols)
    if (const Vocabulary::Word* word = lesson.notation.vocabulary.find(name); word && !symbol.note.empty())
      wanted.emplace(name, '$' + word->tex + "$: " + symbol.note);
  for (std::size_t stage = 0; stage < lesson.stages.size(); ++stage) {
    const std::vector<Step>& steps = lesson.stages[stage].steps;
    for (std::size_t i = 0; i < steps.size() && entries_.size() < wanted.size(); ++i)
      for_each_formula(steps[i], [&](const Math& math) {
        // A formula is spoken by the names of its symbols.
        spoken(math, symbols, [&](std::string_view name) {
          if (const auto found = wanted.find(name); found != wanted.end())
            entries_.try_emplace(found->first, Entry{found->second, {stage, i}});
          return std::string(name);
        });
      });
  }
}

std::string SymbolGlossary::explained(const std::vector<std::string>& names, const StepPlace& from) const {
  std::string line;
  std::vector<std::string> done;
  for (const std::string& name : names) {
    const auto found = entries_.find(name);
    if (found == entries_.end() || found->second.first >= from) continue;
    if (std::find(done.begin(), done.end(), name) != done.end()) continue;
    done.push_back(name);
    line += (line.empty() ? "" : "; ") + found->second.words;
  }
  return line;
}

}  // namespace polhode
