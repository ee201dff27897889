// SPDX-License-Identifier: MIT
#include "app/page/text/recalled_equations.h"

#include <algorithm>
#include <utility>

namespace polhode {

namespace {

constexpr int kAskedFor = 100;  // the weight of what a step says that it goes on from

/// Whether a claim, on whatever step of the stage, says of an equation that it is wrong, or does not follow.
bool is_refuted(const Stage& stage, const Equation& equation) {
  const auto says_so = [&](const Block& block) {
    const auto* claim = std::get_if<Claim>(&block);
    return claim && claim->equation == equation.id && refutes(claim->kind);
  };
  return std::any_of(stage.steps.begin(), stage.steps.end(), [&](const Step& step) {
    return std::any_of(step.blocks.begin(), step.blocks.end(), says_so);
  });
}

/// How much of a result a display is: one with a number, one that something is said of, or neither.
int weight_of(const Step& step, const Equation& equation) {
  if (!equation.tag.empty()) return 2;
  const auto claims = blocks_of<Claim>(step);
  return std::any_of(claims.begin(), claims.end(),
                     [&](const Claim* claim) { return claim->equation == equation.id; })
             ? 1
             : 0;
}

/// Whether a formula stands on the pages of later steps, without its text. What is wrong would seem to be
/// right there, and numbers of one motion to be those of the next.
bool is_repeated(const Stage& stage, const Equation& equation) {
  return !is_refuted(stage, equation) && numbers_in(equation).empty();
}

/// What the steps that stand on a page to read say that they go on from.
std::vector<const Equation*> gone_on_from(const PageRequest& request, std::size_t whole_from) {
  std::vector<const Equation*> equations;
  for (std::size_t i = whole_from; request.before && i < static_cast<std::size_t>(request.step); ++i) {
    const std::string& from = request.stage.steps[i].from;
    if (!from.empty() && from != kRecallsNothing) equations.push_back(find_equation(request.lesson, from));
  }
  return equations;
}

std::vector<Recalled> of_other_stages(const PageRequest& request,
                                      const std::vector<const Equation*>& equations) {
  std::vector<Recalled> found;
  for (const Stage& stage : request.lesson.stages)
    for (const Step& step : stage.steps)
      for (const Equation* equation : blocks_of<Equation>(step))
        if (&stage != &request.stage && is_repeated(stage, *equation) &&
            std::find(equations.begin(), equations.end(), equation) != equations.end())
          found.push_back({equation, &step, 0, kAskedFor});
  return found;
}

/// A number before what a step has come to, that before what is claimed, that before the rest.
int recall_weight(const PageRequest& request, const Equation& equation, std::size_t i) {
  const Step& step = request.stage.steps[i];
  const int weight = weight_of(step, equation);
  return 2 * weight + (weight > 0 && &equation == focus_of(request.stage, step) ? 1 : 0);
}

}  // namespace

const Equation* focus_of(const Stage& stage, const Step& step) {
  const Equation* focus = nullptr;
  for (const Equation* equation : blocks_of<Equation>(step)) {
    if (is_refuted(stage, *equation)) continue;
    if (!equation->tag.empty()) return equation;
    if (!focus) focus = equation;
  }
  return focus;
}

bool is_in_focus(const Stage& stage, const Step& step, const Equation& equation) {
  const Equation* focus = focus_of(stage, step);
  return focus != nullptr && !is_refuted(stage, equation) &&
         weight_of(step, equation) == weight_of(step, *focus);
}

std::vector<Recalled> recallable(const PageRequest& request, std::size_t whole_from) {
  const std::vector<const Equation*> asked_for = gone_on_from(request, whole_from);
  std::vector<Recalled> wanted = of_other_stages(request, asked_for);
  for (std::size_t i = 0; i < whole_from; ++i)
    for (const Equation* equation : blocks_of<Equation>(request.stage.steps[i])) {
      const bool is_asked_for = std::find(asked_for.begin(), asked_for.end(), equation) != asked_for.end();
      if (is_repeated(request.stage, *equation) && (is_asked_for || !request.before))
        wanted.push_back({equation, &request.stage.steps[i], i + 1,
                          is_asked_for ? kAskedFor : recall_weight(request, *equation, i)});
    }
  return wanted;
}

const Equation* recalled_on_slide(const PageRequest& request) {
  const auto present = static_cast<std::size_t>(request.step - 1);
  const std::string& from = request.stage.steps[present].from;
  if (from == kRecallsNothing) return nullptr;
  if (!from.empty()) return find_equation(request.lesson, from);
  for (std::size_t i = present; i-- > 0;)
    if (const Equation* equation = focus_of(request.stage, request.stage.steps[i]))
      if (is_repeated(request.stage, *equation)) return equation;
  return nullptr;
}

}  // namespace polhode
