// SPDX-License-Identifier: MIT
#include "lessons/reader/checks/question_check.h"

#include "base/numbers.h"
#include "base/utf8.h"
#include "lessons/claims/expressions/dimension.h"
#include "lessons/diagnostics/report.h"
#include "lessons/reader/checks/lint_budget.h"
#include "render/scene/model/model.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace polhode {
namespace {

class QuestionCheck {
 public:
  QuestionCheck(const Lesson& lesson, std::string_view file, const Effort& effort)
      : lesson_(lesson), source_(lesson.source), report_(source_, file), effort_(effort) {}

  std::vector<Diagnostic> run() {
    for (const Stage& stage : lesson_.stages)
      for (const Step& step : stage.steps)
        for (const Ask* ask : blocks_of<Ask>(step)) {
          if (picks_choice(ask->type)) picked_.push_back({ask, stage.id + '/' + ask->id});
          check_replies(*ask);
          check_choices(*ask);
          if (ask->number) check_number(*ask, *ask->number, step);
          if (ask->plays) check_play(*ask, *ask->plays, step);
        }
    if (static_cast<int>(picked_.size()) >= kLeastChoicesToCount) {
      check_letters();
      check_lengths();
    }
    return report_.take();
  }

 private:
  struct Picked {
    const Ask* ask;
    std::string name;
    std::size_t answer() const { return static_cast<std::size_t>(ask->answers.front() - 1); }
  };

  void check_replies(const Ask& ask) {
    if (!ask.is_listed || !picks_choice(ask.type)) return;
    std::string letters;
    for (std::size_t i = 0; i < ask.replies.size(); ++i)
      if (ask.replies[i].empty() && static_cast<int>(i) + 1 != ask.answers.front())
        letters += (letters.empty() ? "" : ", ") + in_quotes(ask.choices[i]);
    if (!letters.empty())
      report_.warning(ask.place, "who picks " + letters + " is not told why it is wrong",
                      "write a reply below the choice, indented by two blanks");
  }

  /// Two that read the same would be right and wrong at once.
  void check_choices(const Ask& ask) {
    const auto words = [](const std::string& text) {
      std::string joined;
      for (const char c : text)
        if (c != ' ' || !joined.ends_with(' ')) joined += c;
      return std::string(trimmed(joined));
    };
    for (std::size_t i = 0; i < ask.choices.size(); ++i)
      for (std::size_t k = i + 1; k < ask.choices.size(); ++k)
        if (words(ask.choices[i]) == words(ask.choices[k]))
          report_.error(ask.place, "two choices are the same: " + in_quotes(ask.choices[i]),
                        "leave one out, or say how they differ");
  }

  /// "How large is it in kJ?": the unit that a prompt names behind "in", at its end, is that of the answer.
  void check_unit_of_prompt(const Ask& ask, const NumberAnswer& number) {
    std::string prompt = ask.prompt;
    while (!prompt.empty() && std::string_view(" .?!)").find(prompt.back()) != std::string_view::npos)
      prompt.pop_back();
    const std::size_t in = prompt.rfind(" in ");
    if (in == prompt.npos) return;
    const std::string named(trimmed(std::string_view(prompt).substr(in + 4)));
    static const std::map<std::string, std::string, std::less<>> kInWords = {
        {"degrees", "deg"}, {"radians", "rad"},  {"joules", "J"}, {"seconds", "s"},
        {"metres", "m"},    {"kilograms", "kg"}, {"hertz", "Hz"}};
    const auto word = kInWords.find(named);
    const std::string unit = word == kInWords.end() ? named : word->second;
    const auto said = scaled_unit(unit), asked = scaled_unit(number.unit);
    if (unit.empty() || !said || !asked) return;
    const bool is_same_size = std::abs(said->size - asked->size) <= 1e-12 * asked->size;
    if (said->dimension == asked->dimension && is_same_size) return;
    report_.error(ask.place,
                  "the prompt of question " + in_quotes(ask.id) + " asks for " + named +
                      ", and its unit is " + (number.unit.empty() ? "none" : number.unit),
                  "make both the same");
  }

  void check_number(const Ask& ask, const NumberAnswer& number, const Step& step) {
    if (lesson_.about.language == Language::en) check_unit_of_prompt(ask, number);
    const std::string what = "the answer of question " + in_quotes(ask.id);
    if (number.expression && !step.scene)
      return report_.error(ask.place, what + " needs a scene, on whose motion it is computed",
                           "add a ```scene fence to this step or above it");
    if (!number.value)
      return report_.error(ask.place, what + " has no value on the scene's motion at t = " +
                                          digits(still_time_s(*step.scene), 3) + " s");
    const double size = std::abs(*number.value), within = tolerance_of(number);
    if (size == 0 || within >= size)
      report_.error(
          ask.place,
          what + " is " + digits(*number.value, 3) + ", and 0 is right too, within " + number.within_text,
          "ask for a number that is not 0, or write a smaller \"within\"");
    else if (within > kMostWithin * size)
      report_.error(ask.place,
                    what + " is " + digits(*number.value, 3) + ", and " + number.within_text +
                        " of tolerance decides nothing",
                    "at most a fifth of the answer does");
  }

  void check_play(const Ask& ask, const PlayedInterval& play, const Step& step) {
    const auto fail = [&](const std::string& message, std::string hint) {
      report_.error(ask.place, "question " + in_quotes(ask.id) + ' ' + message, std::move(hint));
    };
    if (!step.scene) return fail("plays a motion, and its step has none", "add a ```scene fence");
    if (step.scene->duration_s && (play.from_s < 0 || play.to_s > *step.scene->duration_s))
      return fail("plays beyond the scene's duration, " + digits(*step.scene->duration_s, 4) + " s",
                  "what is played lies between 0 and it");
    try {
      Scene scene = *step.scene;
      scene.beside.clear();
      scene.before = 0;
      const SceneModel model = make_model(scene, ModelFor::figure, effort_);
      if (!is_computable(model, play.from_s) || !is_computable(model, play.to_s))
        return fail("plays to t = " + digits(play.to_s, 4) + " s, where the motion cannot be followed",
                    "end earlier");
      const double shown_s = (play.to_s - play.from_s) / model.rate;
      if (shown_s > kLongestPlay_s)
        report_.warning(ask.place,
                        "question " + in_quotes(ask.id) + " plays for " + digits(shown_s, 3) +
                            " s before it says what is right",
                        "play a shorter part, or write a larger \"rate\"");
    } catch (const BudgetSpent&) {
      const Diagnostic all = too_long_to_check("", ask.place);
      report_.error(ask.place, all.message, all.hint);
    } catch (const std::domain_error&) {  // no such motion: who checks the scenes says so
    }
  }

  static std::string listed(const std::vector<const Picked*>& questions) {
    std::string names;
    for (const Picked* one : questions) names += (names.empty() ? "" : ", ") + one->name;
    return names;
  }

  void check_letters() {
    std::map<std::size_t, std::vector<const Picked*>> by_letter;
    for (const Picked& one : picked_) by_letter[one.answer()].push_back(&one);
    for (const auto& [letter, questions] : by_letter)
      if (static_cast<double>(questions.size()) > kMostUnderOneLetter * static_cast<double>(picked_.size()))
        report_.warning(questions.front()->ask->place,
                        "in " + std::to_string(questions.size()) + " of " + std::to_string(picked_.size()) +
                            " questions the right choice is " + letter_of_choice(letter) + ": " +
                            listed(questions),
                        "choices that are a list are shuffled; with shuffle = false yours is the order");
  }

  void check_lengths() {
    std::vector<const Picked*> longest;
    for (const Picked& one : picked_) {
      const auto length = [&](std::size_t i) { return count_characters(one.ask->choices[i]); };
      bool is_longest = true;
      for (std::size_t i = 0; i < one.ask->choices.size(); ++i)
        is_longest = is_longest && (i == one.answer() || length(i) < length(one.answer()));
      if (is_longest) longest.push_back(&one);
    }
    if (static_cast<double>(longest.size()) > kMostLongest * static_cast<double>(picked_.size()))
      report_.warning(longest.front()->ask->place,
                      "in " + std::to_string(longest.size()) + " of " + std::to_string(picked_.size()) +
                          " questions the right choice is the longest: " + listed(longest),
                      "move what explains it into its reply or into \"because\"");
  }

  const Lesson& lesson_;
  SourceText source_;
  Report report_;
  const Effort& effort_;
  std::vector<Picked> picked_;  ///< all questions for one choice
};

}  // namespace

std::vector<Diagnostic> check_questions(const Lesson& lesson, std::string_view file_name,
                                        const Effort& effort) {
  return QuestionCheck(lesson, file_name, effort).run();
}

}  // namespace polhode
