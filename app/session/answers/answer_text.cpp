// SPDX-License-Identifier: MIT
#include "app/session/answers/answer_text.h"

#include "app/narration/state_line.h"
#include "app/session/steering.h"
#include "base/ascii.h"
#include "base/words/answer_words.h"
#include "base/words/edition_words.h"
#include "base/words/page_words.h"
#include "lessons/claims/answers/reason_tags.h"
#include "lessons/claims/answers/told_in_language.h"
#include "lessons/claims/expressions/expression_tex.h"
#include "render/scene/model/scene_problem.h"

#include <fmt/format.h>

#include <cmath>

namespace polhode {

namespace {

TextSpan words_span(std::string words) {
  TextSpan span;
  span.text = std::move(words);
  return span;
}

/// Nothing where the TeX cannot be read.
std::optional<TextSpan> math_span(const std::string& tex) {
  Result<Math, std::vector<TypeError>> math = parse_math(tex);
  if (!math) return std::nullopt;
  TextSpan span;
  span.kind = TextSpan::Kind::math;
  span.text = tex;
  span.math = std::move(math).value();
  return span;
}

RichText block_of(std::vector<TextSpan> spans) {
  TextBlock block;
  block.spans = std::move(spans);
  return {std::move(block)};
}

/// In another language than that of the judgement; empty where there is nothing to say.
std::string reason_in(Language language, const Ask& ask, std::string_view text,
                      const AnswerJudgement& judgement) {
  if (ask.number) return judge_number_in(language, *ask.number, text).reason;
  const bool is_known = judgement.mark == AnswerJudgement::Mark::wrong && !judgement.tag.empty() &&
                        judgement.tag != kOtherReason;
  return is_known && !ask.task ? words_of_reason_in(language, judgement.tag) : "";
}

}  // namespace

RichText words_text(std::string words) { return block_of({words_span(std::move(words))}); }

RichText line_text(std::string_view line) {
  std::vector<TextSpan> spans;
  while (!line.empty()) {
    const std::size_t begin = line.find('$'), end = begin == line.npos ? begin : line.find('$', begin + 1);
    if (end == line.npos) {
      spans.push_back(words_span(std::string(line)));
      break;
    }
    if (begin > 0) spans.push_back(words_span(std::string(line.substr(0, begin))));
    const std::string tex(line.substr(begin + 1, end - begin - 1));
    spans.push_back(math_span(tex).value_or(words_span(tex)));
    line.remove_prefix(end + 1);
  }
  return block_of(std::move(spans));
}

RichText formula_text(const std::string& tex) { return block_of({math_span(tex).value_or(words_span(tex))}); }

RichText opened_by(std::string words, RichText text) {
  if (text.empty() || text.front().is_table()) text.insert(text.begin(), TextBlock());
  std::vector<TextSpan>& spans = text.front().spans;
  spans.insert(spans.begin(), words_span(std::move(words)));
  return text;
}

RichText joined(RichText text, const RichText& more) {
  text.insert(text.end(), more.begin(), more.end());
  return text;
}

RichText in_a_row(RichText text, const RichText& more) {
  if (text.empty() || more.empty()) return joined(std::move(text), more);
  std::vector<TextSpan>& spans = text.back().spans;
  spans.insert(spans.end(), more.front().spans.begin(), more.front().spans.end());
  text.insert(text.end(), more.begin() + 1, more.end());
  return text;
}

RichText text_after(const Ask& ask, const AnswerJudgement& judgement) {
  const auto picked = static_cast<std::size_t>(judgement.choice);
  RichText text = picked > 0 && picked <= ask.replies.size() ? ask.replies[picked - 1] : RichText();
  return judgement.mark == AnswerJudgement::Mark::right ? joined(std::move(text), ask.because) : text;
}

RichText answer_text(const Lesson& lesson, const Ask& ask) {
  RichText text;
  if (ask.expression) {
    text = formula_text(tex_of(*ask.expression, &lesson.notation.vocabulary));
    TextSpan typed = words_span(ask.expression->text);
    typed.code = true;
    // ", typed "
    const std::string how = words::kTyped.with(lesson.about.language, {"", ""});
    for (TextSpan& span : std::vector<TextSpan>{words_span(how), typed, words_span(".")})
      text.front().spans.push_back(std::move(span));
  } else if (ask.task) {
    text = line_text(state_line(ask.task->solution, lesson.about.language) + '.');
  } else if (ask.number) {
    text = words_text(with_decimals(words_of(*ask.number), lesson.about.language) + '.');
  } else {
    std::string letters;
    for (const int answer : ask.answers)
      letters += (letters.empty() ? "" : ", ") +
                 std::string(1, letter_of_choice(static_cast<std::size_t>(answer - 1)));
    if (ask.answers.size() == 1)
      text = opened_by(letters + ": ", ask.choice_texts[static_cast<std::size_t>(ask.answers.front() - 1)]);
    else if (!letters.empty())
      text = words_text(letters + '.');
  }
  return joined(std::move(text), ask.because);
}

ToldVerdict told_verdict(const Ask& ask, std::string_view text, const AnswerJudgement& judgement,
                         Language language) {
  using Mark = AnswerJudgement::Mark;
  if (judgement.mark == Mark::right) return {std::string(words::kRight.in(language)), ""};
  if (judgement.choice > 0) {
    const char letter = letter_of_choice(static_cast<std::size_t>(judgement.choice) - 1);
    return {words::kChoiceIsNotRight.with(language, {std::string(1, letter)}), ""};
  }
  const bool is_english = language == Language::en, is_wrong = judgement.mark == Mark::wrong;
  const std::string reason = is_english ? judgement.reason : reason_in(language, ask, text, judgement);
  // What an expression lacks to be read is known in English alone, and is a sentence of its own then.
  std::string hint = is_english   ? judgement.hint
                     : ask.number ? judge_number_in(language, *ask.number, text).hint
                     : is_wrong || ask.task || judgement.reason.empty() ? ""
                                                                        : capitalized(judgement.reason) + '.';
  const Phrase& alone = is_wrong ? words::kNotRight : words::kCannotBeRead;
  const Phrase& with_reason = is_wrong ? words::kNotRightFor : words::kCannotBeReadFor;
  return {reason.empty() ? std::string(alone.in(language)) : with_reason.with(language, {reason}),
          std::move(hint)};
}

RichText given_text(const StateTask& task, Language language) {
  const Scene& lesson = *task.scene;
  SteeredState state;
  if (!task.change.contains(Steered::omega)) state.w0_B = lesson.w0_B;
  if (!task.change.contains(Steered::moments)) state.moments = lesson.body.moments.vector();
  if (!task.change.contains(Steered::torque) && !lesson.torque.empty()) {
    const TorqueTerm constant = constant_torque(lesson.torque);
    if (!components_of(constant).isZero(0)) state.torque = constant;
  }
  const std::string line = state_line(state, language);
  if (line.empty()) return {};
  const Phrase& opening = state.w0_B ? words::kGivenAtStart : words::kGivenOpening;
  return line_text(std::string(opening.in(language)) + line + '.');
}

}  // namespace polhode
