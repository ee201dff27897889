// SPDX-License-Identifier: MIT
// The formulas of a step that a reader sees as text: prose, equations, call-outs, footnotes, questions.
#pragma once

#include "lessons/reader/lesson.h"

namespace polhode {

/// Calls act(const Math&) for each, in their order.
template <class Do>
void for_each_formula(const RichText& text, const Do& act) {
  for_each_span(text, [&](const TextSpan& span) {
    if (span.kind == TextSpan::Kind::math) act(span.math);
  });
}

/// Of what a reader of the step sees in its column.
template <class Do>
void for_each_formula(const Step& step, const Do& act) {
  for_each_formula(step.title, act);
  for (const Block& block : step.blocks) {
    if (const auto* equation = std::get_if<Equation>(&block)) act(equation->math);
    if (const auto* prose = std::get_if<Prose>(&block)) for_each_formula(prose->text, act);
    if (const auto* callout = std::get_if<Callout>(&block)) for_each_formula(callout->text, act);
    if (const auto* note = std::get_if<Footnote>(&block)) for_each_formula(note->text, act);
    if (const auto* ask = std::get_if<Ask>(&block)) {
      for_each_formula(ask->prompt_text, act);
      for (const RichText& choice : ask->choice_texts) for_each_formula(choice, act);
    }
  }
}

}  // namespace polhode
