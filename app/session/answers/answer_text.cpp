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
#include "lessons/claims/expressions/expression_variants.h"
#include "lessons/diagnostics/source_text.h"
#include "lessons/notation/tex_equation.h"
#include "lessons/notation/typed/typed_formula.h"
#include "lessons/reader/questions/line_notation.h"
#include "render/scene/model/scene_problem.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

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

std::optional<std::size_t> choice_named(const Ask& ask, std::string_view answer) {
  if (answer.size() != 1 || !picks_choice(ask.type)) return std::nullopt;
  const char c = answer.front();
  const int choice = c >= 'a' ? c - 'a' : c >= 'A' ? c - 'A' : c - '1';
  if (choice < 0 || choice >= static_cast<int>(ask.choices.size())) return std::nullopt;
  return static_cast<std::size_t>(choice);
}

RichText accepted_text(const Lesson& lesson, const Ask& ask, const std::string& accepted) {
  if (accepted.empty()) return {};
  if (const auto choice = choice_named(ask, accepted))
    return opened_by(std::string(1, letter_of_choice(*choice)) + ": ", ask.choice_texts[*choice]);
  if (ask.task) {
    const auto state = parse_state(accepted);
    return state ? line_text(state_line(*state, lesson.about.language) + '.') : words_text(accepted);
  }
  if (ask.expression) {
    const TypedFormula typed = typed_formula(accepted, line_notation(lesson, ask).names);
    return typed.fault ? words_text(accepted) : formula_text(typed.tex);
  }
  return words_text(accepted);
}

namespace {

/// The letters of the language of claims that a part of such a list is written with: "w1" with "omega".
std::set<std::string> letters_of_form(std::string_view form) {
  std::set<std::string> letters;
  std::string word;
  for (const char c : std::string(form) + ' ') {
    if (is_letter(c) || is_digit(c)) {
      word += c;
      continue;
    }
    if (word == "dL") word = "L";
    const bool is_indexed = word.size() == 2 && is_digit(word[1]);
    const std::string name = is_indexed ? (word[0] == 'w' ? "omega" : word.substr(0, 1)) : word;
    const std::vector<std::string> known = quantity_letters();
    if (std::find(known.begin(), known.end(), name) != known.end()) letters.insert(name);
    word.clear();
  }
  return letters;
}

/// Of a list of forms each with the sign before it, "," or ";". What is in brackets parts nothing.
struct Form {
  char sign = ';';
  std::string_view text;
};
std::vector<Form> forms_in(std::string_view list) {
  std::vector<Form> forms;
  char sign = ';';
  int depth = 0;
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= list.size(); ++i) {
    const char c = i < list.size() ? list[i] : ';';
    if (c == '(') ++depth;
    if (c == ')') --depth;
    if (depth > 0 || (c != ',' && c != ';')) continue;
    forms.push_back({sign, trimmed(list.substr(begin, i - begin))});
    sign = c;
    begin = i + 1;
  }
  return forms;
}

}  // namespace

std::string how_to_type(const Ask& ask) {
  const bool derives = static_cast<bool>(ask.derivation);
  std::set<std::string> letters(ask.letters.begin(), ask.letters.end());
  if (derives) letters = ask.derivation->letters;
  const bool takes_rates =
      derives || std::any_of(ask.expression->nodes.begin(), ask.expression->nodes.end(), is_rate);
  std::string all;
  char sign = ',';
  for (const Form& form : forms_in(derives ? kWordsOfDerivations : kWordsOfAnswers)) {
    if (form.sign == ';') sign = ';';
    const bool is_of_rate = form.text.find('\'') != form.text.npos || form.text.find("/dt") != form.text.npos;
    const std::set<std::string> used = letters_of_form(form.text);
    const bool is_known =
        letters.empty() || std::includes(letters.begin(), letters.end(), used.begin(), used.end());
    if ((is_of_rate && !takes_rates) || !is_known) continue;
    if (!all.empty()) all += std::string(1, sign) + ' ';
    all += form.text;
    sign = ',';
  }
  return all;
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
