// SPDX-License-Identifier: MIT
#include "app/window/controls/widgets.h"
#include "app/window/panels/panels.h"
#include "app/window/panels/state_question.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

namespace polhode {

namespace {

/// Of the answer that was judged, whatever is typed since.
void show_verdict(PanelContext& context, const JudgedAnswer& answer) {
  const AnswerJudgement& verdict = answer.judgement;
  using Mark = AnswerJudgement::Mark;
  const bool right = verdict.mark == Mark::right;
  const std::string word = verdict.mark == Mark::wrong ? "Not right" : "Cannot be read";
  if (right) return right_words("Right.");
  warning_words(verdict.reason.empty() ? word + "." : fmt::format("{}: {}.", word, verdict.reason));
  if (verdict.column > 0) quiet_words(fmt::format("at column {} of {}", verdict.column, answer.text));
  if (!verdict.hint.empty()) quiet_words(verdict.hint);
  if (const auto& counter = verdict.counterexample) {
    quiet_words(
        fmt::format("At {} yours is {}, right is {}.", counter->state, counter->left, counter->right));
    show_it_button(context, *counter);
  }
}

/// Typed, and checked with Enter or the button.
void ask_for_words(PanelContext& context, const Ask& ask, std::string& typed) {
  const float check = ImGui::CalcTextSize("Check").x + 2 * ImGui::GetStyle().FramePadding.x;
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - check - ImGui::GetStyle().ItemSpacing.x);
  if (context.take_focus) ImGui::SetKeyboardFocusHere();
  const std::string form = fmt::format("such as {}", form_of_answer(ask.type));
  const bool entered =
      ImGui::InputTextWithHint("##answer", form.c_str(), &typed, ImGuiInputTextFlags_EnterReturnsTrue);
  if (entered) ImGui::SetKeyboardFocusHere(-1);  // for another try
  ImGui::SameLine();
  if ((ImGui::Button("Check") || entered) && !typed.empty()) context.session.answer(ask, typed);
}

/// Controls set no formulas: what has some is to be read where it is set.
void words_or_see_page(const PanelContext& context, const std::string& markdown, const RichText& text) {
  if (markdown.find('$') != markdown.npos) return quiet_words("as on the page");
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(context.speech.words(text).c_str());
  ImGui::PopTextWrapPos();
}

void show_line(PanelContext& context, const DerivationWork::TypedLine& line, std::size_t number) {
  using Mark = LineJudgement::Mark;
  const LineJudgement& verdict = line.judgement;
  const std::string words = fmt::format("{}   {}", number, line.text);
  if (verdict.mark == Mark::goal || verdict.mark == Mark::holds) return right_words(words.c_str());
  warning_words(words);
  const std::string what = verdict.mark == Mark::away    ? ""
                           : verdict.mark == Mark::wrong ? "Not right: "
                                                         : "Cannot be read: ";
  quiet_words(fmt::format("{}{}.{}", what, verdict.reason, verdict.hint.empty() ? "" : " " + verdict.hint));
  if (verdict.column > 0) quiet_words(fmt::format("at column {}", verdict.column));
  if (const auto& counter = verdict.counterexample) {
    quiet_words(fmt::format("At {} the left side is {}, the right side {}.", counter->state, counter->left,
                            counter->right));
    show_it_button(context, *counter);
  }
}

/// Line after line, each judged as it is entered; the goal stays in sight.
void derive(PanelContext& context, const Ask& ask, std::string& typed) {
  DerivationWork& work = context.session.derivation(ask);
  quiet_words(fmt::format("From  {}", work.derivation().start.typed));
  quiet_words(fmt::format("To    {}", work.derivation().goal.typed));
  for (std::size_t i = 0; i < work.lines().size(); ++i) show_line(context, work.lines()[i], i + 1);
  if (work.is_done()) right_words("The goal is reached.");
  if (work.is_too_short())
    warning_words(fmt::format("That is the goal itself: show how you get there, in at least {} lines.",
                              work.derivation().least_lines));
  if (!work.is_done()) {
    const float check = ImGui::CalcTextSize("Next").x + 2 * ImGui::GetStyle().FramePadding.x;
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - check - ImGui::GetStyle().ItemSpacing.x);
    if (context.take_focus) ImGui::SetKeyboardFocusHere();
    const bool entered = ImGui::InputTextWithHint("##line", "the next line, such as a = b + c", &typed,
                                                  ImGuiInputTextFlags_EnterReturnsTrue);
    if (entered) ImGui::SetKeyboardFocusHere(-1);
    work.type(typed);
    ImGui::SameLine();
    if ((ImGui::Button("Next") || entered) && !typed.empty()) {
      context.session.derive(ask, typed);
      const auto mark = work.lines().back().judgement.mark;
      if (mark == LineJudgement::Mark::holds || mark == LineJudgement::Mark::goal) typed.clear();
    }
  }
  if (!work.lines().empty() && ImGui::Button("Take back the last line"))
    context.session.undo_derived_line(ask);
}

/// What to use, how, and the line itself: one after the other, for the step that comes next.
void show_next_step(PanelContext& context, const Ask& ask) {
  const DerivationWork& work = context.session.derivation(ask);
  const AnswerRecord* record = context.session.record(ask);
  const int shown = record == nullptr ? 0 : record->hints;
  if (!work.is_done()) {
    if (shown > 0)
      if (const std::string hint = work.hint(shown); !hint.empty())
        quiet_words("Hint: " + context.speech.words_of_line(hint));
    if (shown < DerivationWork::kMostHints) {
      if (ImGui::Button(shown == 0 ? "A hint" : shown == 1 ? "How?" : "Show the line"))
        context.session.show_hint(ask);
      if (record) ImGui::SameLine();
    }
  }
  if (record && ImGui::Button("Begin again")) context.session.forget_answer(ask);
}

void ask_for_choice(PanelContext& context, const Ask& ask, std::string& typed) {
  for (std::size_t i = 0; i < ask.choices.size(); ++i) {
    const std::string letter(1, letter_of_choice(i));
    if (toggle_button(letter.c_str(), typed == letter, "")) {
      typed = letter;
      context.session.answer(ask, typed);
    }
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    words_or_see_page(context, ask.choices[i], ask.choice_texts[i]);
  }
}

void show_hints(PanelContext& context, const Ask& ask) {
  const AnswerRecord* record = context.session.record(ask);
  const auto shown = static_cast<std::size_t>(record ? record->hints : 0);
  for (std::size_t i = 0; i < std::min(shown, ask.hint_texts.size()); ++i)
    quiet_words(fmt::format("Hint {}: {}", i + 1, context.speech.words(ask.hint_texts[i])));
  if (shown < ask.hints.size()) {
    if (ImGui::Button(shown == 0 ? "A hint" : "Another hint")) context.session.show_hint(ask);
    if (record) ImGui::SameLine();
  }
  if (record && ImGui::Button("Forget my answers")) context.session.forget_answer(ask);
}

}  // namespace

void QuestionsPanel::draw_question(PanelContext& context, const Ask& ask, std::size_t number,
                                   std::size_t count) {
  ImGui::PushID(ask.id.c_str());
  heading(count > 1 ? fmt::format("Question {} of {}", number, count).c_str() : "Question");
  // What leads where in a derivation stands below, as it is typed; and goals with how far they are.
  const bool has_more_below = ask.derivation || ask.task;
  const RichText words = has_more_below ? RichText{ask.prompt_text.front()} : ask.prompt_text;
  words_or_see_page(context, ask.prompt, words);
  std::string& typed = typed_[context.session.stage().id + '/' + ask.id];
  switch (ask.type) {
    case Ask::Type::expression:
      ask_for_words(context, ask, typed);
      break;
    case Ask::Type::order:
      quiet_words("Put the letters in order.");
      ask_for_words(context, ask, typed);
      break;
    case Ask::Type::choice:
    case Ask::Type::predict:
      ask_for_choice(context, ask, typed);
      break;
    case Ask::Type::state:
      ask_for_state(context, ask);
      show_hints(context, ask);
      ImGui::PopID();
      return;
    case Ask::Type::derive:
      derive(context, ask, typed);
      show_next_step(context, ask);
      ImGui::PopID();
      return;
  }
  if (const JudgedAnswer* answer = context.session.judged(ask))
    show_verdict(context, *answer);
  else if (const AnswerRecord* record = context.session.record(ask); record && record->right)
    quiet_words("You have answered this one right.");
  show_hints(context, ask);
  ImGui::PopID();
}

void QuestionsPanel::draw(PanelContext& context) {
  const std::vector<const Ask*> questions = context.session.questions();
  if (questions.empty()) return quiet_words("This step asks nothing.");
  for (std::size_t i = 0; i < questions.size(); ++i) {
    draw_question(context, *questions[i], i + 1, questions.size());
    context.take_focus = false;
  }
  const auto is_written = [](const Ask* ask) { return ask->task == nullptr; };
  if (std::none_of(questions.begin(), questions.end(), is_written)) return;
  heading("How to write it");
  const bool derives = std::any_of(questions.begin(), questions.end(),
                                   [](const Ask* ask) { return ask->derivation != nullptr; });
  quiet_words(std::string(derives ? kWordsOfDerivations : kWordsOfAnswers));
}

}  // namespace polhode
