// SPDX-License-Identifier: MIT
#include "lessons/reader/checks/lesson_check.h"

#include "lessons/reader/checks/claim_check.h"
#include "lessons/reader/checks/lint_budget.h"
#include "lessons/reader/questions/number_question.h"
#include "render/scene/model/model.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <utility>

namespace polhode {
namespace {

/// The model's objections to each scene, at the place of its stage.
std::vector<Diagnostic> model_diagnostics(const Lesson& lesson, std::string_view file_name,
                                          const Effort& effort) {
  std::vector<Diagnostic> found;
  const Scene* before = nullptr;
  for (const Stage& stage : lesson.stages) {
    for (const Step& step : stage.steps) {
      if (!step.scene || (before && *before == *step.scene)) continue;
      try {
        check_scene(*step.scene, effort);
        before = &*step.scene;
      } catch (const BudgetSpent&) {
        found.push_back(too_long_to_check(file_name, stage.place));
        return found;
      } catch (const std::domain_error& error) {
        found.push_back({Severity::error, std::string(file_name), stage.place,
                         fmt::format("the scene of stage \"{}\" cannot be: {}", stage.id, error.what()), ""});
        break;
      }
    }
  }
  return found;
}

/// The model's objections to each row of a table, at its place.
std::vector<Diagnostic> row_diagnostics(const Lesson& lesson, std::string_view file_name,
                                        const Effort& effort) {
  std::vector<Diagnostic> found;
  const TableRow* before = nullptr;
  for (const ComputedNumber& number : lesson.numbers) {
    if (!number.row || number.row.get() == before) continue;
    before = number.row.get();
    try {
      const SceneModel model = make_model(before->scene, ModelFor::numbers, effort);
      if (!is_computable(model, before->scene.at_s))
        found.push_back(
            {Severity::error, std::string(file_name), before->place,
             fmt::format("the motion of this row cannot be followed to t = {:.7g} s", before->scene.at_s),
             "choose an earlier time, or a larger tolerance"});
    } catch (const BudgetSpent&) {
      found.push_back(too_long_to_check(file_name, before->place));
      return found;
    } catch (const std::domain_error& error) {
      found.push_back({Severity::error, std::string(file_name), before->place,
                       fmt::format("the motion of this row cannot be: {}", error.what()), ""});
    }
  }
  return found;
}

}  // namespace

LessonReading check_lesson(std::string_view text, std::string_view file_name, const Effort& effort) {
  LessonReading reading = read_lesson(text, file_name);
  if (!reading.lesson) return reading;
  std::vector<Diagnostic> found = model_diagnostics(*reading.lesson, file_name, effort);
  if (found.empty()) found = row_diagnostics(*reading.lesson, file_name, effort);
  if (found.empty())
    if (const auto unproved = prove_claims(*reading.lesson, effort))
      found.push_back(too_long_to_check(file_name, *unproved));
  if (found.empty())
    if (const auto uncomputed = compute_answers(*reading.lesson, effort))
      found.push_back(too_long_to_check(file_name, *uncomputed));
  if (found.empty()) return reading;
  reading.lesson.reset();
  add_in_order(std::move(found), reading.diagnostics);
  return reading;
}

void add_in_order(std::vector<Diagnostic> more, std::vector<Diagnostic>& all) {
  std::move(more.begin(), more.end(), std::back_inserter(all));
  std::stable_sort(all.begin(), all.end(), [](const Diagnostic& a, const Diagnostic& b) {
    return std::pair(a.place.line, a.place.column) < std::pair(b.place.line, b.place.column);
  });
}

}  // namespace polhode
