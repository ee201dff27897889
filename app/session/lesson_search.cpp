// SPDX-License-Identifier: MIT
#include "app/session/lesson_search.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <utility>

namespace polhode {

namespace {

std::string lower(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

std::string without_blanks(std::string text) {
  std::erase_if(text, [](char c) { return c == ' ' || c == '\n'; });
  return text;
}

std::string with_names(std::string text) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 19> kNames = {{{"ω", " omega "},
                                                                                            {"Ω", " omega "},
                                                                                            {"θ", " theta "},
                                                                                            {"φ", " phi "},
                                                                                            {"ϕ", " phi "},
                                                                                            {"ψ", " psi "},
                                                                                            {"α", " alpha "},
                                                                                            {"λ", " lambda "},
                                                                                            {"π", " pi "},
                                                                                            {"ρ", " rho "},
                                                                                            {"σ", " sigma "},
                                                                                            {"τ", " tau "},
                                                                                            {"×", " cross "},
                                                                                            {"·", " dot "},
                                                                                            {"=", " equals "},
                                                                                            {"−", " minus "},
                                                                                            {"₁", " 1 "},
                                                                                            {"₂", " 2 "},
                                                                                            {"₃", " 3 "}}};
  for (const auto& [sign, name] : kNames)
    for (std::size_t at = 0; (at = text.find(sign, at)) != text.npos; at += name.size())
      text.replace(at, sign.size(), name);
  return text;
}

std::vector<std::string> words_in(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

/// Where a word begins that begins so; npos: nowhere.
std::size_t begin_of(const std::string& text, const std::string& word) {
  const auto is_inside = [&](std::size_t at) {
    const auto is_of_word = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'); };
    return at > 0 && is_of_word(text[at - 1]) && is_of_word(text[at]);
  };
  std::size_t at = text.find(word);
  while (at != text.npos && is_inside(at)) at = text.find(word, at + 1);
  return at;
}

/// Some words on both sides of the place, whole ones.
std::string words_around(const std::string& text, std::size_t at) {
  constexpr std::size_t kBefore = 30, kBehind = 70;
  std::size_t begin = at > kBefore ? text.find_first_of(" \n", at - kBefore) + 1 : 0;
  if (begin > at) begin = at;
  // A heading, and what stands below it, are not one sentence.
  if (const std::size_t line = text.rfind('\n', at); line != text.npos) begin = std::max(begin, line + 1);
  std::size_t end = at + kBehind < text.size() ? text.rfind(' ', at + kBehind) : text.size();
  if (end <= at) end = text.size();
  end = std::min(end, text.find('\n', at));
  const bool goes_on = end < text.size() && text[end] != '\n';
  return (begin > 0 && text[begin - 1] != '\n' ? "… " : "") + text.substr(begin, end - begin) +
         (goes_on ? " …" : "");
}

}  // namespace

LessonSearch::LessonSearch(const Lesson& lesson, const SpeechText& speech) {
  for (std::size_t stage = 0; stage < lesson.stages.size(); ++stage)
    for (std::size_t step = 0; step < lesson.stages[stage].steps.size(); ++step) {
      const int number = static_cast<int>(step) + 1;
      std::string words = speech.words_of_page(lesson.stages[stage], number, number);
      std::string tex;
      for (const Equation* equation : blocks_of<Equation>(lesson.stages[stage].steps[step]))
        tex += without_blanks(lower(equation->tex)) + '\n';
      steps_.push_back({{stage, step}, words, lower(words), tex});
    }
}

std::vector<LessonSearch::Found> LessonSearch::find(std::string_view typed) const {
  std::vector<Found> found;
  const std::string text = lower(std::string(typed));
  const std::vector<std::string> words = words_in(with_names(text));
  const std::string tex = without_blanks(text);
  const bool is_tex = tex.find_first_of("\\_^{=") != tex.npos;  // "time" stands in \times
  if (words.empty()) return found;
  std::string all;
  for (const std::string& word : words) all += (all.empty() ? "" : " ") + word;
  for (const StepText& step : steps_) {
    std::size_t first = std::string::npos;
    const bool has_words = std::all_of(words.begin(), words.end(), [&](const std::string& word) {
      const std::size_t at = begin_of(step.lowered, word);
      if (first == std::string::npos) first = at;
      return at != std::string::npos;
    });
    if (!has_words && (!is_tex || step.tex.find(tex) == step.tex.npos)) continue;
    if (has_words)
      if (const std::size_t phrase = begin_of(step.lowered, all); phrase != std::string::npos) first = phrase;
    found.push_back({step.place, words_around(step.words, has_words ? first : 0)});
  }
  return found;
}

}  // namespace polhode
