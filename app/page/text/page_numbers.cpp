// SPDX-License-Identifier: MIT
#include "app/page/text/page_numbers.h"

#include "app/narration/still_numbers.h"
#include "render/scene/model/scene_problem.h"

#include <algorithm>

namespace polhode {

PageNumbers numbers_of(const PageRequest& request, const Fonts& fonts) {
  const Lesson& lesson = request.lesson;
  PageNumbers shown(lesson, fonts);
  StillNumbers own;
  StillNumbers& stills = request.still_numbers ? *request.still_numbers : own;
  const std::vector<Step>& steps = request.stage.steps;
  const Step& present = steps[static_cast<std::size_t>(request.step - 1)];
  std::vector<int> now;  // those of the page's motion
  for (int i = 0; i < request.step; ++i) {
    const Step& step = steps[static_cast<std::size_t>(i)];
    std::vector<int> ids = numbers_in(step);
    // Those of tables are of motions of their own.
    const auto in_table = std::partition(ids.begin(), ids.end(), [&](int id) {
      return lesson.numbers[static_cast<std::size_t>(id)].row == nullptr;
    });
    const auto keep = [&](auto first, auto last) {
      if (first == last) return;
      const StillNumbers::Values& values = stills.of(lesson, step);
      for (; first != last; ++first) {
        const auto value = values.find(*first);
        shown.keep(*first, value != values.end() ? std::optional(value->second) : std::nullopt);
      }
    };
    keep(in_table, ids.end());
    ids.erase(in_table, ids.end());
    if (request.before) {
      const FiguredStep* one = figured(request, i + 1);
      const SceneModel* model = one ? one->model : i + 1 == request.step ? request.model : nullptr;
      const auto live = model ? live_state(*model, one ? one->t_s : request.t_s) : std::nullopt;
      for (const int id : ids)
        if (live) shown.keep(id, value_of(lesson.numbers[static_cast<std::size_t>(id)], *live));
      if (!model) keep(ids.begin(), ids.end());
      continue;
    }
    const bool is_of_page =
        i + 1 == request.step || !step.scene || !present.scene || same_motion(*step.scene, *present.scene);
    if (is_of_page) now.insert(now.end(), ids.begin(), ids.end());
    if (!is_of_page) keep(ids.begin(), ids.end());
  }
  if (now.empty() || !request.model) return shown;
  if (request.runs)
    for (const auto& [id, values] : values_over(*request.model, lesson, now)) shown.run(id, values);
  const auto live = request.runs ? std::nullopt : live_state(*request.model, request.t_s);
  for (const int id : now)
    if (live) shown.keep(id, value_of(lesson.numbers[static_cast<std::size_t>(id)], *live));
  return shown;
}

}  // namespace polhode
