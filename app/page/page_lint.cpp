// SPDX-License-Identifier: MIT
#include "app/page/page_lint.h"

#include "app/page/page.h"
#include "app/page/still_numbers.h"
#include "lessons/reader/lint_budget.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <stdexcept>

namespace polhode {

namespace {

constexpr Size kPages[] = {{1920, 1080}, {1024, 768}, {1080, 1920}};

SourcePlace place_of(const Stage& stage, const Step& step) {
  if (step.blocks.empty()) return stage.place;
  return std::visit([](const auto& block) { return block.place; }, step.blocks.front());
}

class PageLint {
 public:
  PageLint(const Lesson& lesson, const Fonts& fonts, std::string_view file_name, std::span<const Size> sizes,
           const Effort& effort)
      : lesson_(lesson),
        fonts_(fonts),
        file_(file_name),
        sizes_(sizes),
        effort_(effort),
        still_numbers_(effort) {}

  std::vector<Diagnostic> all() {
    try {
      for (std::size_t i = 0; i < lesson_.stages.size(); ++i)
        check(lesson_.stages[i], static_cast<int>(i + 1));
    } catch (const BudgetSpent&) {
      found_.push_back(too_long_to_check(file_, place_));
    }
    return std::move(found_);
  }

 private:
  void check(const Stage& stage, int number) {
    for (std::size_t i = 0; i < stage.steps.size(); ++i) {
      const Step& step = stage.steps[i];
      place_ = place_of(stage, step);
      try {
        check(stage, number, static_cast<int>(i + 1), step);
      } catch (const std::domain_error& error) {
        found_.push_back(
            {Severity::error, file_, place_,
             fmt::format("step {} of stage \"{}\" cannot be drawn: {}", i + 1, stage.id, error.what()), ""});
      }
    }
  }

  void check(const Stage& stage, int number, int step_number, const Step& step) {
    const SceneModel model = step.scene ? make_model(*step.scene, Product::page, effort_) : SceneModel();
    if (step.scene && step.scene != scene_)
      for (const std::string& unseen : unseen_marks(model))
        warn(fmt::format("in step {} of stage \"{}\" {}", step_number, stage.id, unseen), "");
    scene_ = step.scene;
    for (const Size& size : sizes_) {
      spend(effort_, kPageEvaluations);
      if (!check({.lesson = lesson_,
                  .stage = stage,
                  .number = number,
                  .step = step_number,
                  .model = step.scene ? &model : nullptr,
                  .t_s = step.scene ? still_time_s(*step.scene) : 0.0,
                  .size = size,
                  .theme = Theme::paper,
                  .still_numbers = &still_numbers_,
                  .effort = effort_}))
        break;
    }
  }

  /// Whether the page is as it should be.
  bool check(const PageRequest& request) {
    const auto on_page = [&] {
      return fmt::format("on a page of {}x{}", request.size.width, request.size.height);
    };
    const Result<Page> page = compose_page(request, fonts_);
    if (!page) {
      found_.push_back({Severity::error, file_, place_, page.error(), kSplit});
      return false;
    }
    if (page->scale < kLeastScale)
      warn(fmt::format("step {} of stage \"{}\" is long: {} its type has {:.0f} % of the normal size",
                       request.step, request.stage.id, on_page(), 100.0 * page->scale),
           kSplit);
    if (page->formula_scale < kLeastFormulaScale)
      warn(fmt::format("step {} of stage \"{}\" has a wide formula: {} it has {:.0f} % of its normal size",
                       request.step, request.stage.id, on_page(), 100.0 * page->formula_scale),
           "write it in several lines: \\begin{aligned} … \\end{aligned}");
    return page->scale >= kLeastScale && page->formula_scale >= kLeastFormulaScale;
  }

  void warn(std::string message, std::string hint) {
    found_.push_back({Severity::warning, file_, place_, std::move(message), std::move(hint)});
  }

  static constexpr const char* kSplit = "split it with ---";

  const Lesson& lesson_;
  const Fonts& fonts_;
  std::string file_;
  std::span<const Size> sizes_;
  const Effort& effort_;
  StillNumbers still_numbers_;
  std::shared_ptr<const Scene> scene_;  ///< of the step before: steps that go on with one share it
  SourcePlace place_;                   ///< of the step that is checked
  std::vector<Diagnostic> found_;
};

}  // namespace

std::vector<Diagnostic> page_diagnostics(const Lesson& lesson, const Fonts& fonts, std::string_view file_name,
                                         const Effort& effort) {
  return PageLint(lesson, fonts, file_name, kPages, effort).all();
}

std::vector<Diagnostic> page_errors(const Lesson& lesson, const Fonts& fonts, std::string_view file_name,
                                    const Effort& effort) {
  std::vector<Diagnostic> found =
      PageLint(lesson, fonts, file_name, std::span(kPages).first(1), effort).all();
  std::erase_if(found, [](const Diagnostic& d) { return d.severity != Severity::error; });
  return found;
}

}  // namespace polhode
