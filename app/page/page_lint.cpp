// SPDX-License-Identifier: MIT
#include "app/page/page_lint.h"

#include "app/narration/still_numbers.h"
#include "app/page/page.h"
#include "app/page/page_division.h"
#include "app/page/text/page_text.h"
#include "lessons/reader/checks/lint_budget.h"
#include "render/drawing/plots/meter_plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <set>
#include <span>
#include <stdexcept>

namespace polhode {

namespace {

/// What a value of a quantity of the lesson's own counts as.
constexpr std::int64_t kEvaluationsOfValue = 20;

constexpr Size kPages[] = {{1920, 1080}, {1024, 768}, {1080, 1920}};

/// What can be read while somebody speaks.
constexpr int kWordsOnSlide = 45, kFormulasOnSlide = 2;

/// A formula counts as one.
int words_in(const RichText& text) {
  int words = 0;
  bool inside = false;
  for (const TextBlock& block : text) {
    inside = false;
    for (const TextSpan& span : block.spans) {
      if (span.kind == TextSpan::Kind::math) {
        words += inside ? 0 : 1;
        inside = true;
        continue;
      }
      for (const char c : span.text) {
        const bool is_blank = c == ' ' || c == '\n';
        words += !is_blank && !inside ? 1 : 0;
        inside = !is_blank;
      }
    }
  }
  return words;
}

/// Of prose and call-outs, as far as they stand on a page.
int words_in(const Step& step) {
  int words = 0;
  for (const Block& block : step.blocks) {
    if (const auto* prose = std::get_if<Prose>(&block)) words += words_in(prose->text);
    if (const auto* callout = std::get_if<Callout>(&block))
      words += words_in(callout->kind == Callout::Kind::derivation ? callout->title : callout->text);
  }
  return words;
}

SourcePlace place_of(const Stage& stage, const Step& step) {
  if (step.blocks.empty()) return stage.place;
  return std::visit([](const auto& block) { return block.place; }, step.blocks.front());
}

Diagnostic not_drawn(const std::string& file, SourcePlace place, const Stage& stage, std::size_t step,
                     const std::domain_error& error) {
  return {Severity::error, file, place,
          fmt::format("step {} of stage \"{}\" cannot be drawn: {}", step + 1, stage.id, error.what()), ""};
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
    slide_type_.reset();
    models_.clear();
    for (std::size_t i = 0; i < stage.steps.size(); ++i) {
      const Step& step = stage.steps[i];
      place_ = place_of(stage, step);
      try {
        const std::size_t before = found_.size();
        check(stage, number, static_cast<int>(i + 1), step);
        // What no page holds well is too much for a slide, and the same advice helps.
        if (found_.size() == before && sizes_.size() > 1) check_slide(stage, number, static_cast<int>(i + 1));
      } catch (const std::domain_error& error) {
        found_.push_back(not_drawn(file_, place_, stage, i, error));
      }
    }
    if (sizes_.size() > 1 && models_.size() == stage.steps.size()) check_pages(stage, number);
  }

  void check(const Stage& stage, int number, int step_number, const Step& step) {
    models_.push_back(step.scene ? make_model(*step.scene, ModelFor::page, effort_) : SceneModel());
    const SceneModel& model = models_.back();
    if (step.scene != scene_) check_shown(stage, step_number, model);
    scene_ = step.scene;
    for (const Size& size : sizes_) {
      spend(effort_, kPageEvaluations + plot_evaluations_);
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

  /// Whether a step says little enough for a slide, and shows something new.
  void check_slide(const Stage& stage, int number, int step_number) {
    const auto index = static_cast<std::size_t>(step_number - 1);
    const Step& step = stage.steps[index];
    const std::string which = fmt::format("step {} of stage \"{}\"", step_number, stage.id);
    if (const int words = words_in(step); words > kWordsOnSlide)
      warn(fmt::format("{} has {} words, which nobody reads while somebody speaks", which, words),
           fmt::format("at most {} a step: cut, or split it with ---", kWordsOnSlide));
    if (const std::size_t formulas = blocks_of<Equation>(step).size(); formulas > kFormulasOnSlide)
      warn(fmt::format("{} has {} displayed formulas", which, formulas),
           fmt::format("at most {} a step: split it with ---", kFormulasOnSlide));
    spend(effort_, kPageEvaluations);
    const PageRequest request{.lesson = lesson_,
                              .stage = stage,
                              .number = number,
                              .step = step_number,
                              .size = kPages[0],
                              .still_numbers = &still_numbers_,
                              .effort = effort_};
    if (const Result<double> scale = slide_scale_of(request, fonts_); scale && *scale < 1.0)
      warn(fmt::format(
               "{} is long for a slide: all slides of its stage have type of {:.0f} % of the normal size",
               which, 100.0 * *scale),
           kSplit);
    check_recalled(request);
    if (index == 0 || !step.scene) return;
    const std::shared_ptr<const Scene>& before = stage.steps[index - 1].scene;
    const bool stays = before && (before == step.scene || same_picture(*before, *step.scene));
    if (stays && step.same.empty())
      warn(which + " has the picture of the step before",
           "show what it speaks of, or say in its ```scene why "
           "it stays: same = \"a question about it\"");
    if (!stays && !step.same.empty())
      warn(which + " says why its picture stays, and changes it", "leave out \"same\"");
  }

  /// A slide drops what it goes on from where there is no room for it: what the author asked for.
  void check_recalled(PageRequest request) {
    const Step& step = request.stage.steps[static_cast<std::size_t>(request.step - 1)];
    if (step.from.empty() || step.from == kRecallsNothing) return;
    if (!slide_type_) {
      const Result<SlideType> found = slide_type_of(request, fonts_);
      if (!found) return;  // said already
      slide_type_ = *found;
    }
    request.profile = Profile::slides;
    request.slide_type = &*slide_type_;
    request.model = step.scene ? &models_.back() : nullptr;
    const Result<FittedText> text = text_of_page(request, fonts_);
    if (text && text->recalled == nullptr)
      warn(fmt::format("step {} of stage \"{}\": its slide has no room for \"{}\", which it goes on from",
                       request.step, request.stage.id, step.from),
           "say less on it, name a shorter formula of its stage, or write from = \"none\"");
  }

  /// Pages to read, whose figures have other shapes.
  void check_pages(const Stage& stage, int number) {
    PageRequest request{.lesson = lesson_,
                        .stage = stage,
                        .number = number,
                        .size = kPages[0],
                        .still_numbers = &still_numbers_,
                        .effort = effort_};
    const Result<std::vector<int>> ends = pages_of_stage(request, fonts_);
    if (!ends) return;  // said already
    int first = 1;
    for (const int last : *ends) {
      if (first < last) check_page(request, first, last);
      first = last + 1;
    }
  }

  void check_page(PageRequest request, int first, int last) {
    const auto figured = [&](int number) {
      const auto i = static_cast<std::size_t>(number - 1);
      const Scene* scene = request.stage.steps[i].scene.get();
      return FiguredStep{number, scene ? &models_[i] : nullptr, scene ? still_time_s(*scene) : 0.0};
    };
    std::vector<FiguredStep> before;
    for (int number = first; number < last; ++number) before.push_back(figured(number));
    const FiguredStep present = figured(last);
    request.step = last;
    request.model = present.model;
    request.t_s = present.t_s;
    request.before = before;
    place_ = place_of(request.stage, request.stage.steps[static_cast<std::size_t>(first - 1)]);
    spend(effort_, kPageEvaluations);
    if (const Result<Page> page = compose_page(request, fonts_))
      check_framing(request, *page, "at the still, on their page to read,");
  }

  /// Of a quantity that the motion does not have there is nothing to see, and nothing else says why.
  void check_shown(const Stage& stage, int step_number, const SceneModel& model) {
    plot_evaluations_ = 0;
    if (!model.motion) return;
    std::set<std::string> said;  // scenes side by side may have it in common
    const auto warn_once = [&](const std::string& what, const char* hint) {
      if (said.insert(what).second)
        warn(fmt::format("step {} of stage \"{}\": {}", step_number, stage.id, what), hint);
    };
    for (const SceneModel* shown : shown_models(model)) {
      for (const std::string& unseen : unseen_plots(*shown))
        warn_once("there is nothing to plot of " + unseen + ", which is not defined on this motion",
                  "leave it out, or plot it where it is");
      for (const std::string& unseen : unseen_marks(*shown)) warn_once(unseen, "");
    }
  }

  /// The labels of the quantities of the lesson's own plots that have no value anywhere.
  std::vector<std::string> unseen_plots(const SceneModel& model) {
    const auto is_own = [](const PlotSpec& plot) { return std::holds_alternative<OwnPlot>(plot); };
    const std::vector<PlotSpec>& specs = model.scene.meters;
    std::vector<std::string> unseen;
    if (std::none_of(specs.begin(), specs.end(), is_own)) return unseen;
    const std::vector<TimePlot> plots = meter_plots(model, still_time_s(model.scene));
    for (std::size_t i = 0; i < plots.size(); ++i) {
      if (!is_own(specs[i])) continue;
      for (const TimeSeries& series : plots[i].series) {
        plot_evaluations_ += kEvaluationsOfValue * static_cast<std::int64_t>(series.y.size());
        if (std::none_of(series.y.begin(), series.y.end(), [](double y) { return std::isfinite(y); }))
          unseen.push_back(series.label);
      }
    }
    return unseen;
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
    if (request.size.width == kPages[0].width) {
      check_framing(request, *page, "at the still");
      check_predictions(request);
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

  /// What lies outside the pane that it belongs to: an arrow whose tip is not seen says nothing, and half a
  /// body is not what its lesson shows.
  void check_framing(const PageRequest& request, const Page& page, std::string_view when) {
    bool arrow = false, body = false;
    for (const Inset& inset : page.insets)
      for (const Pane& pane : inset.figure.panes) {
        const double width = pane.width * inset.place.width, height = pane.height * inset.place.height;
        const auto is_outside = [&](const Vec3& point) {
          const auto at = project(pane.camera, point, width, height);
          return !at || at->x() < 0 || at->x() > width || at->y() < 0 || at->y() > height;
        };
        for (const Arrow& one : pane.list.arrows) arrow = arrow || is_outside(one.tip);
        for (const Mesh& mesh : pane.list.meshes)
          body = body || std::any_of(mesh.positions.begin(), mesh.positions.end(), is_outside);
      }
    const std::size_t before = request.before ? request.before->size() : 0;
    const std::string steps = before == 0
                                  ? fmt::format("step {}", request.step)
                                  : fmt::format("steps {} to {}", request.before->front().step, request.step);
    const std::string where = fmt::format("{} of stage \"{}\": {} ", steps, request.stage.id, when);
    if (arrow) warn(where + "the tip of an arrow lies outside the picture", kFrame);
    if (body) warn(where + "the body is cut by the edge of the picture", kFrame);
  }

  /// What a prediction is held against has to be seen when it is over.
  void check_predictions(PageRequest request) {
    if (request.model == nullptr) return;
    for (const Ask* ask : blocks_of<Ask>(request.stage.steps[static_cast<std::size_t>(request.step - 1)])) {
      if (!ask->plays) continue;
      spend(effort_, kPageEvaluations);
      request.t_s = ask->plays->to_s;
      const Result<Page> end = compose_page(request, fonts_);
      if (end) check_framing(request, *end, fmt::format("when \"{}\" has been played", ask->id));
    }
  }

  void warn(std::string message, std::string hint) {
    found_.push_back({Severity::warning, file_, place_, std::move(message), std::move(hint)});
  }

  static constexpr const char* kSplit = "split it with ---";
  static constexpr const char* kFrame = "a smaller zoom of the camera shows it";

  const Lesson& lesson_;
  const Fonts& fonts_;
  std::string file_;
  std::span<const Size> sizes_;
  const Effort& effort_;
  StillNumbers still_numbers_;
  SourcePlace place_;                    ///< of the step that is checked
  std::shared_ptr<const Scene> scene_;   ///< of the step before: steps that go on with one share it
  std::deque<SceneModel> models_;        ///< of the steps of the stage, as far as they are checked
  std::optional<SlideType> slide_type_;  ///< of the stage, once it is asked for
  std::int64_t plot_evaluations_ = 0;    ///< that its plots count as, on each page
  std::vector<Diagnostic> found_;
};

}  // namespace

std::vector<Diagnostic> page_diagnostics(const Lesson& lesson, const Fonts& fonts, std::string_view file_name,
                                         const Effort& effort) {
  return PageLint(lesson, fonts, file_name, kPages, effort).all();
}

std::vector<Diagnostic> scene_errors(const Lesson& lesson, std::string_view file_name, const Effort& effort) {
  const std::string file(file_name);
  std::vector<Diagnostic> found;
  std::shared_ptr<const Scene> before;  // steps that go on with a scene share it
  for (const Stage& stage : lesson.stages)
    for (std::size_t i = 0; i < stage.steps.size(); ++i) {
      const Step& step = stage.steps[i];
      if (!step.scene || step.scene == before) continue;
      before = step.scene;
      try {
        make_model(*step.scene, ModelFor::page, effort);
      } catch (const BudgetSpent&) {
        found.push_back(too_long_to_check(file, place_of(stage, step)));
        return found;
      } catch (const std::domain_error& error) {
        found.push_back(not_drawn(file, place_of(stage, step), stage, i, error));
      }
    }
  return found;
}

}  // namespace polhode
