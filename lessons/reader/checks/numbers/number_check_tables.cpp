// SPDX-License-Identifier: MIT
// Heads of tables, units in the cells beside numbers, and what is typed about the motion of a row.
#include "base/numbers.h"
#include "lessons/claims/customary_names.h"
#include "lessons/claims/proof/proof.h"
#include "lessons/reader/checks/numbers/number_check.h"
#include "lessons/reader/checks/numbers/typed_numbers.h"
#include "lessons/reader/checks/prose/quantity_words.h"
#include "lessons/reader/text_units.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace polhode {

namespace {}  // namespace

/// What the head of a column, or of a row, says that its numbers are.
struct NumberCheck::Head {
  std::string text;                   ///< for messages
  std::optional<Expression> is;       ///< a formula, or a letter, that can be read
  std::vector<Dimension> dimensions;  ///< of what is not read: of its words, or its letter; empty: any
  std::string unit;                   ///< behind it, by the author
  bool has_column_unit = false;       ///< that of a computed column stands behind it
};

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
  // "energy in kJ", "$T$, kJ", "$T$ kJ"
  head.unit = take_unit_at_end(words);
  const bool ends_in_words = end > 0 && cell[end - 1].kind == TextSpan::Kind::text;
  if (head.unit.empty() && formulas == 1 && ends_in_words) head.unit = whole_unit(cell[end - 1].text);
  if (!head.unit.empty() && formulas == 1 && words == cell[end - 1].text) words.clear();
  const std::string_view rest = without_blanks(words);
  head.dimensions = formulas == 0 ? dimensions_of_words(rest) : std::vector<Dimension>();
  // "the energy $T$"
  const bool names_formula = formulas == 1 && !ends_in_words &&
                             (rest == "the" || rest == "its" || !dimensions_of_words(rest).empty());
  if (names_formula || (formulas == 1 && rest.empty())) {
    head.is = read_side(*formula, notation_);
    auto in_unit = head.is ? std::nullopt : read_in_unit(*formula, notation_);
    if (in_unit)
      std::tie(head.is, head.unit) = std::pair(std::move(in_unit->first), std::move(in_unit->second));
    if (!head.is) head.dimensions = dimensions_of_letter(letter_of_name(*formula));
  }
  // "ratio of $I_1$ to $I_3$"
  if (!head.is && (formulas > 0 || rest.find(' ') != rest.npos || rest.size() > 2)) {
    std::vector<TextSpan> name(cell.begin(), cell.begin() + static_cast<std::ptrdiff_t>(end));
    if (!name.empty() && name.back().kind == TextSpan::Kind::text) {
      std::string last = name.back().text;
      take_unit_at_end(last);
      name.back().text = last;
    }
    head.is = quantity_said(name, lesson_);
    if (head.is) head.dimensions.clear();
  }
  const bool is_letter_alone = formulas == 0 && !rest.empty() && rest.find(' ') == rest.npos;
  if (is_letter_alone)
    if (const auto math = parse_math(rest)) {
      head.is = read_side(*math, notation_);
      if (!head.is && head.unit.empty() && rest != "N") head.unit = whole_unit(rest);  // N counts, too
      if (!head.is && head.unit.empty() && rest.size() == 1)
        head.dimensions = dimensions_of_letter(letter_of_name(*math));
    }
  // "3" is how a row or a column is called, and no value.
  const auto is_measured = [](const ExpressionNode& node) {
    return node.operation == Operation::quantity || node.operation == Operation::constant;
  };
  if (head.is && std::none_of(head.is->nodes.begin(), head.is->nodes.end(), is_measured)) head.is.reset();
  return head;
}

/// A column, or a row, of what its head says; `motions` are those of its numbers.
void NumberCheck::check_head(const Head& head, const ComputedNumber& number,
                             const std::vector<MotionNumbers*>& motions) {
  if (!head.unit.empty() && head.has_column_unit)
    return refuse(number,
                  "the head " + in_quotes(head.text) + " has a unit, and that of the column stands behind it",
                  "leave the one in the head out");
  // "180/pi*acos(…)" is in degrees by itself.
  const bool is_converted = starts_with_any(head.unit, {"°", "deg"}) && number.expression.uses(Operation::pi);
  if (!head.unit.empty() && !is_converted && head.unit != number.written.unit) check_unit(number, head.unit);
  const bool is_of_hundred = number.written.expression.find("100") != std::string::npos;
  const bool is_percent =
      head.text.find('%') != std::string::npos || head.text.find("per cent") != std::string::npos;
  if (is_percent && !is_of_hundred && number.dimension && *number.dimension == kNumber)
    return refuse(number, "the head says per cent, and this number is a part of 1", "multiply it by 100");
  for (const char* counted : {"turns per ", "turns a ", "revolutions", "frequency"})
    if (head.text.find(counted) != std::string::npos && number.dimension && *number.dimension == kRate &&
        !why_not_in(number.expression, "Hz").empty())
      return refuse(number, "the head counts turns, and this number radians", "divide it by 2*pi");
  if (!head.is && !can_have(head.dimensions, number.dimension))
    return refuse(
        number,
        "the head says " + in_quotes(head.text) + ", and this number is " + to_string(*number.dimension),
        "write what the numbers are");
  if (!head.is) return;
  const std::string other = "the head says " + in_quotes(head.text) + ", and the numbers are " +
                            in_quotes(number.written.expression);
  const std::string hint = "write a head in words, or show what it says";
  if (head.is->type() == ExpressionType::vector) return refuse(number, other, hint);
  const Equality sides{*head.is, number.expression};
  if (is_provable(sides) && Prover().settle(sides, LawsAssumed::identity) == Verdict::holds) return;
  for (MotionNumbers* motion : motions) {
    auto said = motion->value_of(*head.is);
    const auto shown = motion->value_of(number.expression);
    if (!said || !shown) continue;
    if (is_converted) *said /= scaled_unit(head.unit)->size;
    constexpr double kRounding = 1e-9;
    if (std::abs(*said - *shown) <= kRounding * (std::abs(*said) + std::abs(*shown))) continue;
    return refuse(
        number, other + ": " + digits(*said, kDigitsOfHint) + " and " + digits(*shown, kDigitsOfHint), hint);
  }
}

/// "kJ" in the cell behind a number, or "million".
void NumberCheck::check_unit_beside(const TextTable::Cell& cell, const ComputedNumber& number) {
  std::string words;
  for (const TextSpan& span : cell) {
    if (span.kind != TextSpan::Kind::text) return;
    words += span.text;
  }
  if (const std::string unit = whole_unit(words); !unit.empty() && unit != number.written.unit)
    return check_unit(number, unit);
  if (const std::string_view factor = factor_behind(words); !factor.empty())
    refuse(number, in_quotes(factor) + " in the cell behind this number makes it another",
           "write the power of ten as a unit, or leave it out");
}

/// "axis" above the first cells, which are 1, 2 and 3: each row is of its own.
void NumberCheck::check_axis_of_row(const TextTable::Cell& head, const TextTable::Cell& cell,
                                    const ComputedNumber& number) {
  if (cell.size() != 1 || head.size() != 1) return;
  const bool counts_axes = head.front().text == "$i$" || head.front().text == "i" ||
                           head.front().text.find("axis") != std::string::npos ||
                           cell.front().text.find("axis") != std::string::npos;
  const auto said = counts_axes ? axis_of_name(cell.front().text) : std::nullopt;
  const std::string axes = axes_in(number.expression);
  if (said && !axes.empty() && axes.find(*said) == axes.npos)
    refuse(number, "this row is of axis " + std::string(1, *said) + ", and its number of another",
           "write each number into the row of its axis");
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
      check_axis_of_row(table.rows.front().front(), table.rows[r].front(), *shown);
      if (c + 1 < table.rows[r].size()) check_unit_beside(table.rows[r][c + 1], *shown);
      // Of a row with one number its first cell says what that is, where the column does not.
      if (c > 0 && !heads[c].is && numbers.size() == 1) {
        const auto is_number = [&](const TextTable::Cell& cell) { return alone(cell) != nullptr; };
        if (std::count_if(table.rows[r].begin(), table.rows[r].end(), is_number) == 1)
          check_head(head_of(table.rows[r].front()), *shown, {&motion.still});
      }
    }
  }
}

std::optional<double> wrong_value(const TypedStatement& statement, const SceneModel& model,
                                  const std::vector<double>& times_s) {
  const auto unit = scaled_unit(statement.number.unit);
  const double percent = 0.01,
               size = unit                           ? unit->size
                      : statement.number.unit == "%" ? percent
                                                     : 1,
               typed = statement.number.value;
  std::optional<double> wrong;
  for (const double t_s : times_s) {
    std::optional<double> value = t_s / size;
    if (statement.of) {
      const auto live = live_state(model, t_s);
      value = live ? live_number(*statement.of, *live) : std::nullopt;
      if (value) *value /= size;
    }
    if (!value) return std::nullopt;
    const double allowed = statement.relation == Relation::approximate
                               ? kSmallOnMotion * std::max(std::abs(*value), std::abs(typed))
                               : 0.5 * statement.number.last_digit * (1 + 1e-9);
    const bool is_right = is_order(statement.relation)
                              ? (typed < *value) == (statement.relation == Relation::greater ||
                                                     statement.relation == Relation::greater_or_equal)
                              : std::abs(*value - typed) <= allowed;
    if (is_right) return std::nullopt;
    if (!wrong) wrong = value;
  }
  return wrong;
}

/// "$I_3 = 9\,I_1$", on the row's motion, at its time or as it began.
void NumberCheck::check_row_statements(const Math& math, const ComputedNumber& of_row) {
  const SceneModel model = make_model(of_row.row->scene, ModelFor::numbers, effort_);
  for (const StatedLink& link : stated_in(math, notation_).links) {
    if (!link.left.is || !link.right.is || link.right.typed || link.left.typed || link.is_of_a_time() ||
        link.is_of_all_times || link.is_denied)
      continue;
    ClaimLine line;
    line.equality = {*link.left.is, *link.right.is};
    std::optional<LiveValue> wrong;
    for (const double t_s : {of_row.row->scene.at_s, 0.0}) {
      const auto live = live_state(model, t_s);
      auto value = live ? live_value(line, *live, View::space) : std::nullopt;
      if (!value || agree(*value, link.relation, false)) return;
      if (!wrong) wrong = std::move(value);
    }
    if (wrong)
      return report_.error(of_row.row->place,
                           "a cell of this row says that " + link.left.is->text + ' ' +
                               std::string(sign_of(link.relation)) + ' ' + link.right.is->text +
                               ", and on its motion these are " + digits(wrong->left[0], kDigitsOfHint) +
                               " and " + digits(wrong->right[0], kDigitsOfHint),
                           "write what the row's motion is");
  }
}

/// "3 s" below "time" is the time of the row's numbers.
void NumberCheck::check_time_of_row(const TextTable::Cell& head, const TextTable::Cell& cell,
                                    const ComputedNumber& of_row) {
  const auto typed = number_in_cell(cell);
  if (!typed) return;
  TextTable::Cell name = head;
  std::string unit = typed->unit;
  if (unit.empty() && !name.empty() && name.back().kind == TextSpan::Kind::text)
    unit = take_unit_at_end(name.back().text);
  const auto scaled = scaled_unit(unit);
  const bool is_letter_t = name.size() == 1 && name.front().text == "t";
  const std::string words = name.size() == 1 ? std::string(without_blanks(name.front().text)) : "";
  if (!scaled || scaled->dimension != kTime || !(is_letter_t || words == "time" || words == "at")) return;
  const double at = of_row.row->scene.at_s / scaled->size;
  if (std::abs(at - typed->value) > 0.5 * typed->last_digit * (1 + 1e-9))
    report_.error(of_row.row->place,
                  "this row is of the time " + digits(typed->value, kDigitsOfHint) + ' ' + unit +
                      " by its head, and its numbers are of " + digits(at, kDigitsOfHint) + ' ' + unit,
                  "give the row its time: at = …");
}

/// What the heads of computed rows say of their motions: "$\omega_3 = 5$ rad/s", at its time or as it began.
void NumberCheck::check_row_heads(const TextTable& table) {
  for (std::size_t r = 1; r < table.rows.size(); ++r) {
    const ComputedNumber* of_row = nullptr;
    for (const TextTable::Cell& cell : table.rows[r])
      for (const TextSpan& span : cell)
        if (span.math.live.size() == 1 && number(span.math, 0).row) of_row = &number(span.math, 0);
    if (of_row == nullptr) continue;
    check_time_of_row(table.rows.front().front(), table.rows[r].front(), *of_row);
    for (const TextTable::Cell& cell : table.rows[r])
      for (std::size_t i = 0; i < cell.size(); ++i) {
        if (cell[i].kind != TextSpan::Kind::math || !cell[i].math.live.empty()) continue;
        for (TypedStatement& statement : typed_statements(cell[i].math, notation_)) {
          if (statement.number.unit.empty() && i + 1 < cell.size())
            statement.number.unit = unit_behind(cell[i + 1].text);
          const Scene& scene = of_row->row->scene;
          const std::vector<double> times_s =
              statement.of ? std::vector{scene.at_s, 0.0} : std::vector{scene.at_s};
          const auto wrong = wrong_value(statement, make_model(scene, ModelFor::numbers, effort_), times_s);
          if (wrong)
            report_.error(of_row->row->place,
                          "the head of this row says $" + cell[i].text + "$, and on its motion that is " +
                              digits(*wrong, kDigitsOfHint),
                          "write what the row's motion is");
        }
        check_row_statements(cell[i].math, *of_row);
        const auto is = read_side(cell[i].math, notation_);
        const bool is_quantity = is && is->nodes.size() == 1 && is->nodes[0].operation == Operation::quantity;
        const auto dimension = is_quantity ? dimension_of(*is, {}).dimension : std::nullopt;
        if (cell.size() == 1 && dimension && !can_have({*dimension}, of_row->dimension))
          refuse(*of_row,
                 "the head of a row says " + in_quotes(cell[i].text) + ", and its number is " +
                     to_string(*of_row->dimension),
                 "write what the row's motion is");
      }
  }
}

void NumberCheck::check_computed_tables(const RichText& text) {
  for (const TextBlock& block : text) {
    if (!block.is_table()) continue;
    check_row_heads(block.table);
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
                           Prover().settle(sides, LawsAssumed::identity) == Verdict::holds;
      std::vector<SceneModel> models;
      std::vector<MotionNumbers> motions;
      std::vector<MotionNumbers*> of_rows;
      if (!is_same) {
        models.reserve(numbers.size());
        motions.reserve(numbers.size());
        for (const ComputedNumber* one : numbers) {
          models.push_back(make_model(one->row->scene, ModelFor::numbers, effort_));
          motions.emplace_back(models.back(), one->row->scene.at_s, effort_);
          of_rows.push_back(&motions.back());
        }
      }
      check_head(head, *numbers.front(), of_rows);
    }
  }
}

}  // namespace polhode
