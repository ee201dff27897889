// SPDX-License-Identifier: MIT
#include "app/publish/text_edition/question_html.h"

#include "app/narration/number_text.h"
#include "app/narration/state_line.h"
#include "base/words/edition_words.h"
#include "base/words/page_words.h"
#include "lessons/claims/expressions/expression_tex.h"
#include "lessons/derivation/derivation.h"
#include "lessons/reader/questions/state_task.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace polhode {

namespace {

using Type = Question::Type;

class QuestionHtml {
 public:
  QuestionHtml(const LessonHtml& html, const Stage& stage, const Ask& ask)
      : html_(html), ask_(ask), id_(html_escaped(stage.id + "/ask." + ask.id)) {}

  std::string all(const std::string& shown) const {
    std::string html = fmt::format(
        "<form class=\"question\" id=\"{0}\" data-type=\"{1}\"{2} "
        "autocomplete=\"off\">\n<p class=\"label\" id=\"{0}.label\">{3}</p>\n<div class=\"prompt\" "
        "id=\"{0}.prompt\">{4}</div>\n",
        id_, is_judged() ? name_of_type() : "open", data(),
        said(ask_.type == Type::predict ? words::kPredictLabel : words::kQuestionLabel),
        html_.blocks(ask_.prompt_text));
    html += controls();
    if (is_judged())
      html += "<p class=\"judge\" hidden=\"hidden\"><button type=\"submit\">" + said(words::kCheck) +
              "</button> <output></output></p>\n";
    for (std::size_t i = 0; i < ask_.hint_texts.size(); ++i)
      html +=
          details("hint",
                  ask_.hint_texts.size() == 1 ? said(words::kHint)
                                              : words::kHintNumber.with(language(), {std::to_string(i + 1)}),
                  html_.blocks(ask_.hint_texts[i]));
    return html +
           details("answer", said(ask_.type == Type::derive ? words::kADerivation : words::kAnswer),
                   answer() + shown) +
           "</form>\n";
  }

 private:
  Language language() const { return html_.lesson().about.language; }
  std::string said(const Phrase& phrase) const { return std::string(phrase.in(language())); }
  const Vocabulary& vocabulary() const { return html_.lesson().notation.vocabulary; }

  bool has_number() const { return ask_.type == Type::number && ask_.number && ask_.number->value; }
  bool is_judged() const { return has_choices(ask_.type) || has_number(); }

  const char* name_of_type() const {
    return ask_.type == Type::number ? "number" : ask_.type == Type::order ? "order" : "choice";
  }

  /// What the script judges by.
  std::string data() const {
    if (has_number())
      return fmt::format(
          " data-value=\"{:.17g}\" data-within=\"{:.17g}\" data-unit=\"{}\" "
          "data-said=\"{}\"",
          *ask_.number->value, tolerance_of(*ask_.number), html_escaped(ask_.number->unit),
          html_escaped(unit_asked_for()));
    return has_choices(ask_.type) ? fmt::format(" data-answer=\"{}\"", fmt::join(ask_.answers, " ")) : "";
  }

  /// As it is printed, but degrees by their word.
  std::string unit_asked_for() const {
    const std::string& unit = ask_.number->unit;
    return unit == "deg" || unit == "°" ? unit_in_words(unit, language()) : unit;
  }

  static std::string details(const char* name, const std::string& summary, const std::string& inside) {
    return fmt::format("<details class=\"{}\"><summary>{}</summary>\n{}</details>\n", name,
                       html_escaped(summary), inside);
  }

  std::string choice_text(std::size_t i) const {
    return fmt::format("<span class=\"letter\">{}.</span> {}", letter_of_choice(i),
                       html_.line(ask_.choice_texts[i]));
  }

  std::string controls() const {
    if (has_number())  // in what, and to within what, stands behind the prompt
      return fmt::format(
          "<p class=\"typed\"><label for=\"{0}.typed\">{1}</label> <input id=\"{0}.typed\" "
          "type=\"text\" inputmode=\"decimal\" size=\"12\" aria-describedby=\"{0}.prompt\"/></p>\n",
          id_, said(words::kYourAnswer));
    if (!has_choices(ask_.type)) return {};
    std::string html = fmt::format(
        "<div class=\"choices\" role=\"{0}\" aria-labelledby=\"{1}.label\" "
        "aria-describedby=\"{1}.prompt\">\n",
        picks_choice(ask_.type) ? "radiogroup" : "group", id_);
    for (std::size_t i = 0; i < ask_.choice_texts.size(); ++i)
      html += picks_choice(ask_.type) ? radio(i) : place(i);
    return html + "</div>\n";
  }

  std::string radio(std::size_t i) const {
    return fmt::format(
        "<div class=\"choice\"><input type=\"radio\" id=\"{0}.{1}\" name=\"{0}\" value=\"{1}\"/> <label "
        "for=\"{0}.{1}\">{2}</label></div>\n",
        id_, i + 1, choice_text(i));
  }

  /// Which place a choice has in the order.
  std::string place(std::size_t i) const {
    std::string options = "<option value=\"\">" + said(words::kPlace) + "</option>";
    for (std::size_t k = 1; k <= ask_.choice_texts.size(); ++k)
      options += fmt::format("<option value=\"{0}\">{0}</option>", k);
    return fmt::format(
        "<div class=\"choice\"><select id=\"{0}.{1}\">{2}</select> <label "
        "for=\"{0}.{1}\">{3}</label></div>\n",
        id_, i + 1, options, choice_text(i));
  }

  std::string answer() const {
    std::string html = right_one();
    for (std::size_t i = 0; i < ask_.replies.size(); ++i)
      if (!ask_.replies[i].empty())
        html += fmt::format("<div class=\"reply\" data-choice=\"{}\"><p class=\"letter\">{}</p>{}</div>\n",
                            i + 1, words::kReplyTo.with(language(), {std::string(1, letter_of_choice(i))}),
                            html_.blocks(ask_.replies[i]));
    if (!ask_.because.empty()) html += "<div class=\"because\">" + html_.blocks(ask_.because) + "</div>\n";
    return html;
  }

  std::string right_one() const {
    if (ask_.derivation) return worked();
    if (ask_.expression)
      return "<p>" + html_.line('$' + tex_of(*ask_.expression, &vocabulary()) + '$') + "</p>\n";
    if (ask_.task) return state();
    if (ask_.number) {
      std::string number = with_decimals(words_of(*ask_.number), language());
      if (number.starts_with('-')) number.replace(0, 1, "−");
      return number.empty() ? "" : "<p>" + html_escaped(number) + "</p>\n";
    }
    const auto text = [&](int answer) { return choice_text(static_cast<std::size_t>(answer - 1)); };
    if (ask_.answers.size() == 1) return "<p class=\"solution\">" + text(ask_.answers.front()) + "</p>\n";
    std::string html = "<ol class=\"solution\">\n";
    for (const int answer : ask_.answers) html += "<li>" + text(answer) + "</li>\n";
    return html + "</ol>\n";
  }

  std::string worked() const {
    const Derivation& derivation = *ask_.derivation;
    std::string html = "<ol class=\"worked\">\n<li value=\"0\">" + formula(derivation.start.tex) + "</li>\n";
    for (const WorkedLine& line : derivation.worked)
      html += fmt::format("<li><p>{} {}</p>{}</li>\n", html_.line(line.point), html_.line(line.teach),
                          formula(line.line.tex));
    return html + "</ol>\n";
  }

  std::string formula(const std::string& tex) const {
    const auto math = parse_math(tex, html_.lesson().macros, language());
    return math ? "<div class=\"formula\">" + html_.formula(*math, tex) + "</div>" : html_escaped(tex);
  }

  std::string state() const {
    std::string html = "<ul>\n";
    for (const StateGoal& goal : ask_.task->goals) {
      const std::string what =
          goal.say.empty() ? '$' + tex_of(goal.number.expression, &vocabulary()) + '$' : goal.say;
      html += fmt::format("<li>{}: {}</li>\n", html_.line(what), html_escaped(range_of(goal, language())));
    }
    return html + "</ul>\n<p>" +
           words::kForExampleTyped.with(language(),
                                        {html_.line(state_line(ask_.task->solution, language()))}) +
           "</p>\n";
  }

  const LessonHtml& html_;
  const Ask& ask_;
  std::string id_;
};

}  // namespace

std::string question_html(const LessonHtml& html, const Stage& stage, const Ask& ask,
                          const std::string& shown) {
  return QuestionHtml(html, stage, ask).all(shown);
}

}  // namespace polhode
