// SPDX-License-Identifier: MIT
#include "app/window/controls/widgets.h"
#include "app/window/panels/panels.h"
#include "app/window/panels/progress_table.h"
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
  // Of a choice the reason is the whole sentence: "A is not right".
  const bool is_sentence = verdict.choice > 0;
  warning_words(verdict.reason.empty() ? word + "."
                : is_sentence          ? verdict.reason + '.'
                                       : fmt::format("{}: {}.", word, verdict.reason));
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
  const std::string form = ask.number
                               ? "a number" + (ask.number->unit.empty() ? "" : " in " + ask.number->unit)
                               : fmt::format("such as {}", form_of_answer(ask.type));
  const bool entered =
      ImGui::InputTextWithHint("##answer", form.c_str(), &typed, ImGuiInputTextFlags_EnterReturnsTrue);
  if (entered) ImGui::SetKeyboardFocusHere(-1);  // for another try
  ImGui::SameLine();
  if ((ImGui::Button("Check") || entered) && !typed.empty()) context.session.answer(ask, typed);
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

/// The words of a choice beside its letter, which a click picks as well. Formulas are said: controls set
/// none.
bool choice_words(const std::string& words) {
  const ImVec2 at = ImGui::GetCursorPos();
  const float width = ImGui::GetContentRegionAvail().x, padding = ImGui::GetStyle().FramePadding.y;
  const float height = ImGui::CalcTextSize(words.c_str(), nullptr, false, width).y + 2 * padding;
  const bool is_picked = ImGui::Selectable("##words", false, 0, {width, height});
  const ImVec2 below = ImGui::GetCursorPos();
  ImGui::SetCursorPos({at.x, at.y + padding});
  plain_words(words);
  ImGui::SetCursorPos(below);
  return is_picked;
}

/// What is said of a pick stands below it.
void show_reply(PanelContext& context, const Ask& ask, const JudgedAnswer& answer) {
  const float indent =
      ImGui::CalcTextSize("A").x + 2 * ImGui::GetStyle().FramePadding.x + ImGui::GetStyle().ItemSpacing.x;
  ImGui::Indent(indent);
  if (context.session.is_awaited(ask)) {
    quiet_words("Watch what it does.");
    if (ImGui::Button("Skip to the verdict")) context.session.end_play();
  } else {
    show_verdict(context, answer);
    plain_words(context.speech.words_after(ask, answer.judgement));
  }
  ImGui::Unindent(indent);
}

void ask_for_choice(PanelContext& context, const Ask& ask) {
  const JudgedAnswer* judged = context.session.judged(ask);
  const int picked_before = judged != nullptr ? judged->judgement.choice : 0;
  std::string picked;
  for (std::size_t i = 0; i < ask.choices.size(); ++i) {
    const std::string letter(1, letter_of_choice(i));
    const bool is_picked = picked_before == static_cast<int>(i) + 1;
    ImGui::PushID(letter.c_str());
    if (toggle_button(letter.c_str(), is_picked, "")) picked = letter;
    ImGui::SameLine();
    if (choice_words(context.speech.words(ask.choice_texts[i]))) picked = letter;
    ImGui::PopID();
    if (is_picked) show_reply(context, ask, *judged);
  }
  if (!picked.empty()) context.session.answer(ask, picked);
}

/// Hints, and behind the last one the answer; none is offered to who has it.
void show_hints(PanelContext& context, const Ask& ask, bool is_settled) {
  const AnswerRecord* record = context.session.record(ask);
  const AnswerRecord known = record != nullptr ? *record : AnswerRecord();
  const auto shown = std::min(static_cast<std::size_t>(std::max(0, known.hints)), ask.hint_texts.size());
  for (std::size_t i = 0; i < shown; ++i)
    quiet_words(fmt::format("Hint {}: {}", i + 1, context.speech.words(ask.hint_texts[i])));
  if (!is_settled && is_told(known, ask.hints.size()))
    plain_words("The answer is " + context.speech.words_of_answer(ask));
  AnswerRecord after = known;
  if (!is_settled && note_help(after, ask.hints.size())) {
    const char* words = shown == ask.hints.size() ? "Show the answer"
                        : shown == 0              ? "A hint"
                                                  : "Another hint";
    if (ImGui::Button(words)) context.session.show_hint(ask);
    if (record != nullptr) ImGui::SameLine();
  }
  if (record != nullptr && ImGui::Button("Forget my answers")) context.session.forget_answer(ask);
}

}  // namespace

void QuestionsPanel::draw_question(PanelContext& context, const Ask& ask, std::size_t number,
                                   std::size_t count) {
  ImGui::PushID(ask.id.c_str());
  heading(count > 1 ? fmt::format("Question {} of {}", number, count).c_str() : "Question");
  // What leads where in a derivation stands below, as it is typed; and goals with how far they are.
  const bool has_more_below = ask.derivation || ask.task;
  const RichText words = has_more_below ? RichText{ask.prompt_text.front()} : ask.prompt_text;
  plain_words(context.speech.words(words));
  std::string& typed = typed_[context.session.stage().id + '/' + ask.id];
  switch (ask.type) {
    case Ask::Type::expression:
    case Ask::Type::number:
      ask_for_words(context, ask, typed);
      break;
    case Ask::Type::order:
      quiet_words("Put the letters in order.");
      ask_for_words(context, ask, typed);
      break;
    case Ask::Type::choice:
    case Ask::Type::predict:
      ask_for_choice(context, ask);
      break;
    case Ask::Type::state:
      ask_for_state(context, ask);
      show_hints(context, ask, false);
      ImGui::PopID();
      return;
    case Ask::Type::derive:
      derive(context, ask, typed);
      show_next_step(context, ask);
      ImGui::PopID();
      return;
  }
  const JudgedAnswer* answer = context.session.judged(ask);
  const AnswerRecord* record = context.session.record(ask);
  if (answer != nullptr && answer->judgement.choice == 0) {
    show_verdict(context, *answer);
    plain_words(context.speech.words_after(ask, answer->judgement));
  }
  if (answer == nullptr && record != nullptr && record->right > 0)
    quiet_words("You have answered this one right.");
  const bool is_right = answer != nullptr && answer->judgement.mark == AnswerJudgement::Mark::right;
  show_hints(context, ask, is_right && !context.session.is_awaited(ask));
  ImGui::PopID();
}

void QuestionsPanel::draw(PanelContext& context) {
  const std::vector<const Ask*> questions = context.session.questions();
  const bool is_end = !context.session.next_place();
  if (questions.empty() && !is_end) return quiet_words("There is no question on this step.");
  for (std::size_t i = 0; i < questions.size(); ++i) {
    draw_question(context, *questions[i], i + 1, questions.size());
    context.take_focus = false;
  }
  if (is_end) draw_summary(context);
  if (questions.empty()) return;
  const auto asks_for = [&](Ask::Type type) {
    return std::any_of(questions.begin(), questions.end(), [=](const Ask* ask) { return ask->type == type; });
  };
  const bool derives = asks_for(Ask::Type::derive);
  if (!derives && !asks_for(Ask::Type::expression)) return;  // choices are picked, not written
  heading("How to write it");
  quiet_words(std::string(derives ? kWordsOfDerivations : kWordsOfAnswers));
}

}  // namespace polhode
