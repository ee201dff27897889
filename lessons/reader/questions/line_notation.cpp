// SPDX-License-Identifier: MIT
#include "lessons/reader/questions/line_notation.h"

#include "render/typeset/rich_text.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <utility>

namespace polhode {
namespace {

bool is_of_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

void add_words(std::string_view text, std::set<std::string>& words) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t begin = at;
    while (at < text.size() && is_of_name(text[at])) ++at;
    if (at > begin) words.emplace(text.substr(begin, at - begin));
    at = std::max(at, begin + 1);
  }
}

/// Words of what the question says in the language of claims, and as lines are typed.
std::set<std::string> words_of(const Ask& ask) {
  std::set<std::string> words(ask.letters.begin(), ask.letters.end());
  if (ask.expression) add_words(ask.expression->text, words);
  for (const Setting& setting : ask.given.settings) add_words(setting.text, words);
  if (!ask.derivation) return words;
  const Derivation& derivation = *ask.derivation;
  add_words(derivation.start.typed, words);
  add_words(derivation.goal.typed, words);
  for (const DerivedLine& fact : derivation.facts) add_words(fact.typed, words);
  for (const WorkedLine& worked : derivation.worked) add_words(worked.line.typed, words);
  return words;
}

std::string without_blanks(std::string_view tex) {
  std::string text;
  for (const char c : tex)
    if (c != ' ') text += c;
  return text;
}

/// Whether a formula has the symbol, and not as a part of a longer one: "c" in "2c", not in "\vec c_1".
bool prints(const std::string& formula, const std::string& symbol) {
  for (std::size_t at = formula.find(symbol); at != formula.npos; at = formula.find(symbol, at + 1)) {
    const std::size_t end = at + symbol.size();
    const auto is_letter = [&](std::size_t i) {
      return i < formula.size() && std::isalpha(static_cast<unsigned char>(formula[i])) != 0;
    };
    std::size_t word = at;
    while (word > 0 && is_letter(word - 1)) --word;
    const bool is_in_command = word > 0 && formula[word - 1] == '\\' && symbol.front() != '\\';
    const bool goes_on = (end < formula.size() && formula[end] == '_') ||
                         (symbol.front() == '\\' && is_letter(end - 1) && is_letter(end));
    if (!is_in_command && !goes_on) return true;
  }
  return false;
}

std::vector<std::string> formulas_of(const RichText& text) {
  std::vector<std::string> formulas;
  for_each_span(text, [&](const TextSpan& span) {
    if (span.kind == TextSpan::Kind::math) formulas.push_back(without_blanks(span.text));
  });
  return formulas;
}

/// Names of the lesson's file that a learner cannot know.
std::set<std::string> hidden_names(const Lesson& lesson, const Ask& ask) {
  const std::set<std::string> said = words_of(ask);
  const std::vector<std::string> formulas = formulas_of(ask.prompt_text);
  std::set<std::string> hidden;
  for (const Vocabulary::Word& word : lesson.notation.vocabulary.words()) {
    const auto symbol = lesson.symbols.find(word.name);
    const std::string tex = without_blanks(symbol == lesson.symbols.end() ? word.tex : symbol->second.tex);
    const bool is_printed = !tex.empty() && std::any_of(formulas.begin(), formulas.end(),
                                                        [&](const auto& one) { return prints(one, tex); });
    if (!said.contains(word.name) && !is_printed) hidden.insert(word.name);
  }
  return hidden;
}

}  // namespace

LineNotation line_notation(const EquationNotation& notation, const std::map<std::string, Symbol>& symbols,
                           const MathMacros& macros) {
  LineNotation how{&notation, {}, macros};
  for (const auto& [name, symbol] : symbols) how.names.emplace(name, symbol.tex);
  return how;
}

LineNotation line_notation(const Lesson& lesson, const Ask& ask) {
  LineNotation how = line_notation(lesson.notation, lesson.symbols, lesson.macros);
  const std::set<std::string> hidden = hidden_names(lesson, ask);
  if (hidden.empty()) return how;
  for (const std::string& name : hidden) how.names.erase(name);
  auto own = std::make_shared<EquationNotation>(lesson.notation);
  own->vocabulary.forget(hidden);
  how.notation = own.get();
  how.own = std::move(own);
  return how;
}

}  // namespace polhode
