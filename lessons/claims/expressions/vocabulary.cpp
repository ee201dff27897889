// SPDX-License-Identifier: MIT
#include "lessons/claims/expressions/vocabulary.h"

#include "lessons/claims/expressions/expression_builder.h"

#include <algorithm>
#include <cctype>
#include <utility>

namespace polhode {

void Vocabulary::add_constant(const std::string& name, double value, std::string tex) {
  std::vector<std::string> names = constants_ ? *constants_ : std::vector<std::string>();
  ExpressionBuilder builder;
  builder.constant(static_cast<int>(names.size()), value, 0, name.size());
  names.push_back(name);
  constants_ = std::make_shared<const std::vector<std::string>>(std::move(names));
  words_.push_back({name, Expression{name, builder.take(), constants_}, std::move(tex)});
}

std::optional<std::pair<int, double>> Vocabulary::Word::constant() const {
  const ExpressionNode& whole = means.nodes.back();
  // What is defined as a constant alone has another text.
  if (whole.operation != Operation::constant || means.text != name) return std::nullopt;
  return std::pair(whole.integer, whole.number.value);
}

void Vocabulary::define(const std::string& name, Expression means, std::string tex) {
  later_.erase(name);
  words_.push_back({name, std::move(means), std::move(tex)});
}

void Vocabulary::print_as(std::string_view name, std::string tex) {
  const auto found =
      std::find_if(words_.begin(), words_.end(), [name](const Word& word) { return word.name == name; });
  if (found != words_.end()) found->tex = std::move(tex);
}

void Vocabulary::forget(const std::set<std::string>& names) {
  std::erase_if(words_, [&](const Word& word) { return names.contains(word.name); });
}

const Vocabulary::Word* Vocabulary::find(std::string_view name) const {
  const auto found =
      std::find_if(words_.begin(), words_.end(), [name](const Word& word) { return word.name == name; });
  return found == words_.end() ? nullptr : &*found;
}

std::vector<std::string> Vocabulary::names() const {
  std::vector<std::string> names;
  for (const Word& word : words_) names.push_back(word.name);
  return names;
}

std::string why_no_word(std::string_view name) {
  const auto is_letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  const auto fits = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  if (name.empty() || !is_letter(name.front()) || !std::all_of(name.begin(), name.end(), fits))
    return "a name begins with a letter, and has letters, digits and _ only";
  const auto& known = expression_symbols();
  const auto functions = expression_functions();
  const bool taken = std::find(known.begin(), known.end(), name) != known.end() ||
                     std::find(functions.begin(), functions.end(), name) != functions.end();
  return taken ? "expressions have this word already" : "";
}

}  // namespace polhode
