// SPDX-License-Identifier: MIT
#include "lessons/reader/checks/numbers/number_check.h"

#include "base/ascii.h"
#include "base/numbers.h"
#include "lessons/claims/customary_names.h"
#include "lessons/claims/proof/proof.h"
#include "lessons/reader/checks/prose/clause.h"
#include "lessons/reader/checks/prose/quantity_words.h"
#include "lessons/reader/text_units.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace polhode {
namespace {

constexpr const char* kOneFormula = "write both into one formula, in which they are compared";

/// The times of films and of the window, the still first.
std::vector<double> times_of(const NumbersMotion& motion, bool still_alone) {
  std::vector<double> times_s{motion.still_s};
  for (int i = 0; i < (still_alone ? 0 : kMeasuredTimes); ++i)
    times_s.push_back(motion.model.span_s * i / (kMeasuredTimes - 1));
  return times_s;
}

/// 60*norm(omega)/(2*pi), or 30*norm(omega)/pi: a rate of seconds is one of minutes.
bool counts_sixty(const Expression& expression) {
  return std::any_of(expression.nodes.begin(), expression.nodes.end(), [](const ExpressionNode& node) {
    return node.operation == Operation::number && (node.number.value == 60 || node.number.value == 30);
  });
}

bool has_typed(const Math& math) {
  return std::any_of(math.live.begin(), math.live.end(),
                     [](const LiveNumber& n) { return !n.typed.empty(); });
}

}  // namespace

bool agree(const LiveValue& value, Relation relation, bool is_proved) {
  const double l = value.left[0], r = value.right[0];
  constexpr double kRounding = 1e-9, kShown = 1e-3;
  const bool are_equal = value.residual <= (is_proved ? kShown : std::max(value.tolerance, kRounding));
  switch (relation) {
    case Relation::approximate:
      return std::abs(l - r) <= kSmallOnMotion * std::max(std::abs(l), std::abs(r));
    case Relation::less:
      return is_proved || l < r;
    case Relation::greater:
      return is_proved || l > r;
    case Relation::less_or_equal:
      return is_proved || l < r || are_equal;
    case Relation::greater_or_equal:
      return is_proved || l > r || are_equal;
    case Relation::equal:
      break;
  }
  return are_equal;
}

NumberCheck::NumberCheck(const Lesson& lesson, Report& report, const Effort& effort)
    : lesson_(lesson), report_(report), effort_(effort), notation_(lesson.notation) {
  std::map<int, Dimension> dimensions;
  add_motion_words(notation_.vocabulary, dimensions);
}

const ComputedNumber& NumberCheck::number(const Math& math, std::size_t index) const {
  return lesson_.numbers[static_cast<std::size_t>(math.live[index].id)];
}

void NumberCheck::refuse(const ComputedNumber& number, const std::string& message, const std::string& hint) {
  report_.error(number.place, message, hint);
}

void NumberCheck::check_formula(const Math& math, const Math* above, const NumbersMotion& motion,
                                bool is_proved) {
  if (math.live.empty() || !math.root) return;
  if (!math.tag.empty() && scaled_unit(math.tag) && is_letter(math.tag.back()))
    refuse(number(math, 0), "the tag of this formula reads as a unit of its number: " + in_quotes(math.tag),
           "take a number, or letters that are no unit");
  const auto read = read_equation(math, lesson_.notation, above);
  if (!read || read->is_part) return check_apart(math, above, motion);
  std::vector<const EquationLink*> links;
  for (const EquationSentence& sentence : read->sentences) {
    const auto is_number = [](const EquationLink& link) { return link.is_number; };
    if (std::any_of(sentence.links.begin(), sentence.links.end(), is_number))
      for (const EquationLink& link : sentence.links) links.push_back(&link);
  }
  // What is typed is of the still alone.
  for (const double t_s : times_of(motion, has_typed(math))) {
    const auto live = live_state(motion.model, t_s);
    if (!live) continue;
    for (const EquationLink* link : links) {
      ClaimLine line;
      line.equality = link->equality;
      const auto value = live_value(line, *live, View::space);
      if (value && agree(*value, link->relation, is_proved)) continue;
      const ComputedNumber& shown = number(math, 0);
      if (!value) {
        if (t_s == motion.still_s && link->is_number && is_proved)
          refuse(shown, "what this number stands behind has no value on the scene's motion");
        continue;
      }
      return refuse(shown,
                    "this is not the number of what it stands behind: at t = " + digits(t_s, 3) +
                        " s that is " + digits(value->left[0], kDigitsOfHint) + ", and this " +
                        digits(value->right[0], kDigitsOfHint),
                    link->relation == Relation::approximate
                        ? "≈ allows for a tenth; show a motion on which it is nearer"
                        : "write the same on both sides of the =");
    }
  }
}

/// A formula that is no equation as a whole.
void NumberCheck::check_apart(const Math& math, const Math* above, const NumbersMotion& motion) {
  const auto read = read_numbers(math, notation_, above);
  if (!read) {
    const SourceSpan place = read.error().place;
    std::size_t at = 0;  // the first number in what is not read
    while (at + 1 < math.live.size() && math.live[at].whole.end <= place.begin) ++at;
    return refuse(number(math, at), read.error().reason, read.error().hint);
  }
  for (const PrintedUnit& unit : read->units) check_unit(number(math, unit.number), unit.unit);
  for (const NumberName& name : read->names)
    if (const ComputedNumber& one = number(math, name.number);
        !can_have(dimensions_of_letter(name.letter), one.dimension))
      refuse(one,
             "this number is " + to_string(*one.dimension) + ", and stands for a letter of another quantity",
             "take another letter, or write what the letter is");
  for (const NumberStatement& statement : read->statements)
    if (!check_statement(math, statement, motion)) return;
  for (const ComponentsStatement& components : read->components) check_components(math, components, motion);
}

/// A vector has its components on the axes of the body, or of space: of both at one time none is wrong.
void NumberCheck::check_components(const Math& math, const ComponentsStatement& statement,
                                   const NumbersMotion& motion) {
  for (const double t_s : times_of(motion, has_typed(math))) {
    const auto live = live_state(motion.model, t_s);
    if (!live) continue;
    const auto all_agree = [&](const std::vector<Equality>& components) {
      return std::all_of(components.begin(), components.end(), [&](const Equality& component) {
        ClaimLine line;
        line.equality = component;
        const auto value = live_value(line, *live, View::space);
        return !value || agree(*value, Relation::equal, false);
      });
    };
    if (all_agree(statement.on_body) || all_agree(statement.on_space)) continue;
    return refuse(number(math, statement.number),
                  "these are its components neither on the axes of the body nor of space, at t = " +
                      digits(t_s, 3) + " s",
                  "write the components of what stands before the =, in their order");
  }
}

/// False, and a report, where its sides differ on the motion.
bool NumberCheck::check_statement(const Math& math, const NumberStatement& statement,
                                  const NumbersMotion& motion, const std::string& said) {
  const auto typed = [&](const std::optional<std::size_t>& side) {
    return side && !math.live[*side].typed.empty();
  };
  const ComputedNumber& shown = number(math, statement.right ? *statement.right : statement.left.value_or(0));
  const std::string hint = "write the same on both sides, or ≈ where a tenth does not matter";
  const bool left_typed = typed(statement.left), right_typed = typed(statement.right);
  const auto left = motion.still.written_out(statement.equality.left),
             right = motion.still.written_out(statement.equality.right);
  if (!left || !right) return true;  // said of the number itself
  // A typed number is what it is printed as, to its last digit.
  if (statement.relation == Relation::equal && left_typed != right_typed) {
    const auto other = motion.still.value_of(left_typed ? *right : *left);
    const auto instead = other ? right_instead(shown, *other / shown.unit_si) : std::nullopt;
    if (!instead) return true;
    refuse(shown,
           "this is not the number of the other side of its =, which is " +
               digits(*other / shown.unit_si, kDigitsOfHint) + " at t = " + digits(motion.still_s, 3) + " s",
           "write more digits there, or \\approx");
    return false;
  }
  const bool still_alone = has_typed(math) || has_motion_words(statement.equality.left) ||
                           has_motion_words(statement.equality.right);
  for (const double t_s : times_of(motion, still_alone)) {
    const auto live = live_state(motion.model, t_s);
    if (!live) continue;
    ClaimLine line;
    line.equality = {*left, *right};
    const auto value = live_value(line, *live, View::space);
    if (!value || agree(*value, statement.relation, false)) continue;
    refuse(shown,
           (said.empty() ? "the sides of this " + std::string(sign_of(statement.relation)) + " are "
                         : in_quotes(said) + " is said of this number, and they are ") +
               digits(value->left[0], kDigitsOfHint) + " and " + digits(value->right[0], kDigitsOfHint) +
               " at t = " + digits(t_s, 3) + " s",
           said.empty() ? hint : "say what it is, or show what is said");
    return false;
  }
  return true;
}

void NumberCheck::check_unit(const ComputedNumber& number, const std::string& unit) {
  const auto read = unit == "%" ? ScaledUnit{} : scaled_unit(unit);
  if (!read) return;
  if (!number.written.unit.empty())
    return refuse(
        number,
        "two units stand behind this number, " + in_quotes(number.written.unit) + " and " + in_quotes(unit),
        "leave one out");
  if (number.dimension && *number.dimension != read->dimension)
    return refuse(number, "units disagree: this number is " + to_string(*number.dimension) + ", and " +
                              in_quotes(unit) + " stands behind it");
  constexpr double kRounding = 1e-12;
  if (std::abs(read->size / number.unit_si - 1) > kRounding)
    refuse(number, "this number is in units of SI, and " + in_quotes(unit) + " stands behind it",
           "write the unit into the number: \\live[unit={" + unit + "}]{…}");
}

void NumberCheck::check_text(const RichText& text, const NumbersMotion& motion) {
  for (const TextBlock& block : text) {
    check_spans(block.spans, motion);
    for (const auto& row : block.table.rows)
      for (const TextTable::Cell& cell : row) check_spans(cell, motion);
    if (block.is_table()) check_table(block.table, motion);
  }
}

void NumberCheck::check_spans(const std::vector<TextSpan>& spans, const NumbersMotion& motion) {
  for (std::size_t i = 0; i < spans.size(); ++i) {
    const Math& math = spans[i].math;
    if (math.live.empty() || number(math, 0).row) continue;
    check_formula(math, nullptr, motion, false);
    const auto read = read_numbers(math, notation_);
    if (!read) continue;
    if (read->first) check_before(spans, i, *read->first, motion);
    if (read->last) check_behind(spans, i, number(math, *read->last), read->last_has_unit);
  }
}

/// What stands before a formula that a number begins.
void NumberCheck::check_before(const std::vector<TextSpan>& spans, std::size_t at, std::size_t index,
                               const NumbersMotion& motion) {
  const ComputedNumber& number = this->number(spans[at].math, index);
  std::string before;
  std::size_t k = at;
  while (k > 0 && spans[k - 1].kind == TextSpan::Kind::text && !spans[k - 1].break_after)
    before.insert(0, spans[--k].text);
  std::string_view text(before);
  bool has_blank = false;
  while (take_last_blank(text)) has_blank = true;
  const bool is_behind_formula =
      k > 0 && spans[k - 1].kind == TextSpan::Kind::math && !spans[k - 1].break_after;
  if (text.empty()) {
    if (is_behind_formula) refuse(number, "another formula stands directly before this number", kOneFormula);
    return;
  }
  // What stands before a bracket that it is in, directly.
  while (!has_blank && ends_with_any(text, {"(", "["})) {
    text.remove_suffix(1);
    if (text.empty() || take_last_blank(text)) return;
  }
  const bool is_sign = ends_with_any(text, {"=", "<", ">", "≤", "≥", "≈", "≠", "±", "×", "·", "+", "−", "*",
                                            "^", "/", "√", "~", "∼", "≡", "→", "½", "¼", "¾", "∂", "Δ"}) ||
                       (!has_blank && ends_with_any(text, {"-", "–"}));
  if (is_sign) return refuse(number, "a sign stands before this number, outside of its formula", kOneFormula);
  const bool is_figure =
      is_digit(text.back()) || (!has_blank && text.size() > 1 && (text.back() == '.' || text.back() == ',') &&
                                is_digit(text[text.size() - 2]));
  if (is_figure) return refuse(number, "another number stands directly before this one", kOneFormula);
  if (const std::string_view factor = factor_before(text); !factor.empty())
    return refuse(number, in_quotes(factor) + " before this number makes it another",
                  "write it into the expression of the number");
  if (const std::string unit = unit_said_before(text); !unit.empty() && number.written.unit != unit)
    return check_unit(number, unit);
  std::vector<TextSpan> clause = clause_before(spans, at);
  const auto joined = take_verb(clause);
  if (joined && has_words(clause)) {
    // "half of $I_3$ is"; where words make of the formula before the verb another quantity nothing is known.
    const auto said = quantity_said_at_end(clause, lesson_);
    std::string words;
    for (const TextSpan& span : clause) words += span.text;
    if (said)
      check_statement(spans[at].math, {{*said, number.expression}, *joined, {}, index}, motion, words);
    if (said || is_behind_formula) return;
  }
  const auto relation = is_behind_formula ? relation_said(text) : std::nullopt;
  if (relation) return check_said(spans[k - 1].math, *relation, spans[at].math, index, motion);
  if (!can_have(dimensions_of_words(name_said_before(text)), number.dimension))
    refuse(number,
           "this number is " + to_string(*number.dimension) + ", and " + in_quotes(name_said_before(text)) +
               " is said of it",
           "say what it is, or show what is said");
}

/// "$T$ is $3.8$": what stands before the verb.
void NumberCheck::check_said(const Math& said, Relation relation, const Math& math, std::size_t index,
                             const NumbersMotion& motion) {
  const ComputedNumber& shown = number(math, index);
  const auto is = read_side(said, notation_);
  const auto of_letter = is ? std::vector<Dimension>() : dimensions_of_letter(letter_of_name(said));
  if (!can_have(of_letter, shown.dimension) || (is && is->type() == ExpressionType::vector))
    return refuse(shown, "this number is no value of the formula before it", "show what is said");
  if (is) check_statement(math, {{*is, shown.expression}, relation, std::nullopt, index}, motion);
}

/// What stands behind a formula that a number ends.
void NumberCheck::check_behind(const std::vector<TextSpan>& spans, std::size_t at,
                               const ComputedNumber& number, bool has_unit) {
  std::string behind;
  std::size_t k = at + 1;
  if (!spans[at].break_after && k < spans.size() &&
      lesson_.source.compare(spans[k].source.begin, 2, "[^") == 0)
    return refuse(number, "the mark of a footnote reads as a power of this number",
                  "put it behind a word: $…$ J[^note]");
  for (; k < spans.size() && spans[k].kind == TextSpan::Kind::text; ++k) {
    behind += spans[k].text;
    if (spans[k].break_after) break;
  }
  std::string_view text(behind);
  bool has_blank = false;
  while (take_blank(text)) has_blank = true;
  const auto check_behind_unit = [&](const std::string& unit) {
    if (has_unit && number.written.unit.empty())
      return refuse(number, "two units stand behind this number, one of them outside of its formula",
                    "leave one out");
    check_unit(number, unit);
  };
  if (spans[at].break_after) {
    // A unit alone on the next line goes on with the number.
    while (!text.empty() && (text.back() == '.' || text.back() == ',')) text.remove_suffix(1);
    if (const std::string unit = whole_unit(text); !unit.empty()) check_behind_unit(unit);
    return;
  }
  if (text.empty()) {
    if (k < spans.size() && spans[k].kind == TextSpan::Kind::math)
      refuse(number, "another formula stands directly behind this number", kOneFormula);
    return;
  }
  if (has_blank && starts_with_any(text, {"(", "["})) {
    const std::size_t close = text.find_first_of(")]");
    const std::string unit = whole_unit(text.substr(1, std::min(close, text.size()) - 1));
    if (close != text.npos && !unit.empty() && unit != number.written.unit) check_behind_unit(unit);
    return;
  }
  while (!has_blank && starts_with_any(text, {")", "]"})) {
    text.remove_prefix(1);
    if (text.empty() || take_blank(text)) return;
  }
  const bool is_factorial = text.starts_with("!") && !has_unit;
  const bool is_sign =
      is_factorial ||
      starts_with_any(text, {"=", "<", ">", "≤", "≥", "≈", "≠", "±", "×", "·", "+", "−", "*",
                             "^", "/", "²", "³", "⁴", "⁻", "¹", "~", "∼", "≡", "½", "¼", "¾"}) ||
      (!has_blank && text.size() > 1 && std::string_view("-–.,").find(text[0]) != std::string_view::npos &&
       is_digit(text[1]));
  if (is_sign) return refuse(number, "a sign stands behind this number, outside of its formula", kOneFormula);
  if (is_digit(text.front()))
    return refuse(number, "another number stands directly behind this one", kOneFormula);
  if (const std::string_view word = factor_behind(text); !word.empty())
    return refuse(number, in_quotes(word) + " behind this number makes it another: it is printed as it is",
                  "write the power of ten as a unit, or leave it out");
  if (starts_with_any(text, {"turns", "revolutions"}) && number.dimension && *number.dimension != kNumber) {
    const bool is_in_minutes = text.find(" minute") < text.find_first_of(".,;");
    const std::string why = number.written.unit == "Hz" ? "" : why_not_in(number.expression, "Hz");
    if (number.written.unit.find("rad") != std::string::npos || !why.empty())
      return refuse(number, "this number counts radians, and turns are said of it", "divide it by 2*pi");
    if (is_in_minutes && !counts_sixty(number.expression))
      return refuse(number, "this number is of seconds, and minutes are said of it", "multiply it by 60");
  }
  if (starts_with_any(text, {"%", "percent", "per cent"})) return check_behind_unit("%");
  if (text.starts_with("per ")) {
    const std::string unit = unit_at_start(text.substr(4));
    if (!unit.empty()) return check_behind_unit("1/" + unit);
  }
  if (const std::string unit = unit_at_start(text); !unit.empty()) return check_behind_unit(unit);
  for (const std::string_view before : {"in ", ", in "})
    if (text.starts_with(before) && !has_unit)
      if (const std::string unit = unit_at_start(text.substr(before.size())); !unit.empty())
        return check_unit(number, unit);
  if (!has_blank && is_letter(text.front()))
    refuse(number, "a letter stands directly behind this number", "put a blank between them");
}

void NumberCheck::check_shared(const std::vector<int>& ids, const std::vector<const SceneModel*>& models) {
  for (const int id : ids) {
    const ComputedNumber& number = lesson_.numbers[static_cast<std::size_t>(id)];
    const int shown_digits = number.written.digits > 0 ? number.written.digits : 5;
    for (int i = -1; i < (number.is_typed() ? 0 : kMeasuredTimes); ++i) {
      std::optional<double> first;
      bool is_same = true;
      double value_there = 0, t_s = 0;
      for (const SceneModel* model : models) {
        t_s = i < 0 ? still_time_s(models.front()->scene) : models.front()->span_s * i / (kMeasuredTimes - 1);
        MotionNumbers motion(*model, t_s, effort_);
        const auto value = value_of(number, motion);
        if (!first) {
          first = value;
          if (!value) break;
          continue;
        }
        constexpr double kRounding = 1e-9;
        value_there = value.value_or(std::numeric_limits<double>::quiet_NaN());
        const bool agrees =
            value && (std::abs(*value - *first) <= kRounding * (std::abs(*value) + std::abs(*first)) ||
                      fmt::format("{:.{}e}", *value, shown_digits - 1) ==
                          fmt::format("{:.{}e}", *first, shown_digits - 1));
        const bool is_as_typed = !number.is_typed() || (value && !right_instead(number, *value));
        is_same = number.is_typed() ? is_as_typed : agrees;
        if (!is_same) break;
      }
      if (is_same) continue;
      refuse(number,
             "this caption stands once below pictures of several motions, and the number is " +
                 digits(*first, kDigitsOfHint) + " in one and " + digits(value_there, kDigitsOfHint) +
                 " in another at t = " + digits(t_s, 3) + " s",
             "give each scene a caption of its own, or write the number into the text, which speaks of the "
             "first");
      break;
    }
  }
}

namespace {

/// "ω₂" as TeX; empty of what is no letter with an index.
std::string tex_of_plain_name(std::string_view name) {
  std::string tex;
  if (starts_with_any(name, {"ω"})) {
    tex = "\\omega";
    name.remove_prefix(std::string_view("ω").size());
  } else if (!name.empty() && is_letter(name.front())) {
    tex = name.substr(0, 1);
    name.remove_prefix(1);
  }
  if (tex.empty() || name.empty()) return tex;
  constexpr std::array<std::string_view, 4> kIndices{"₀", "₁", "₂", "₃"};
  const auto index = std::find(kIndices.begin(), kIndices.end(), name);
  return index == kIndices.end() ? "" : tex + '_' + std::to_string(index - kIndices.begin());
}

/// "T = 3 kJ", "ω₂ = 1 rad/s" in plain words, as a formula.
std::optional<Math> statement_in_words(const std::string& text) {
  constexpr std::string_view kEquals = " = ";
  const std::size_t at = text.find(kEquals);
  if (at == text.npos || at == 0) return std::nullopt;
  const std::size_t before = text.find_last_of(" (,;", at - 1);
  const std::string name = tex_of_plain_name(std::string_view(text).substr(
      before == text.npos ? 0 : before + 1, at - (before == text.npos ? 0 : before + 1)));
  const std::size_t begin = at + kEquals.size();
  std::size_t end = begin;
  while (end < text.size() && (is_digit(text[end]) || text[end] == '-' ||
                               (text[end] == '.' && end + 1 < text.size() && is_digit(text[end + 1]))))
    ++end;
  if (name.empty() || end == begin) return std::nullopt;
  const std::string unit = unit_behind(std::string_view(text).substr(end));
  auto math = parse_math(name + " = " + text.substr(begin, end - begin) +
                         (unit.empty() ? "" : "\\,\\text{" + unit + '}'));
  return math ? std::optional(std::move(*math)) : std::nullopt;
}

/// Whether two times are typed in a line, the ends of an interval.
bool has_ends_of_interval(const TextBlock& line, const EquationNotation& notation) {
  int times = 0;
  for (const TextSpan& span : line.spans)
    if (span.kind == TextSpan::Kind::math)
      for (const TypedStatement& statement : typed_statements(span.math, notation))
        times += statement.of ? 0 : 1;
  return times == 2;
}

}  // namespace

bool NumberCheck::has_typed_numbers(const RichText& text) const {
  for (const TextBlock& block : text)
    for (const TextSpan& span : block.spans)
      if ((span.kind == TextSpan::Kind::math && !typed_statements(span.math, notation_).empty()) ||
          (span.kind == TextSpan::Kind::text && statement_in_words(span.text)))
        return true;
  return false;
}

void NumberCheck::check_typed(const RichText& text, const SceneModel& model, double still_s,
                              SourcePlace place) {
  for (const TextBlock& block : text)
    for (std::size_t i = 0; i < block.spans.size(); ++i) {
      const TextSpan& span = block.spans[i];
      const auto in_words = span.kind == TextSpan::Kind::text ? statement_in_words(span.text) : std::nullopt;
      const Math* math = span.kind == TextSpan::Kind::math ? &span.math : in_words ? &*in_words : nullptr;
      if (math == nullptr) continue;
      for (TypedStatement& statement : typed_statements(*math, notation_)) {
        if (statement.number.unit.empty() && i + 1 < block.spans.size() && !span.break_after)
          statement.number.unit = unit_behind(block.spans[i + 1].text);
        // "From $t = 0$ to $t = 2$ s" says what part of the motion is shown.
        if (!statement.of && has_ends_of_interval(block, notation_)) continue;
        const auto wrong = wrong_value(statement, model, {still_s, 0});
        if (wrong)
          return report_.error(place,
                               "a caption says " + in_quotes(span.text) + ", and on its motion that is " +
                                   digits(*wrong, kDigitsOfHint) + " at t = " + digits(still_s, 3) + " s",
                               "write the number as \\value{…}{…}, or leave it out");
      }
    }
}

}  // namespace polhode
