// SPDX-License-Identifier: MIT
#include "app/page_lint.h"

#include "app/exit_codes.h"
#include "app/page.h"

#include <fmt/format.h>

#include <algorithm>

namespace polhode {

namespace {

constexpr Size kPages[] = {{1920, 1080}, {1024, 768}};

SourcePlace place_of(const Stage& stage, const Step& step) {
  if (step.blocks.empty()) return stage.place;
  return std::visit([](const auto& block) { return block.place; }, step.blocks.front());
}

class PageLint {
 public:
  PageLint(const Lesson& lesson, const Fonts& fonts, std::string_view file_name)
      : lesson_(lesson), fonts_(fonts), file_(file_name) {}

  void check(const Stage& stage, int number) {
    for (std::size_t i = 0; i < stage.steps.size(); ++i) {
      const Step& step = stage.steps[i];
      const SceneModel model = step.scene ? make_model(*step.scene, Product::page) : SceneModel();
      for (const Size& size : kPages)
        if (!check({.lesson = lesson_,
                    .stage = stage,
                    .number = number,
                    .step = static_cast<int>(i + 1),
                    .model = step.scene ? &model : nullptr,
                    .t_s = step.scene ? step.scene->at_s : 0.0,
                    .size = size,
                    .theme = Theme::paper},
                   place_of(stage, step)))
          break;
    }
  }

  std::vector<Diagnostic> take() { return std::move(found_); }

 private:
  /// Whether the page is as it should be.
  bool check(const PageRequest& request, SourcePlace place) {
    try {
      const Page page = compose_page(request, fonts_);
      if (page.scale >= kLeastScale) return true;
      add(Severity::warning, place,
          fmt::format(
              "step {} of stage \"{}\" is long: on a page of {}x{} its type has {:.0f} % of the normal size",
              request.step, request.stage.id, request.size.width, request.size.height, 100.0 * page.scale));
    } catch (const CommandError& error) {
      add(Severity::error, place, error.what());
    }
    return false;
  }

  void add(Severity severity, SourcePlace place, std::string message) {
    found_.push_back({severity, file_, place, std::move(message), "split it with ---"});
  }

  const Lesson& lesson_;
  const Fonts& fonts_;
  std::string file_;
  std::vector<Diagnostic> found_;
};

}  // namespace

std::vector<Diagnostic> page_diagnostics(const Lesson& lesson, const Fonts& fonts,
                                         std::string_view file_name) {
  PageLint lint(lesson, fonts, file_name);
  for (std::size_t i = 0; i < lesson.stages.size(); ++i)
    lint.check(lesson.stages[i], static_cast<int>(i + 1));
  return lint.take();
}

}  // namespace polhode
