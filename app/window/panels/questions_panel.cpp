// SPDX-License-Identifier: MIT
#include "app/session/answers/answer_text.h"
#include "app/session/answers/progress.h"
#include "app/window/controls/widgets.h"
#include "app/window/panels/answer_controls.h"
#include "app/window/panels/derivation_question.h"
#include "app/window/panels/panels.h"
#include "app/window/panels/progress_table.h"
#include "app/window/panels/state_question.h"
#include "base/words/answer_words.h"
#include "base/words/edition_words.h"
#include "base/words/page_words.h"
#include "base/words/window_words.h"
#include "lessons/notation/typed/typed_formula.h"
#include "lessons/reader/questions/line_notation.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <utility>

namespace polhode {

namespace {

using Mark = AnswerJudgement::Mark;

/// Of the answer that was judged, whatever is typed since.
void show_verdict(PanelContext& context, const Ask& ask, const JudgedAnswer& answer) {
  const AnswerJudgement& verdict = answer.judgement;
  const Language language = context.language();
  const ToldVerdict told = told_verdict(ask, answer.text, verdict, language);
  if (verdict.mark == Mark::right) return right_words(told.verdict);
  warning_words(told.verdict);
  if (verdict.column > 0)
    quiet_words(words::kAtColumnOf.with(language, {std::to_string(verdict.column), answer.text}));
  if (!told.hint.empty()) quiet_words(told.hint);
  if (const auto& counter = verdict.counterexample) {
    quiet_words(words::kYoursAndRight.with(language, {counter->state, counter->left, counter->right}));
    show_it_button(context, *counter);
  }
}

/// Typed, and checked with Enter or the button. What is right needs no other try.
void ask_for_words(PanelContext& context, const Ask& ask, std::string& typed) {
  const Language language = context.language();
  const std::string form = !ask.number ? words::kSuchAs.with(language, {form_of_answer(ask.type)})
                           : ask.number->unit.empty() ? context.said(words::kANumber)
                                                      : words::kANumberIn.with(language, {ask.number->unit});
  const std::string check = context.said(words::kCheck);
  if (text_field(context, "##answer", form.c_str(), check.c_str(), typed))
    keep_typing(context.session.answer(ask, typed).mark != Mark::right);
  ImGui::SameLine();
  if (ImGui::Button(check.c_str()) && !typed.empty()) context.session.answer(ask, typed);
  say_who_has_keys(context);
}

/// What is said of a pick stands below it.
void show_reply(PanelContext& context, const Ask& ask, const JudgedAnswer& answer) {
  const float indent =
      ImGui::CalcTextSize("A").x + 2 * ImGui::GetStyle().FramePadding.x + ImGui::GetStyle().ItemSpacing.x;
  ImGui::Indent(indent);
  if (context.session.is_awaited(ask)) {
    quiet_words(context.said(words::kWatchIt));
    if (ImGui::Button(context.said(words::kSkipToVerdict).c_str())) context.session.end_play();
  } else {
    show_verdict(context, ask, answer);
    context.texts.show(text_after(ask, answer.judgement));
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
    if (toggle_button(letter.c_str(), is_picked, "")) picked = letter;
    ImGui::SameLine();
    if (context.texts.row(letter.c_str(), ask.choice_texts[i])) picked = letter;
    if (is_picked) show_reply(context, ask, *judged);
  }
  if (!picked.empty()) context.session.answer(ask, picked);
}

/// The choices by their letters, to be put in order.
void show_letters(PanelContext& context, const Ask& ask) {
  for (std::size_t i = 0; i < ask.choice_texts.size(); ++i)
    context.texts.show(opened_by(fmt::format("{}.  ", letter_of_choice(i)), ask.choice_texts[i]));
}

/// Hints, and behind the last one the answer; none is offered to who has it.
void show_hints(PanelContext& context, const Ask& ask, bool is_settled) {
  const AnswerRecord* record = context.session.record(ask);
  const AnswerRecord known = record != nullptr ? *record : AnswerRecord();
  const auto shown = std::min(static_cast<std::size_t>(std::max(0, known.hints)), ask.hint_texts.size());
  for (std::size_t i = 0; i < shown; ++i)
    context.texts.show(
        opened_by(words::kHintOpening.with(context.language(), {std::to_string(i + 1)}), ask.hint_texts[i]),
        TextInk::quiet);
  if (!is_settled && is_told(known, ask.hints.size()))
    context.texts.show(
        opened_by(context.said(words::kAnswerOpening), answer_text(context.session.lesson(), ask)));
  AnswerRecord after = known;
  if (is_settled || !note_help(after, ask.hints.size())) return;
  // Whatever it says it is the same button, which keeps the focus.
  const Phrase& phrase = shown == ask.hints.size() ? words::kShowTheAnswer
                         : shown == 0              ? words::kAHint
                                                   : words::kAnotherHint;
  if (ImGui::Button((context.said(phrase) + "###hint").c_str())) context.session.show_hint(ask);
}

/// Whether it was answered right before, and not tried since.
bool is_known(const LessonSession& session, const Ask& ask) {
  const AnswerRecord* record = session.record(ask);
  return session.judged(ask) == nullptr && record != nullptr && record->right > 0;
}

/// Who has answered it right before, and comes back.
void show_known(PanelContext& context, const Ask& ask) {
  if (is_known(context.session, ask)) show_accepted(context, ask);
}

/// What would be forgotten: answers, lines of a derivation, or hints alone.
const Phrase& forgotten_of(const Ask& ask, const AnswerRecord& record, bool is_one) {
  if (record.tries == 0) return is_one ? words::kForgetOneHint : words::kForgetHints;
  if (ask.derivation) return is_one ? words::kForgetOneLine : words::kForgetLines;
  return is_one ? words::kForgetOneAnswer : words::kForgetSomeAnswers;
}

/// "Answered right", or what else is known of a question.
const Phrase& standing_of(const LessonSession& session, const PlacedAsk& question) {
  const auto record = session.answers().find(question.name);
  if (record == session.answers().end() || record->second.tries == 0) return words::kNotAnswered;
  return record->second.right > 0 ? words::kAnsweredRight : words::kNotYetRight;
}

bool is_open(const LessonSession& session, const Ask& ask) {
  const AnswerRecord* record = session.record(ask);
  return record == nullptr || record->right == 0;
}

/// The first behind the question of this number that is typed and was not answered right; null: none.
const Ask* next_typed(const LessonSession& session, std::size_t number) {
  const std::vector<const Ask*> questions = session.questions();
  for (std::size_t i = number + 1; i < questions.size(); ++i)
    if (is_typed(*questions[i]) && is_open(session, *questions[i])) return questions[i];
  return nullptr;
}

/// The field that a panel begins with which was opened by a key: of what is still to be answered.
const Ask* first_typed(const LessonSession& session) {
  const std::vector<const Ask*> questions = session.questions();
  const auto first_with = [&](auto&& is_wanted) {
    const auto found = std::find_if(questions.begin(), questions.end(), is_wanted);
    return found == questions.end() ? nullptr : *found;
  };
  const Ask* open = first_with([&](const Ask* ask) { return is_typed(*ask) && is_open(session, *ask); });
  return open != nullptr ? open : first_with([](const Ask* ask) { return is_typed(*ask); });
}

}  // namespace

/// Asks once: what is forgotten does not come back.
void QuestionsPanel::draw_forget(PanelContext& context, const Ask& ask) {
  const AnswerRecord* record = context.session.record(ask);
  if (record == nullptr) return;
  const std::string name = context.session.stage().id + '/' + ask.id;
  if (forgetting_ != name) {
    if (ImGui::Button(context.said(words::kForgetAnswers).c_str())) forgetting_ = name;
    return;
  }
  const int count = record->tries > 0 ? record->tries : record->hints;
  const bool is_one = count == 1;
  const Phrase& phrase = forgotten_of(ask, *record, is_one);
  plain_words(is_one ? context.said(phrase) : phrase.with(context.language(), {std::to_string(count)}));
  if (ImGui::Button(context.said(is_one ? words::kForgetIt : words::kForgetThem).c_str())) {
    context.session.forget_answer(ask);
    forgetting_.clear();
  }
  ImGui::SameLine();
  if (ImGui::Button(context.said(is_one ? words::kKeepIt : words::kKeepThem).c_str())) forgetting_.clear();
}

/// As it is read: below the field in which it is typed.
void QuestionsPanel::draw_as_set(PanelContext& context, const Ask& ask) {
  const LessonSession& session = context.session;
  const std::string name = session.stage().id + '/' + ask.id;
  const std::string& typed = typed_[name];
  SetExpression& set = set_[name];
  if (set.typed != typed)
    set = {typed, typed.empty() ? "" : typed_formula(typed, line_notation(session.lesson(), ask).names).tex};
  if (!set.tex.empty()) context.texts.show(formula_text("\\displaystyle " + set.tex));
}

void QuestionsPanel::draw_question(PanelContext& context, const Ask& ask, std::size_t number,
                                   std::size_t count) {
  ImGui::PushID(ask.id.c_str());
  const std::string of_all =
      words::kQuestionNumber.with(context.language(), {std::to_string(number), std::to_string(count)});
  heading(count > 1 ? of_all.c_str() : context.said(words::kQuestionLabel).c_str());
  // What leads where in a derivation stands below, as it is typed; and goals with how far they are.
  const bool has_more_below = ask.derivation || ask.task;
  context.texts.show(has_more_below ? RichText{ask.prompt_text.front()} : ask.prompt_text);
  std::string& typed = typed_[context.session.stage().id + '/' + ask.id];
  bool is_settled = false;
  switch (ask.type) {
    case Ask::Type::order:
      show_letters(context, ask);
      quiet_words(context.said(words::kPutInOrder));
      ask_for_words(context, ask, typed);
      break;
    case Ask::Type::expression:
      ask_for_words(context, ask, typed);
      draw_as_set(context, ask);
      break;
    case Ask::Type::number:
      ask_for_words(context, ask, typed);
      break;
    case Ask::Type::choice:
    case Ask::Type::predict:
      ask_for_choice(context, ask);
      break;
    case Ask::Type::state:
      is_settled = ask_for_state(context, ask);
      break;
    case Ask::Type::derive:
      ask_for_derivation(context, ask, typed);
      show_next_step(context, ask);
      break;
  }
  const JudgedAnswer* answer = context.session.judged(ask);
  if (!ask.derivation && !ask.task) {
    const bool is_of_typed = typed.empty() || answer == nullptr || typed == answer->text;
    if (answer != nullptr && answer->judgement.choice == 0 && is_of_typed) {
      show_verdict(context, ask, *answer);
      context.texts.show(text_after(ask, answer->judgement));
    }
    is_settled =
        is_known(context.session, ask) || (answer != nullptr && answer->judgement.mark == Mark::right);
    show_known(context, ask);
  }
  if (!context.session.is_awaited(ask)) {
    if (!ask.derivation) show_hints(context, ask, is_settled);
    draw_forget(context, ask);
  }
  ImGui::PopID();
}

/// Those of the stage that stand on steps before this one, to go back to.
void QuestionsPanel::draw_earlier(PanelContext& context, bool is_alone) {
  LessonSession& session = context.session;
  const StepPlace here = session.place();
  std::vector<PlacedAsk> earlier = questions_of_stage(session.lesson(), here.stage);
  std::erase_if(earlier, [&](const PlacedAsk& question) { return question.place.step >= here.step; });
  if (is_alone) quiet_words(context.said(words::kNoQuestion));
  if (earlier.empty()) return;
  heading(context.said(words::kEarlierInStage).c_str());
  std::optional<StepPlace> chosen;
  for (const PlacedAsk& question : earlier) {
    const std::string opening = words::kEarlierStep.with(
        context.language(),
        {std::to_string(question.place.step + 1), standing_of(session, question).in(context.language())});
    const RichText words = opened_by(opening, {question.ask->prompt_text.front()});
    if (context.texts.row(question.name.c_str(), words, TextInk::quiet)) chosen = question.place;
  }
  if (chosen) session.go_to(*chosen);
}

void QuestionsPanel::draw(PanelContext& context) {
  const std::vector<const Ask*> questions = context.session.questions();
  const bool is_end = !context.session.next_place();
  const Ask* focused = std::exchange(context.take_focus, false)
                           ? (context.typed_to != nullptr ? context.typed_to : first_typed(context.session))
                           : nullptr;
  for (std::size_t i = 0; i < questions.size(); ++i) {
    context.take_focus = questions[i] == focused;
    const bool was_open = is_open(context.session, *questions[i]);
    draw_question(context, *questions[i], i + 1, questions.size());
    // Who has typed what is right goes on typing, if there is more.
    if (is_typed(*questions[i]) && was_open && !is_open(context.session, *questions[i]))
      focused = next_typed(context.session, i);
  }
  context.take_focus = false;
  if (is_end) {
    draw_summary(context);
    draw_lessons(context);
  }
  const auto written = std::find_if(questions.begin(), questions.end(), [](const Ask* ask) {
    return ask->derivation || ask->expression;  // choices are picked, not written
  });
  if (written != questions.end()) {
    heading(context.said(words::kHowToWrite).c_str());
    quiet_words(how_to_type(**written));
  }
  if (!is_end) draw_earlier(context, questions.empty());
}

}  // namespace polhode
