// SPDX-License-Identifier: MIT
#include "app/window/panels/derivation_question.h"

#include "app/session/answers/answer_text.h"
#include "app/window/controls/widgets.h"
#include "app/window/panels/answer_controls.h"
#include "base/ascii.h"
#include "base/words/answer_words.h"
#include "base/words/edition_words.h"
#include "base/words/page_words.h"
#include "base/words/window_words.h"
#include "lessons/claims/answers/told_in_language.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

namespace polhode {

namespace {

using Mark = LineJudgement::Mark;

/// With fractions as large as on the page.
RichText line_of_tex(const std::string& tex) { return formula_text("\\displaystyle " + tex); }

/// As it is set, or as it was typed where it cannot be read.
RichText numbered(std::size_t number, const DerivationWork::TypedLine& line) {
  const std::string opening = fmt::format("{}.  ", number);
  const std::string& tex = line.judgement.tex;
  const bool is_read = line.judgement.mark != Mark::unreadable && !tex.empty();
  return is_read ? opened_by(opening, line_of_tex(tex)) : words_text(opening + line.text);
}

/// What a line lacks is known in English. In another language that of a slip has words of its own, and the
/// rest is a sentence of its own.
std::vector<std::string> verdict_of_line(const LineJudgement& verdict, Language language) {
  const bool is_wrong = verdict.mark == Mark::wrong, is_away = verdict.mark == Mark::away;
  const Phrase& alone = is_away ? words::kLeadsAway : is_wrong ? words::kNotRight : words::kCannotBeRead;
  const Phrase& with_reason = is_away    ? words::kLeadsAwayFor
                              : is_wrong ? words::kNotRightFor
                                         : words::kCannotBeReadFor;
  if (language == Language::en) {
    const std::string hint = verdict.hint.empty() ? "" : " (" + verdict.hint + ')';
    return {with_reason.with(language, {verdict.reason + hint})};
  }
  const bool has_words = is_wrong && verdict.slip != Slip::none && verdict.slip != Slip::other;
  if (has_words) return {with_reason.with(language, {words_of_reason_in(language, name_of(verdict.slip))})};
  std::vector<std::string> sentences = {std::string(alone.in(language))};
  if (!verdict.reason.empty()) sentences.push_back(capitalized(verdict.reason) + '.');
  return sentences;
}

void show_line(PanelContext& context, const DerivationWork::TypedLine& line, std::size_t number,
               bool leads_on) {
  const LineJudgement& verdict = line.judgement;
  if (leads_on) return context.texts.show(numbered(number, line), TextInk::right);
  context.texts.show(numbered(number, line), TextInk::wrong);
  if (verdict.mark == Mark::goal) return;  // too early, which is said below
  for (const std::string& sentence : verdict_of_line(verdict, context.language())) quiet_words(sentence);
  if (verdict.column > 0)
    quiet_words(words::kAtColumn.with(context.language(), {std::to_string(verdict.column)}));
  if (const auto& counter = verdict.counterexample) {
    quiet_words(words::kSidesAre.with(context.language(), {counter->state, counter->left, counter->right}));
    show_it_button(context, *counter);
  }
}

void ask_for_line(PanelContext& context, const Ask& ask, DerivationWork& work, std::string& typed) {
  const auto next = [&] {
    context.session.derive(ask, typed);
    const Mark mark = work.lines().back().judgement.mark;
    if (mark == Mark::holds || mark == Mark::goal) typed.clear();
  };
  const std::string next_words = context.said(words::kEnterLine);
  if (text_field(context, "##line", context.said(words::kNextLine).c_str(), next_words.c_str(), typed)) {
    next();
    // Behind the last line the focus stays with the panel: the letters of one more are no commands.
    if (!work.is_done()) keep_typing(true);
  }
  work.type(typed);
  ImGui::SameLine();
  if (ImGui::Button(next_words.c_str()) && !typed.empty()) next();
  say_who_has_keys(context);
}

}  // namespace

void ask_for_derivation(PanelContext& context, const Ask& ask, std::string& typed) {
  DerivationWork& work = context.session.derivation(ask);
  context.texts.show(opened_by(context.said(words::kFrom), line_of_tex(work.derivation().start.tex)),
                     TextInk::quiet);
  context.texts.show(opened_by(context.said(words::kTo), line_of_tex(work.derivation().goal.tex)),
                     TextInk::quiet);
  for (std::size_t i = 0; i < work.lines().size(); ++i) {
    const Mark mark = work.lines()[i].judgement.mark;
    show_line(context, work.lines()[i], i + 1,
              mark == Mark::holds || (mark == Mark::goal && !work.is_too_short()));
  }
  if (work.is_done())  // in the lesson's words, since the last line may say it in others
    context.texts.show(
        opened_by(context.said(words::kGoalIsReached), line_of_tex(work.derivation().goal.tex)),
        TextInk::right);
  if (work.is_too_short())
    warning_words(
        words::kGoalWithoutLines.with(context.language(), {std::to_string(work.derivation().least_lines)}));
  if (!work.is_done()) ask_for_line(context, ask, work, typed);
  if (!work.lines().empty() && ImGui::Button(context.said(words::kTakeBackLine).c_str()))
    context.session.undo_derived_line(ask);
}

void show_next_step(PanelContext& context, const Ask& ask) {
  const DerivationWork& work = context.session.derivation(ask);
  if (work.is_done()) {
    quiet_words(context.said(words::kLessonsWay));
    for (std::size_t i = 0; i < work.derivation().worked.size(); ++i)
      context.texts.show(
          opened_by(fmt::format("{}.  ", i + 1), line_of_tex(work.derivation().worked[i].line.tex)),
          TextInk::quiet);
  }
  const AnswerRecord* record = context.session.record(ask);
  const int shown = record == nullptr ? 0 : record->hints;
  if (work.is_done()) return;
  if (shown > 0)
    if (const std::string hint = work.hint(shown); !hint.empty())
      context.texts.show(opened_by(context.said(words::kHintToLine), line_text(hint)), TextInk::quiet);
  // Whatever it says it is the same button, which keeps the focus.
  const Phrase& phrase = shown == 0 ? words::kAHint : shown == 1 ? words::kHow : words::kShowTheLine;
  const std::string words = context.said(phrase) + "###hint";
  if (shown < DerivationWork::kMostHints && ImGui::Button(words.c_str())) context.session.show_hint(ask);
}

}  // namespace polhode
