// SPDX-License-Identifier: MIT
#include "lessons/reader/questions/number_question.h"

#include "base/numbers.h"
#include "base/words/page_words.h"
#include "lessons/claims/motion_words.h"
#include "lessons/reader/checks/lint_budget.h"
#include "lessons/reader/front_matter/keys.h"

#include <cmath>
#include <stdexcept>

namespace polhode {
namespace {

bool is_degrees(const std::string& unit) { return unit == "deg" || unit == "°"; }

class NumberReader {
 public:
  NumberReader(const TomlTable& keys, TextReader& texts)
      : keys_(keys), texts_(texts), report_(texts.report()) {
    answer_.language = texts.written_in();
  }

  std::optional<NumberAnswer> read() {
    SourcePlace unit_place;
    if (const TomlEntry* unit = keys_.find("unit")) {
      read_unit(*unit);
      unit_place = unit->value.place;
    }
    if (!ok_) return std::nullopt;
    read_answer(*keys_.find("answer"), unit_place);
    if (const TomlEntry* within = keys_.find("within")) read_within(*within);
    return ok_ ? std::optional(std::move(answer_)) : std::nullopt;
  }

 private:
  void fail(SourcePlace place, std::string message, std::string hint = {}) {
    report_.error(place, std::move(message), std::move(hint));
    ok_ = false;
  }

  void read_unit(const TomlEntry& entry) {
    const auto text = read_text(entry, report_);
    ok_ = ok_ && text;
    if (!text) return;
    const auto unit = scaled_unit(*text);
    if (!unit || text->empty())
      return fail(entry.value.place, "unknown unit " + in_quotes(*text),
                  "the units of numbers are " + std::string(kUnitNames));
    answer_.unit = *text;
    answer_.unit_si = unit->size;
  }

  void read_answer(const TomlEntry& entry, SourcePlace unit_place) {
    if (entry.value.as<std::string>() == nullptr) {
      answer_.value = read_number(entry, report_);
      ok_ = ok_ && answer_.value;
      return;
    }
    LiveNumber written;
    written.expression = *entry.value.as<std::string>();
    written.unit = answer_.unit;
    auto number = texts_.computed_number(written, inside_quotes(entry.value.place), unit_place);
    ok_ = ok_ && number;
    if (!number) return;
    if (answer_.unit.empty())
      if (const auto dimension = dimension_of(number->expression, texts_.dimensions()).dimension;
          dimension && *dimension != kNumber)
        fail(entry.value.place, "this is in " + to_string(*dimension) + ", and the question has no unit",
             "add unit = \"…\"");
    answer_.expression = std::move(number->expression);
  }

  /// 0.05 is relative, "0.5 deg" is not.
  void read_within(const TomlEntry& entry) {
    if (entry.value.as<std::string>() == nullptr) {
      const auto number = read_positive_number(entry, report_);
      ok_ = ok_ && number;
      if (!number) return;
      if (*number > kMostWithin)
        return fail(entry.value.place, "this decides nothing: nearly every answer is within it",
                    "0.02 allows for 2 % of the answer, at most " + digits(kMostWithin, 3) +
                        " can be; \"0.5 deg\" is a tolerance in a unit");
      answer_.within = *number;
      answer_.within_text = digits(100 * *number, 4) + " %";
      return;
    }
    const std::string& text = *entry.value.as<std::string>();
    const std::size_t blank = text.find(' ');
    const auto number = parse_number(text.substr(0, blank));
    const auto unit = scaled_unit(blank == text.npos ? "" : text.substr(blank + 1));
    const auto asked = scaled_unit(answer_.unit);
    if (!number || !(*number > 0) || !std::isfinite(*number) || !unit)
      return fail(entry.value.place, "a tolerance is a part of the answer, or a number with a unit",
                  "0.02 allows for 2 % of it, \"0.5 deg\" for half a degree");
    if (!asked || unit->dimension != asked->dimension)
      return fail(entry.value.place, "units disagree: the tolerance is " + to_string(unit->dimension) +
                                         ", the answer is " +
                                         to_string(asked.value_or(ScaledUnit{}).dimension));
    answer_.is_relative = false;
    answer_.within = *number * unit->size / answer_.unit_si;
    answer_.within_text = is_degrees(text.substr(blank + 1)) ? text.substr(0, blank) + "°" : text;
  }

  const TomlTable& keys_;
  TextReader& texts_;
  Report& report_;
  NumberAnswer answer_;
  bool ok_ = true;
};

void compute(NumberAnswer& answer, MotionNumbers& motion, const Effort& effort) {
  spend(effort, kClaimNodeEvaluations * static_cast<std::int64_t>(answer.expression->nodes.size()));
  if (const auto value = motion.value_of(*answer.expression)) answer.value = *value / answer.unit_si;
}

}  // namespace

std::optional<NumberAnswer> read_number_answer(const TomlTable& keys, TextReader& texts) {
  return NumberReader(keys, texts).read();
}

std::string words_of_what_is_asked(const NumberAnswer& answer) {
  const std::string& unit = answer.unit;
  const Language language = answer.language;
  const std::string within = with_decimals(answer.within_text, language);
  if (unit.empty()) return words::kAnswerWithANumber.with(language, {within});
  const std::string_view named = is_degrees(unit) ? words::kUnitDegrees.in(language)
                                 : unit == "deg/s" || unit == "°/s"
                                     ? words::kUnitDegreesPerSecond.in(language)
                                     : std::string_view(unit);
  return words::kAnswerInUnit.with(language, {named, within});
}

std::optional<SourcePlace> compute_answers(Lesson& lesson, const Effort& effort) {
  for (Stage& stage : lesson.stages)
    for (Step& step : stage.steps) {
      std::optional<SceneModel> model;  // must outlive the numbers of its motion
      std::optional<MotionNumbers> motion;
      for (Block& block : step.blocks) {
        auto* ask = std::get_if<Ask>(&block);
        if (ask == nullptr || !ask->number || !ask->number->expression || !step.scene) continue;
        try {
          if (!motion) {
            Scene scene = *step.scene;
            scene.beside.clear();
            scene.before = 0;
            model.emplace(make_model(scene, ModelFor::numbers, effort));
            motion.emplace(*model, still_time_s(*step.scene), effort);
          }
          NumberAnswer computed = *ask->number;
          compute(computed, *motion, effort);
          ask->number = std::make_shared<const NumberAnswer>(std::move(computed));
        } catch (const BudgetSpent&) {
          return ask->place;
        } catch (const std::domain_error&) {  // no such motion: who checks the scenes says so
        }
      }
    }
  return std::nullopt;
}

}  // namespace polhode
