// SPDX-License-Identifier: MIT
#include "lessons/reader/number_check.h"

#include "base/numbers.h"
#include "lessons/claims/customary_names.h"
#include "lessons/claims/proof.h"
#include "lessons/reader/text_units.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace polhode {
namespace {

constexpr int kDigitsOfHint = 6;
constexpr const char* kOneFormula = "write both into one formula, in which they are compared";

/// As = or ≈ says. What is proved differs only where a method errs: then the number is not what it should
/// be.
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

/// The times of films and of the window, the still first.
std::vector<double> times_of(const NumbersMotion& motion, bool still_alone) {
  std::vector<double> times_s{motion.still_s};
  for (int i = 0; i < (still_alone ? 0 : kMeasuredTimes); ++i)
    times_s.push_back(motion.model.span_s * i / (kMeasuredTimes - 1));
  return times_s;
}

bool has_typed(const Math& math) {
  return std::any_of(math.live.begin(), math.live.end(),
                     [](const LiveNumber& n) { return !n.typed.empty(); });
}

}  // namespace

/// What the head of a column, or of a row, says that its numbers are.
struct NumberCheck::Head {
  std::string text;              ///< for messages
  std::optional<Expression> is;  ///< a formula, or a letter, that can be read
  std::string unit;              ///< in brackets behind it, by the author
  bool has_column_unit = false;  ///< that of a computed column stands behind it
};

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
      refuse(one, "this number is " + to_string(*one.dimension) + ", and stands for a letter of another quantity",
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
                                  const NumbersMotion& motion) {
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
           "the sides of this " + std::string(sign_of(statement.relation)) + " are " +
               digits(value->left[0], kDigitsOfHint) + " and " + digits(value->right[0], kDigitsOfHint) +
               " at t = " + digits(t_s, 3) + " s",
           hint);
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
    if (read->first) check_before(spans, i, number(math, *read->first));
    if (read->last) check_behind(spans, i, number(math, *read->last));
  }
}

/// What stands before a formula that a number begins.
void NumberCheck::check_before(const std::vector<TextSpan>& spans, std::size_t at,
                               const ComputedNumber& number) {
  std::string before;
  std::size_t k = at;
  while (k > 0 && spans[k - 1].kind == TextSpan::Kind::text && !spans[k - 1].break_after)
    before.insert(0, spans[--k].text);
  std::string_view text(before);
  bool has_blank = false;
  while (take_last_blank(text)) has_blank = true;
  if (text.empty()) {
    if (k > 0 && spans[k - 1].kind == TextSpan::Kind::math && !spans[k - 1].break_after)
      refuse(number, "another formula stands directly before this number", kOneFormula);
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
  if (is_figure) refuse(number, "another number stands directly before this one", kOneFormula);
}

/// What stands behind a formula that a number ends, without a unit of its own.
void NumberCheck::check_behind(const std::vector<TextSpan>& spans, std::size_t at,
                               const ComputedNumber& number) {
  if (spans[at].break_after) return;
  std::string behind;
  std::size_t k = at + 1;
  if (k < spans.size() && lesson_.source.compare(spans[k].source.begin, 2, "[^") == 0)
    return refuse(number, "the mark of a footnote reads as a power of this number",
                  "put it behind a word: $…$ J[^note]");
  for (; k < spans.size() && spans[k].kind == TextSpan::Kind::text; ++k) {
    behind += spans[k].text;
    if (spans[k].break_after) break;
  }
  std::string_view text(behind);
  bool has_blank = false;
  while (take_blank(text)) has_blank = true;
  if (text.empty()) {
    if (k < spans.size() && spans[k].kind == TextSpan::Kind::math)
      refuse(number, "another formula stands directly behind this number", kOneFormula);
    return;
  }
  while (!has_blank && starts_with_any(text, {")", "]"})) {
    text.remove_prefix(1);
    if (text.empty() || take_blank(text)) return;
  }
  const bool is_sign =
      starts_with_any(text, {"=", "<", ">", "≤", "≥", "≈", "≠", "±", "×", "·", "+", "−", "*", "^",
                             "/", "²", "³", "⁴", "⁻", "¹", "~", "∼", "≡", "½", "¼", "¾", "!"}) ||
      (!has_blank && text.size() > 1 && std::string_view("-–.,").find(text[0]) != std::string_view::npos &&
       is_digit(text[1]));
  if (is_sign) return refuse(number, "a sign stands behind this number, outside of its formula", kOneFormula);
  if (is_digit(text.front()))
    return refuse(number, "another number stands directly behind this one", kOneFormula);
  for (const std::string_view word : {"dozen", "hundred", "thousand", "million", "billion"})
    if (text.starts_with(word))
      return refuse(number, "this number is not that many " + std::string(word) + "s: it is printed as it is",
                    "write the power of ten as a unit, or leave it out");
  if (text.starts_with("%")) return check_unit(number, "%");
  if (const std::string unit = unit_at_start(text); !unit.empty()) return check_unit(number, unit);
  if (!has_blank && is_letter(text.front()))
    refuse(number, "a letter stands directly behind this number", "put a blank between them");
}

NumberCheck::Head NumberCheck::head_of(const TextTable::Cell& cell) const {
  Head head;
  const Math* formula = nullptr;
  std::string words;
  std::size_t formulas = 0, end = cell.size();
  // The unit of a computed column is added behind what its author wrote.
  if (end >= 3 && cell[end - 3].text == " (" && cell[end - 1].text == ")" &&
      cell[end - 2].kind == TextSpan::Kind::math && read_unit_formula(cell[end - 2].math)) {
    head.has_column_unit = true;
    end -= 3;
  }
  for (std::size_t i = 0; i < end; ++i) {
    if (cell[i].kind == TextSpan::Kind::math) {
      formula = &cell[i].math;
      ++formulas;
      head.text += cell[i].text;
    } else {
      words += cell[i].text;
      head.text += cell[i].text;
    }
  }
  const std::size_t bracket = words.rfind('(');
  const std::size_t close = words.find_last_not_of(' ');
  if (bracket != words.npos && close != words.npos && words[close] == ')') {
    const std::string unit = words.substr(bracket + 1, close - bracket - 1);
    if (std::any_of(unit.begin(), unit.end(), [](char c) { return is_letter(c); }) && scaled_unit(unit))
      head.unit = unit;
    if (!head.unit.empty()) words.erase(bracket);
  }
  // "energy in kJ"
  const std::size_t in = words.rfind(" in ");
  if (head.unit.empty() && in != words.npos) {
    const std::string unit = words.substr(in + 4);
    if (unit == unit_at_start(unit)) head.unit = unit;
    if (!head.unit.empty()) words.erase(in);
  }
  std::string_view rest(words);
  while (take_blank(rest)) {
  }
  while (take_last_blank(rest)) {
  }
  if (formulas == 1 && rest.empty()) {
    head.is = read_side(*formula, notation_);
    auto in_unit = head.is ? std::nullopt : read_in_unit(*formula, notation_);
    if (in_unit)
      std::tie(head.is, head.unit) = std::pair(std::move(in_unit->first), std::move(in_unit->second));
  }
  const bool is_letter_alone = formulas == 0 && !rest.empty() && rest.find(' ') == rest.npos;
  if (is_letter_alone)
    if (const auto math = parse_math(rest)) head.is = read_side(*math, notation_);
  return head;
}

/// A column, or a row, of what its head says; `motions` are those of its numbers.
void NumberCheck::check_head(const Head& head, const ComputedNumber& number,
                             const std::vector<MotionNumbers*>& motions) {
  if (!head.unit.empty() && head.has_column_unit)
    return refuse(number,
                  "the head " + in_quotes(head.text) + " has a unit, and that of the column stands behind it",
                  "leave the one in the head out");
  if (!head.unit.empty()) check_unit(number, head.unit);
  if (!head.is) return;
  const std::string other = "the head says " + in_quotes(head.text) + ", and the numbers are " +
                            in_quotes(number.written.expression);
  const std::string hint = "write a head in words, or show what it says";
  if (head.is->type() == ExpressionType::vector) return refuse(number, other, hint);
  const Equality sides{*head.is, number.expression};
  if (is_provable(sides) && Prover().settle(sides, Assumption::identity) == Verdict::holds) return;
  for (MotionNumbers* motion : motions) {
    const auto said = motion->value_of(*head.is), shown = motion->value_of(number.expression);
    if (!said || !shown) continue;
    constexpr double kRounding = 1e-9;
    if (std::abs(*said - *shown) <= kRounding * (std::abs(*said) + std::abs(*shown))) continue;
    return refuse(
        number, other + ": " + digits(*said, kDigitsOfHint) + " and " + digits(*shown, kDigitsOfHint), hint);
  }
}

/// A table in Markdown: its numbers are of one motion.
void NumberCheck::check_table(const TextTable& table, const NumbersMotion& motion) {
  const auto alone = [&](const TextTable::Cell& cell) -> const ComputedNumber* {
    if (cell.size() != 1 || cell[0].math.live.size() != 1 || number(cell[0].math, 0).row) return nullptr;
    const auto read = read_numbers(cell[0].math, notation_);
    return read && read->first && read->statements.empty() ? &number(cell[0].math, *read->first) : nullptr;
  };
  std::vector<Head> heads;
  for (const TextTable::Cell& cell : table.rows.front()) heads.push_back(head_of(cell));
  for (std::size_t r = 1; r < table.rows.size(); ++r) {
    std::vector<const ComputedNumber*> numbers;
    for (std::size_t c = 0; c < table.rows[r].size(); ++c) {
      const ComputedNumber* shown = alone(table.rows[r][c]);
      if (shown == nullptr) continue;
      numbers.push_back(shown);
      check_head(heads[c], *shown, {&motion.still});
      // Of a row with one number its first cell says what that is, where the column does not.
      if (c > 0 && !heads[c].is && numbers.size() == 1) {
        const auto is_number = [&](const TextTable::Cell& cell) { return alone(cell) != nullptr; };
        if (std::count_if(table.rows[r].begin(), table.rows[r].end(), is_number) == 1)
          check_head(head_of(table.rows[r].front()), *shown, {&motion.still});
      }
    }
  }
}

void NumberCheck::check_computed_tables(const RichText& text) {
  for (const TextBlock& block : text) {
    if (!block.is_table()) continue;
    for (std::size_t c = 0; c < block.table.columns.size(); ++c) {
      std::vector<const ComputedNumber*> numbers;
      for (std::size_t r = 1; r < block.table.rows.size(); ++r)
        for (const TextSpan& span : block.table.rows[r][c])
          if (span.math.live.size() == 1 && number(span.math, 0).row)
            numbers.push_back(&number(span.math, 0));
      if (numbers.empty()) continue;
      const Head head = head_of(block.table.rows.front()[c]);
      const Equality sides{head.is.value_or(numbers.front()->expression), numbers.front()->expression};
      const bool is_same = is_provable(sides) && fit(sides.left.type(), sides.right.type()) &&
                           Prover().settle(sides, Assumption::identity) == Verdict::holds;
      std::vector<SceneModel> models;
      std::vector<MotionNumbers> motions;
      std::vector<MotionNumbers*> of_rows;
      if (!is_same) {
        models.reserve(numbers.size());
        motions.reserve(numbers.size());
        for (const ComputedNumber* one : numbers) {
          models.push_back(make_model(one->row->scene, Product::numbers, effort_));
          motions.emplace_back(models.back(), one->row->scene.at_s, effort_);
          of_rows.push_back(&motions.back());
        }
      }
      check_head(head, *numbers.front(), of_rows);
    }
  }
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

}  // namespace polhode
