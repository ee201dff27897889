// SPDX-License-Identifier: MIT
#include "app/speaker.h"

#include <fmt/format.h>

#include <algorithm>

namespace polhode {

namespace {

/// As a sentence: with a full stop, unless it ends like one.
std::string sentence(std::string text) {
  if (!text.empty() && std::string_view(".:;!?").find(text.back()) == std::string_view::npos) text += '.';
  return text;
}

void add(std::string& text, const std::string& more) {
  if (!text.empty() && !more.empty()) text += ' ';
  text += more;
}

}  // namespace

std::string_view words_of(Callout::Kind kind) {
  return kind == Callout::Kind::said ? "The lecture said" : "What it meant";
}

Speaker::Speaker(const Lesson& lesson) : lesson_(lesson) {
  for (const auto& [name, symbol] : lesson.symbols) symbols_.push_back({name, symbol.math, {}});
}

std::string Speaker::words(const Math& math) const {
  return spoken(math, symbols_, [this](std::string_view name) {
    const auto found = lesson_.symbols.find(std::string(name));
    return found == lesson_.symbols.end() ? std::string() : found->second.say;
  });
}

std::string Speaker::words(const TextBlock& block) const {
  std::string text;
  for (const TextSpan& span : block.spans) {
    text += span.kind == TextSpan::Kind::math ? words(span.math) : span.text;
    if (span.break_after) text += ' ';
  }
  return text;
}

std::string Speaker::words(const RichText& text) const {
  std::string all;
  for (const TextBlock& block : text) add(all, words(block));
  return all;
}

std::string Speaker::words(const Equation& equation) const {
  const std::string formula = sentence(words(equation.math));
  return equation.tag.empty() ? "Equation: " + formula
                              : fmt::format("Equation ({}): {}", equation.tag, formula);
}

std::string Speaker::words(const Callout& callout) const {
  return fmt::format("{}: {}", words_of(callout.kind), sentence(words(callout.text)));
}

std::string Speaker::words(const Ask& ask) const {
  std::string text = "Question: " + sentence(words(ask.prompt_text));
  for (std::size_t i = 0; i < ask.choice_texts.size(); ++i)
    add(text, fmt::format("Choice {}: {}", i + 1, sentence(words(ask.choice_texts[i]))));
  return text;
}

std::string Speaker::words_of_title(const Stage& stage) const { return sentence(words(stage.title_text)); }

std::string Speaker::words_of_caption(const Stage& stage, int step) const {
  const auto& caption = stage.steps[static_cast<std::size_t>(step - 1)].caption;
  return caption ? words(*caption) : std::string();
}

std::string Speaker::words_of_page(const Stage& stage, int step) const {
  std::string text = words_of_title(stage);
  for (const Block& block : stage.steps[static_cast<std::size_t>(step - 1)].blocks) {
    if (const auto* prose = std::get_if<Prose>(&block)) add(text, words(prose->text));
    if (const auto* equation = std::get_if<Equation>(&block)) add(text, words(*equation));
    if (const auto* callout = std::get_if<Callout>(&block)) add(text, words(*callout));
    if (const auto* ask = std::get_if<Ask>(&block)) add(text, words(*ask));
  }
  return text;
}

}  // namespace polhode
