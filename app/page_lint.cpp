// SPDX-License-Identifier: MIT
#include "app/page_lint.h"

#include "app/exit_codes.h"
#include "app/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

namespace polhode {

namespace {

constexpr Size kPages[] = {{1920, 1080}, {1024, 768}, {1080, 1920}};

SourcePlace place_of(const Stage& stage, const Step& step) {
  if (step.blocks.empty()) return stage.place;
  return std::visit([](const auto& block) { return block.place; }, step.blocks.front());
}

class PageLint {
 public:
  PageLint(const Lesson& lesson, const Fonts& fonts, std::string_view file_name, std::span<const Size> sizes)
      : lesson_(lesson), fonts_(fonts), file_(file_name), sizes_(sizes) {}

  std::vector<Diagnostic> all() {
    for (std::size_t i = 0; i < lesson_.stages.size(); ++i) check(lesson_.stages[i], static_cast<int>(i + 1));
    return std::move(found_);
  }

 private:
  void check(const Stage& stage, int number) {
    for (std::size_t i = 0; i < stage.steps.size(); ++i) {
      const Step& step = stage.steps[i];
      const SceneModel model = step.scene ? make_model(*step.scene, Product::page) : SceneModel();
      for (const Size& size : sizes_)
        if (!check({.lesson = lesson_,
                    .stage = stage,
                    .number = number,
                    .step = static_cast<int>(i + 1),
                    .model = step.scene ? &model : nullptr,
                    .t_s = step.scene ? still_time_s(*step.scene) : 0.0,
                    .size = size,
                    .theme = Theme::paper},
                   place_of(stage, step)))
          break;
    }
  }

  /// Whether the page is as it should be.
  bool check(const PageRequest& request, SourcePlace place) {
    const auto on_page = [&] {
      return fmt::format("on a page of {}x{}", request.size.width, request.size.height);
    };
    try {
      const Page page = compose_page(request, fonts_);
      if (page.scale < kLeastScale)
        warn(place,
             fmt::format("step {} of stage \"{}\" is long: {} its type has {:.0f} % of the normal size",
                         request.step, request.stage.id, on_page(), 100.0 * page.scale),
             kSplit);
      if (page.formula_scale < kLeastFormulaScale)
        warn(place,
             fmt::format("step {} of stage \"{}\" has a wide formula: {} it has {:.0f} % of its normal size",
                         request.step, request.stage.id, on_page(), 100.0 * page.formula_scale),
             "write it in several lines: \\begin{aligned} … \\end{aligned}");
      return page.scale >= kLeastScale && page.formula_scale >= kLeastFormulaScale;
    } catch (const CommandError& error) {
      found_.push_back({Severity::error, file_, place, error.what(), kSplit});
      return false;
    }
  }

  void warn(SourcePlace place, std::string message, std::string hint) {
    found_.push_back({Severity::warning, file_, place, std::move(message), std::move(hint)});
  }

  static constexpr const char* kSplit = "split it with ---";

  const Lesson& lesson_;
  const Fonts& fonts_;
  std::string file_;
  std::span<const Size> sizes_;
  std::vector<Diagnostic> found_;
};

}  // namespace

std::vector<Diagnostic> page_diagnostics(const Lesson& lesson, const Fonts& fonts,
                                         std::string_view file_name) {
  return PageLint(lesson, fonts, file_name, kPages).all();
}

std::vector<Diagnostic> page_errors(const Lesson& lesson, const Fonts& fonts, std::string_view file_name) {
  std::vector<Diagnostic> found = PageLint(lesson, fonts, file_name, std::span(kPages).first(1)).all();
  std::erase_if(found, [](const Diagnostic& d) { return d.severity != Severity::error; });
  return found;
}

}  // namespace polhode
