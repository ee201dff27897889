// SPDX-License-Identifier: MIT
#include "app/window/panels/derivation_question.h"

#include "app/session/answers/answer_text.h"
#include "app/window/controls/widgets.h"
#include "app/window/panels/answer_controls.h"

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
  const std::string opening = fmt::format("{}   ", number);
  const std::string& tex = line.judgement.tex;
  const bool is_read = line.judgement.mark != Mark::unreadable && !tex.empty();
  return is_read ? opened_by(opening, line_of_tex(tex)) : words_text(opening + line.text);
}

void show_line(PanelContext& context, const DerivationWork::TypedLine& line, std::size_t number,
               bool leads_on) {
  const LineJudgement& verdict = line.judgement;
  if (leads_on) return context.texts.show(numbered(number, line), TextInk::right);
  context.texts.show(numbered(number, line), TextInk::wrong);
  if (verdict.mark == Mark::goal) return;  // too early, which is said below
  const char* what = verdict.mark == Mark::away    ? "Leads away"
                     : verdict.mark == Mark::wrong ? "Not right"
                                                   : "Cannot be read";
  const std::string hint = verdict.hint.empty() ? "" : " (" + verdict.hint + ')';
  quiet_words(fmt::format("{}: {}{}.", what, verdict.reason, hint));
  if (verdict.column > 0) quiet_words(fmt::format("at column {}", verdict.column));
  if (const auto& counter = verdict.counterexample) {
    quiet_words(fmt::format("At {} the left side is {}, the right side {}.", counter->state, counter->left,
                            counter->right));
    show_it_button(context, *counter);
  }
}

void ask_for_line(PanelContext& context, const Ask& ask, DerivationWork& work, std::string& typed) {
  const auto next = [&] {
    context.session.derive(ask, typed);
    const Mark mark = work.lines().back().judgement.mark;
    if (mark == Mark::holds || mark == Mark::goal) typed.clear();
  };
  if (text_field(context, "##line", "the next line, such as a = b + c", "Next", typed)) {
    next();
    keep_typing(!work.is_done());
  }
  work.type(typed);
  ImGui::SameLine();
  if (ImGui::Button("Next") && !typed.empty()) next();
  say_who_has_keys(context);
}

}  // namespace

void ask_for_derivation(PanelContext& context, const Ask& ask, std::string& typed) {
  DerivationWork& work = context.session.derivation(ask);
  context.texts.show(opened_by("From  ", line_of_tex(work.derivation().start.tex)), TextInk::quiet);
  context.texts.show(opened_by("To  ", line_of_tex(work.derivation().goal.tex)), TextInk::quiet);
  for (std::size_t i = 0; i < work.lines().size(); ++i) {
    const Mark mark = work.lines()[i].judgement.mark;
    show_line(context, work.lines()[i], i + 1,
              mark == Mark::holds || (mark == Mark::goal && !work.is_too_short()));
  }
  if (work.is_done()) right_words("The goal is reached.");
  if (work.is_too_short())
    warning_words(fmt::format("That is the goal itself: show how you get there, in at least {} lines.",
                              work.derivation().least_lines));
  if (!work.is_done()) ask_for_line(context, ask, work, typed);
  if (!work.lines().empty() && ImGui::Button("Take back the last line"))
    context.session.undo_derived_line(ask);
}

void show_next_step(PanelContext& context, const Ask& ask) {
  const DerivationWork& work = context.session.derivation(ask);
  if (work.is_done()) {
    quiet_words("The lesson's own way, to compare:");
    for (std::size_t i = 0; i < work.derivation().worked.size(); ++i)
      context.texts.show(
          opened_by(fmt::format("{}   ", i + 1), line_of_tex(work.derivation().worked[i].line.tex)),
          TextInk::quiet);
  }
  const AnswerRecord* record = context.session.record(ask);
  const int shown = record == nullptr ? 0 : record->hints;
  if (work.is_done()) return;
  if (shown > 0)
    if (const std::string hint = work.hint(shown); !hint.empty())
      context.texts.show(opened_by("Hint: ", line_text(hint)), TextInk::quiet);
  // Whatever it says it is the same button, which keeps the focus.
  const char* words = shown == 0 ? "A hint###hint" : shown == 1 ? "How?###hint" : "Show the line###hint";
  if (shown < DerivationWork::kMostHints && ImGui::Button(words)) context.session.show_hint(ask);
}

}  // namespace polhode
