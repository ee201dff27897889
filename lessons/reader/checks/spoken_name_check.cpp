// SPDX-License-Identifier: MIT
#include "lessons/reader/checks/spoken_name_check.h"

#include "lessons/claims/live_claims.h"
#include "lessons/notation/tex_items.h"
#include "lessons/notation/tex_sides.h"
#include "lessons/reader/checks/formula_signs.h"
#include "lessons/reader/checks/prose/quantity_words.h"
#include "render/scene/model/model.h"
#include "render/typeset/math/tree.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

namespace polhode {
namespace {

class SpokenNameCheck {
 public:
  SpokenNameCheck(const Lesson& lesson, const SourceText& source, const Prover& prover, Report& report,
                  const Effort& effort)
      : lesson_(lesson), source_(source), prover_(prover), report_(report), effort_(effort) {}

  void check_symbols() const {
    for (const auto& [name, symbol] : lesson_.symbols) {
      if (symbol.means == "I" || symbol.means == "J") continue;
      const std::string& text = symbol.means.empty() ? name : symbol.means;
      const SourceText source(text);
      Report unused(source, "");
      const auto means = read_expression(text, {1, 1}, unused, &lesson_.notation.vocabulary);
      if (!means) continue;
      for (const std::string* words : {&symbol.say, &symbol.note}) {
        const auto said = quantity_of_common_name(*words, lesson_);
        if (!said || !fit(said->type(), means->type()) || may_be_same(*said, *means)) continue;
        report_.error(source_.place_of(std::min(symbol.offset, source_.text().size())),
                      "symbol " + in_quotes(name) + " is said as " + in_quotes(*words) + ", which is " +
                          said->text + ", and means " + text,
                      "say what it is");
        break;
      }
    }
  }

  void check_braces(const MathNode& node, const Equation& equation) const {
    using Kind = MathNode::Kind;
    const bool is_labelled =
        node.kind == Kind::scripts && without_groups(node.children[0]).kind == Kind::brace;
    for (std::size_t script = 1; is_labelled && script < node.children.size(); ++script) {
      Math label, inside;
      label.root = std::make_shared<const MathNode>(node.children[script]);
      inside.root = std::make_shared<const MathNode>(without_groups(node.children[0]).children.front());
      const std::string words = words_of_formula(label);
      const auto said = words.empty() ? std::nullopt : quantity_of_common_name(words, lesson_);
      const auto held = said ? read_side(inside, lesson_.notation) : std::nullopt;
      if (!held || (fit(said->type(), held->type()) && may_be_same(*said, *held))) continue;
      report_.error(source_.place_of(std::min(equation.offset + node.span.begin, source_.text().size())),
                    in_quotes(words) + " at a brace is " + said->text + ", and it holds something else",
                    "say what it holds");
    }
    for (const MathNode& child : node.children) check_braces(child, equation);
  }

 private:
  /// What no proof decides, such as the largest of three moments, may be so in some scene of the lesson.
  bool may_be_same(const Expression& a, const Expression& b) const {
    const Equality sides{a, b};
    if (is_provable(sides)) return prover_.settle(sides, LawsAssumed::identity) != Verdict::fails;
    bool is_told = false;
    const Scene* last = nullptr;
    for (const Stage& stage : lesson_.stages)
      for (const Step& step : stage.steps) {
        if (!step.scene || step.scene.get() == last) continue;
        last = step.scene.get();
        const auto live = state_of_first(*step.scene);
        const auto x = live ? live_number(a, *live) : std::nullopt,
                   y = live ? live_number(b, *live) : std::nullopt;
        if (!x || !y) continue;
        is_told = true;
        constexpr double kRounding = 1e-9;
        if (std::abs(*x - *y) <= kRounding * (std::abs(*x) + std::abs(*y))) return true;
      }
    return !is_told;
  }

  /// Of the scene without those beside it, as it begins; nothing if it cannot be.
  std::optional<LiveState> state_of_first(const Scene& scene) const {
    Scene alone = scene;
    alone.beside.clear();
    alone.before = 0;
    try {
      return live_state(make_model(alone, ModelFor::numbers, effort_), 0);
    } catch (const std::domain_error&) {
      return std::nullopt;
    }
  }

  const Lesson& lesson_;
  const SourceText& source_;
  const Prover& prover_;
  Report& report_;
  const Effort& effort_;
};

}  // namespace

void check_spoken_names(const Lesson& lesson, const SourceText& source, const Prover& prover, Report& report,
                        const Effort& effort) {
  SpokenNameCheck(lesson, source, prover, report, effort).check_symbols();
}

void check_braces(const Equation& equation, const Lesson& lesson, const SourceText& source,
                  const Prover& prover, Report& report, const Effort& effort) {
  if (equation.math.root)
    SpokenNameCheck(lesson, source, prover, report, effort).check_braces(*equation.math.root, equation);
}

}  // namespace polhode
