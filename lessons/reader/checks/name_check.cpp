// SPDX-License-Identifier: MIT
#include "lessons/reader/checks/name_check.h"

#include "lessons/claims/customary_names.h"
#include "lessons/claims/expressions/dimension.h"
#include "lessons/claims/live_claims.h"
#include "lessons/notation/tex_sides.h"
#include "lessons/reader/checks/prose/quantity_words.h"
#include "lessons/reader/text_units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace polhode {
namespace {

/// Rates on a motion are differences, good to some 1e-8 of their terms; another quantity is further off.
constexpr double kNear = 1e-6;

using Components = std::array<double, 3>;

double dot(const Components& a, const Components& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

class NameCheck {
 public:
  NameCheck(const Lesson& lesson, const SceneModel& model, SourcePlace place, Report& report)
      : lesson_(lesson), place_(place), report_(report) {
    const double still_s = still_time_s(model.scene);
    for (const double t_s : {still_s, 0.37 * model.span_s, 0.81 * model.span_s})
      if (const auto live = live_state(model, t_s)) states_.push_back(*live);
  }

  void check_curve(const SceneQuantity& curve, const std::string& tex) {
    const auto said = read_any(tex);
    const bool is_name = said && has_name(*said);
    if (const auto shown = said && !is_name ? expression_of(curve) : named(curve))
      check_scalar(*shown, curve.text, tex);
    if (is_name && !named(curve) && is_multiple(curve, *said)) return refuse("the curve of", curve.text, tex);
    check_axis(curve, tex, "the curve of");
    const auto of_said = is_name ? dimension_of(*said, {}).dimension : std::nullopt;
    if (of_said && !can_have({*of_said}, dimension(curve))) return refuse("the curve of", curve.text, tex);
    check_kind(curve, tex, "the curve of");
  }

  /// 2T as T: what has no name of its own may stand for what it is called, but not as a simple multiple of
  /// it.
  bool is_multiple(const SceneQuantity& curve, const Expression& said) const {
    const auto shown = expression_of(curve);
    if (!shown || said.type() == ExpressionType::vector) return false;
    constexpr std::array<double, 9> kFactors{2, 0.5, 3, 1.0 / 3, 4, 0.25, 10, 0.1, -1};
    return std::any_of(kFactors.begin(), kFactors.end(), [&](double factor) {
      int told = 0;
      for (const LiveState& live : states_) {
        const auto a = live_number(*shown, live), b = live_number(said, live);
        if (!a || !b || !is_more_than_rounding(*a, *b)) continue;
        constexpr double kRounding = 1e-9;
        if (std::abs(*a - factor * *b) > kRounding * std::abs(*a)) return false;
        ++told;
      }
      return told > 0;
    });
  }

  void check_scalar(const Expression& shown, const std::string& text, const std::string& tex) {
    const auto said = read_any(tex);
    if (!said || said->type() == ExpressionType::vector) return;
    if (differs(*said, shown)) refuse("the curve of", text, tex);
  }

  /// A title that begins with a formula, "$\omega_3$ over time", or is the name of a quantity.
  void check_title_of(const OwnPlot& plot) {
    const std::size_t end = plot.title.size() > 1 && plot.title[0] == '$' ? plot.title.find('$', 1) : 0;
    if (end != 0 && end != plot.title.npos) {
      const std::string tex = plot.title.substr(1, end - 1);
      const auto said = read_any(tex);
      if (!said || said->type() == ExpressionType::vector) return;
      const bool is_some = std::any_of(plot.curves.begin(), plot.curves.end(), [&](const SceneQuantity& one) {
        const auto shown = has_name(*said) && !named(one) ? std::nullopt : expression_of(one);
        return !shown || !differs(*said, *shown);
      });
      if (!is_some && !plot.curves.empty()) refuse("the plot of", plot.curves.front().text, tex);
      return;
    }
    std::string words = plot.title;
    take_unit_at_end(words);
    if (plot.curves.size() != 1) return;
    check_words(plot.curves.front(), words, "the plot of");
    const auto said = quantity_said(stretches_of(words), lesson_), shown = expression_of(plot.curves.front());
    if (said && shown && differs(*said, *shown)) refuse("the plot of", plot.curves.front().text, words);
  }

  /// "$\\omega_1$ against $\\omega_2$": what stands above and beside the axes.
  void check_title_of_path(const OwnPlot& plot) {
    constexpr std::string_view kAgainst = " against ";
    std::string words = plot.title;
    take_unit_at_end(words);
    const std::size_t at = words.find(kAgainst);
    if (at == words.npos || plot.curves.size() != 1) return;
    const auto check_side = [&](const std::string& side, const SceneQuantity& of) {
      const auto said = quantity_said(stretches_of(side), lesson_), shown = expression_of(of);
      if (said && shown && differs(*said, *shown)) refuse("in this plot", of.text, side);
    };
    check_side(words.substr(0, at), plot.curves.front());
    check_side(words.substr(at + kAgainst.size()), *plot.against);
  }

  /// "axis 2", "\\omega_2", "2" stand at what speaks of axis 2, or of no axis.
  void check_axis(const SceneQuantity& of, const std::string& name, const char* what) {
    const auto said = axis_of_name(name);
    const auto shown = expression_of(of);
    if (!said || !shown || lesson_.notation.vocabulary.find(of.text) != nullptr) return;
    const std::string axes = axes_in(*shown);
    if (!axes.empty() && axes.find(*said) == axes.npos) refuse(what, of.text, name);
  }

  /// A size is none of a parallelogram's, unless it is that of the product of its sides.
  void check_area(const SceneQuantity& from, const SceneQuantity& to, const std::string& tex) {
    const auto said = read_any(tex);
    const std::string product = "cross(" + from.text + ", " + to.text + ')';
    const auto shown = expression_of(product);
    if (!said || !shown) return;
    const std::string what = "the area from " + from.text + " to";
    if (said->type() == ExpressionType::vector) {
      for (const LiveState& live : states_) {
        const auto a = live_quantity(*said, live, View::space), b = live_quantity(*shown, live, View::space);
        if (!a || !b) continue;
        const double lengths =
            std::sqrt(dot(a->components, a->components) * dot(b->components, b->components));
        if (lengths > 0 && dot(a->components, b->components) < (1 - kNear) * lengths)
          return refuse(what, to.text, tex);
      }
      return;
    }
    if (const auto number = expression_of("norm(" + product + ')'); number && differs(*said, *number))
      refuse(what, to.text, tex);
  }

  /// Where x is what it stands for on the motion, a function has the value of the quantity that it is named
  /// as.
  void check_function(const PlotFunction& function, const std::string& tex) {
    const auto of = expression_of(function.of);
    if (!of) return;
    Vocabulary words = lesson_.notation.vocabulary;
    words.define(function.variable, *of, "");
    const SourceText source(function.text);
    Report unused(source, "");
    const auto shown = read_expression(function.text, {1, 1}, unused, &words);
    if (shown) check_scalar(*shown, function.text, tex);
  }

  /// "T in kJ" above an axis of J.
  void check_title(const OwnPlot& plot) {
    std::string words = plot.title;
    const std::string unit = take_unit_at_end(words);
    const auto said = unit.empty() ? std::nullopt : scaled_unit(unit);
    const auto shown = scaled_unit(plot.y.unit);
    if (said && shown && (said->dimension != shown->dimension || said->size != shown->size))
      report_.error(place_,
                    "the title of a plot says " + in_quotes(unit) + ", and its axis is in " +
                        (plot.y.unit.empty() ? std::string("units of SI") : in_quotes(plot.y.unit)),
                    "write unit = " + in_quotes(unit) + ", or leave it out of the title");
  }

  void check_arrow(const SceneQuantity& of, const std::string& tex) {
    const auto said = read(tex), shown = expression_of(of);
    if (const auto math = parse_math(tex)) check_words(of, words_of_formula(*math), "the tip of");
    const bool is_called_axis = said && is_axis(*said);
    // Called as the lesson likes, but not as a unit vector that it is not.
    if (lesson_.notation.vocabulary.find(of.text) != nullptr && !is_called_axis) return;
    check_axis(of, tex, "the tip of");
    if (const auto size = read_any(tex); size && size->type() != ExpressionType::vector && shown) {
      const auto of_size = dimension_of(*size, {}).dimension;
      if (of_size && !can_have({*of_size}, dimension_of(*shown, {}).dimension))
        return refuse("the tip of", of.text, tex);
    }
    check_kind(of, tex, "the tip of");
    // What is drawn without a unit may stand for anything.
    const auto of_said = said ? dimension_of(*said, {}).dimension : std::nullopt;
    const auto of_shown = shown ? dimension_of(*shown, {}).dimension : std::nullopt;
    if (of_said && (named(of) || of_shown != kNumber) && !can_have({*of_said}, of_shown))
      return refuse("the tip of", of.text, tex);
    check_multiple(of, tex);
    check_direction(of, tex);
    if (!said || !shown || said->type() != ExpressionType::vector) return;
    for (const LiveState& live : states_) {
      const auto a = live_quantity(*said, live, View::space), b = live_quantity(*shown, live, View::space);
      if (!a || !b) continue;
      const double lengths = std::sqrt(dot(a->components, a->components) * dot(b->components, b->components));
      // How long it is drawn is the author's choice; of what has no name of its own only the sense is told.
      const bool is_strict =
          named(of) || ((is_axis(*shown) || is_called_axis) && !is_trial_axis(*shown, tex));
      const double least = is_strict ? 1 - kNear : -kNear;
      if (lengths > 0 && dot(a->components, b->components) < least * lengths)
        return refuse("the tip of", of.text, tex);
    }
  }

  static bool is_axis(const Expression& shown) {
    return shown.nodes.size() == 1 && shown.nodes[0].operation == Operation::quantity &&
           shown.nodes[0].quantity >= Quantity::e1 && shown.nodes[0].quantity <= Quantity::ez;
  }

  /// A symbol of the lesson that means e1 is any axis beside a tensor by its components, and may be drawn
  /// along one of space: then it is no principal axis.
  bool is_trial_axis(const Expression& shown, const std::string& tex) const {
    const bool is_of_space = is_axis(shown) && shown.nodes[0].quantity >= Quantity::ex;
    return is_of_space &&
           std::any_of(lesson_.symbols.begin(), lesson_.symbols.end(), [&](const auto& symbol) {
             return symbol.second.tex == tex && !symbol.second.means.empty();
           });
  }

  /// "\vec L\times\vec\omega": what is written out does not point the other way.
  void check_direction(const SceneQuantity& of, const std::string& tex) {
    const auto said = read_any(tex), shown = expression_of(of);
    if (!said || !shown || has_name(*said) || said->type() != ExpressionType::vector) return;
    if (said->uses(Quantity::A)) return;  // any vector that a lesson likes
    bool is_opposite = false;
    for (const LiveState& live : states_) {
      const auto a = live_quantity(*said, live, View::space), b = live_quantity(*shown, live, View::space);
      if (!a || !b) continue;
      const double lengths = std::sqrt(dot(a->components, a->components) * dot(b->components, b->components));
      if (lengths == 0) continue;
      if (dot(a->components, b->components) > -(1 - kNear) * lengths) return;
      is_opposite = true;
    }
    if (is_opposite) refuse("the tip of", of.text, tex);
  }

  /// "2\vec L" at the tip of L.
  void check_multiple(const SceneQuantity& of, const std::string& tex) {
    const auto said = read_any(tex), shown = named(of);
    if (!said || !shown || has_name(*said) || said->type() != ExpressionType::vector) return;
    for (const LiveState& live : states_) {
      const auto a = live_quantity(*said, live, View::space), b = live_quantity(*shown, live, View::space);
      if (!a || !b) continue;
      const double size = std::sqrt(dot(a->components, a->components) + dot(b->components, b->components));
      Components off{};
      for (std::size_t i = 0; i < off.size(); ++i) off[i] = a->components[i] - b->components[i];
      if (std::sqrt(dot(off, off)) > kNear * size) return refuse("the tip of", of.text, tex);
    }
  }

  void check_angle(const SceneQuantity& from, const SceneQuantity& to, const std::string& tex) {
    const auto math = parse_math(tex);
    const auto typed = math ? read_typed(*math) : std::nullopt;
    auto said = read_any(tex);
    if (said && !has_name(*said) && !typed && !said->uses(Operation::pi)) said.reset();
    const auto first = expression_of(from), second = expression_of(to);
    if (math && !said && !can_have(dimensions_of_letter(letter_of_name(*math)), kNumber))
      return refuse("the angle from " + from.text + " to", to.text, tex);
    if (math && !can_have(dimensions_of_words(words_of_formula(*math)), kNumber))
      return refuse("the angle from " + from.text + " to", to.text, tex);
    if (math && words_of_formula(*math) == "right angle" && first && second)
      return check_typed_angle(*first, *second, {90, 1, "deg"}, from.text, to.text, tex);
    if (typed && first && second) return check_typed_angle(*first, *second, *typed, from.text, to.text, tex);
    if (!said || !first || !second || said->type() == ExpressionType::vector) return;
    for (const LiveState& live : states_) {
      const auto a = live_quantity(*first, live, View::space), b = live_quantity(*second, live, View::space);
      const auto angle = live_number(*said, live);
      if (!a || !b || !angle) continue;
      const double lengths = std::sqrt(dot(a->components, a->components) * dot(b->components, b->components));
      if (lengths > 0 && std::abs(std::cos(*angle) - dot(a->components, b->components) / lengths) > kNear)
        return refuse("the angle from " + from.text + " to", to.text, tex);
    }
  }

  void check_words(const SceneQuantity& of, const std::string& words, const char* what) {
    if (!can_have(dimensions_of_words(words), dimension(of))) refuse(what, of.text, words);
  }

 private:
  /// "90^\circ", to half a unit of its last digit, at the still.
  void check_typed_angle(const Expression& first, const Expression& second, const TypedNumber& typed,
                         const std::string& from, const std::string& to, const std::string& tex) {
    const auto unit = scaled_unit(typed.unit);
    const double size = unit ? unit->size : 1;
    if (states_.empty()) return;
    const LiveState& still = states_.front();
    const auto a = live_quantity(first, still, View::space), b = live_quantity(second, still, View::space);
    if (!a || !b) return;
    const double lengths = std::sqrt(dot(a->components, a->components) * dot(b->components, b->components));
    if (lengths == 0) return;
    const double angle = std::acos(std::clamp(dot(a->components, b->components) / lengths, -1.0, 1.0));
    if (std::abs(angle / size - typed.value) > 0.5 * typed.last_digit)
      refuse("the angle from " + from + " to", to, tex);
  }

  /// Whether both have other values somewhere.
  bool differs(const Expression& said, const Expression& shown) const {
    return std::any_of(states_.begin(), states_.end(), [&](const LiveState& live) {
      const auto a = live_number(said, live), b = live_number(shown, live);
      return a && b && std::abs(*a - *b) > kNear * (std::abs(*a) + std::abs(*b)) &&
             is_more_than_rounding(*a, *b);
    });
  }

  /// A letter that is not read, or words, of another kind of quantity.
  void check_kind(const SceneQuantity& of, const std::string& tex, const char* what) {
    const auto math = parse_math(tex);
    if (!math) return;
    check_words(of, words_of_formula(*math), what);
    if (!read_any(tex) && !can_have(dimensions_of_letter(letter_of_name(*math)), dimension(of)))
      refuse(what, of.text, tex);
  }

  /// Nothing where it cannot be told.
  std::optional<Dimension> dimension(const SceneQuantity& of) const {
    if (!of.unit.empty()) return dimension_of_unit(of.unit);
    const auto expression = expression_of(of);
    return expression ? dimension_of(*expression, {}).dimension : std::nullopt;
  }

  /// Both are 0 on this motion, but for rounding.
  static bool is_more_than_rounding(double a, double b) {
    constexpr double kNothing = 1e-9;
    return std::max(std::abs(a), std::abs(b)) > kNothing;
  }

  std::optional<Expression> read_any(const std::string& tex) const {
    if (tex.empty()) return std::nullopt;
    const auto math = parse_math(tex);
    auto said = math ? read_side(*math, lesson_.notation) : std::nullopt;
    // "(10)" is the number of an equation.
    const bool is_number = said && std::none_of(said->nodes.begin(), said->nodes.end(), [](const auto& node) {
                             return node.operation == Operation::quantity ||
                                    node.operation == Operation::constant || node.operation == Operation::pi;
                           });
    return is_number ? std::nullopt : said;
  }

  std::optional<Expression> read(const std::string& tex) const {
    auto said = read_any(tex);
    return said && has_name(*said) ? said : std::nullopt;
  }

  /// A quantity, or a word that the lesson prints as something.
  bool has_name(const Expression& expression) const {
    const Vocabulary::Word* word = lesson_.notation.vocabulary.find(expression.text);
    return word != nullptr
               ? !word->tex.empty()
               : expression.nodes.size() == 1 && expression.nodes[0].operation == Operation::quantity;
  }

  std::optional<Expression> expression_of(const SceneQuantity& quantity) const {
    return expression_of(quantity.text);
  }

  std::optional<Expression> expression_of(const std::string& text) const {
    const SourceText source(text);
    Report report(source, "");
    return read_expression(text, {1, 1}, report, &lesson_.notation.vocabulary);
  }

  /// Vectors that a lesson defines are called by what they stand for, such as L before a step.
  std::optional<Expression> named(const SceneQuantity& quantity) const {
    auto shown = expression_of(quantity);
    if (!shown || !has_name(*shown)) return std::nullopt;
    const Quantity first = shown->nodes[0].quantity;
    const bool is_axis = first >= Quantity::e1 && first <= Quantity::ez;
    const bool is_defined = lesson_.notation.vocabulary.find(shown->text) != nullptr;
    if (shown->type() == ExpressionType::vector && (is_defined || is_axis)) return std::nullopt;
    return shown;
  }

  void refuse(const std::string& what, const std::string& text, const std::string& tex) {
    report_.error(place_, what + ' ' + text + " is named " + in_quotes(tex) + ", which is something else",
                  "leave \"tex\" out, or take a name of its own");
  }

  const Lesson& lesson_;
  SourcePlace place_;
  Report& report_;
  std::vector<LiveState> states_;
};

/// The TeX of the formula that a line begins with, or "tip of" one; empty of another.
std::string formula_at_start(std::string line) {
  for (const std::string_view before : {"the tip of ", "tip of "})
    if (line.starts_with(before)) line.erase(0, before.size());
  const std::size_t end = line.size() > 1 && line[0] == '$' ? line.find('$', 1) : line.npos;
  return end == line.npos ? "" : line.substr(1, end - 1);
}

}  // namespace

bool has_names(const Scene& scene) {
  const auto is_named = [](const PlotSpec& plot) {
    const auto* own = std::get_if<OwnPlot>(&plot);
    return own != nullptr && (!own->tex.empty() || !own->title.empty());
  };
  const auto has_name = [](const ArrowMark& arrow) { return arrow.tex && !arrow.tex->empty(); };
  const Marks& marks = scene.marks;
  return std::any_of(scene.meters.begin(), scene.meters.end(), is_named) ||
         std::any_of(marks.arrows.begin(), marks.arrows.end(), has_name) || !marks.notes.empty() ||
         std::any_of(marks.areas.begin(), marks.areas.end(),
                     [](const AreaMark& a) { return !a.tex.empty(); }) ||
         std::any_of(marks.angles.begin(), marks.angles.end(),
                     [](const AngleMark& a) { return !a.tex.empty(); });
}

void check_names(const Lesson& lesson, const SceneModel& model, SourcePlace place, Report& report) {
  NameCheck check(lesson, model, place, report);
  for (const PlotSpec& plot : model.scene.meters) {
    const auto* own = std::get_if<OwnPlot>(&plot);
    if (own == nullptr) continue;
    for (std::size_t i = 0; i < std::min(own->curves.size(), own->tex.size()); ++i)
      check.check_curve(own->curves[i], own->tex[i]);
    if (own->function && !own->tex.empty()) check.check_function(*own->function, own->tex.front());
    check.check_title(*own);
    if (own->against) check.check_title_of_path(*own);
    if (own->function || own->against) continue;
    check.check_title_of(*own);
  }
  for (const ArrowMark& arrow : model.scene.marks.arrows)
    if (arrow.tex) check.check_arrow(arrow.of.quantity, *arrow.tex);
  for (const AngleMark& angle : model.scene.marks.angles)
    if (!angle.tex.empty()) check.check_angle(angle.from.quantity, angle.to.quantity, angle.tex);
  for (const AreaMark& area : model.scene.marks.areas)
    if (!area.tex.empty()) check.check_area(area.from.quantity, area.to.quantity, area.tex);
  for (const NoteMark& note : model.scene.marks.notes) {
    check.check_arrow(note.at.quantity, formula_at_start(note.text));
    check.check_axis(note.at.quantity, note.text, "the tip of");
    check.check_words(note.at.quantity, note.text, "the tip of");
  }
}

}  // namespace polhode
