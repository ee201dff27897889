// SPDX-License-Identifier: MIT
// Whether what a lesson prints around its computed numbers is so: the other sides of a formula, units behind
// a number, signs and words that would make it another, heads of tables.
#pragma once

#include "lessons/diagnostics/report.h"
#include "lessons/notation/tex_numbers.h"
#include "lessons/notation/tex_statements.h"
#include "lessons/reader/lesson.h"

#include <optional>
#include <string>
#include <vector>

namespace polhode {

/// The motion that numbers are of.
struct NumbersMotion {
  const SceneModel& model;
  MotionNumbers& still;  ///< at the time still_s
  double still_s = 0;
};

/// As = or ≈ says. What is proved differs only where a method errs: then the number is not what it should
/// be.
bool agree(const LiveValue& value, Relation relation, bool is_proved);

class NumberCheck {
 public:
  /// All must outlive it.
  NumberCheck(const Lesson& lesson, Report& report, const Effort& effort);

  /// "T = 3.8 J" has to be so on the motion, whether or not the formula is called anything; `above` is the
  /// formula that it may go on from. Of a formula that is proved only this is left to say: to an order it may
  /// be proved and far off.
  void check_formula(const Math& math, const Math* above, const NumbersMotion& motion, bool is_proved);
  /// Its formulas, what stands beside them, and heads of tables.
  void check_text(const RichText& text, const NumbersMotion& motion);
  /// Heads of columns that are computed, each for a motion of its own.
  void check_computed_tables(const RichText& text);
  /// Numbers of a caption that stands once below the pictures of these motions.
  void check_shared(const std::vector<int>& ids, const std::vector<const SceneModel*>& models);
  /// What an author typed into a caption, "$\omega_3 = 5$ rad/s", is so at the still, or as
  /// the motion began.
  void check_typed(const RichText& text, const SceneModel& model, double still_s, SourcePlace place);
  /// Whether it has such numbers.
  bool has_typed_numbers(const RichText& text) const;

 private:
  struct Head;
  static constexpr int kDigitsOfHint = 6;
  const ComputedNumber& number(const Math& math, std::size_t index) const;
  void check_apart(const Math& math, const Math* above, const NumbersMotion& motion);
  void check_components(const Math& math, const ComponentsStatement& statement, const NumbersMotion& motion);
  /// `said`: the words that say the left side; empty: it is printed as a formula.
  bool check_statement(const Math& math, const NumberStatement& statement, const NumbersMotion& motion,
                       const std::string& said = {});
  void check_unit(const ComputedNumber& number, const std::string& unit);
  void check_spans(const std::vector<TextSpan>& spans, const NumbersMotion& motion);
  void check_before(const std::vector<TextSpan>& spans, std::size_t at, std::size_t index,
                    const NumbersMotion& motion);
  void check_said(const Math& said, Relation relation, const Math& math, std::size_t index,
                  const NumbersMotion& motion);
  void check_behind(const std::vector<TextSpan>& spans, std::size_t at, const ComputedNumber& number,
                    bool has_unit);
  // Of tables: number_check_tables.cpp.
  void check_table(const TextTable& table, const NumbersMotion& motion);
  void check_unit_beside(const TextTable::Cell& cell, const ComputedNumber& number);
  void check_axis_of_row(const TextTable::Cell& head, const TextTable::Cell& cell,
                         const ComputedNumber& number);
  void check_row_heads(const TextTable& table);
  void check_row_statements(const Math& math, const ComputedNumber& of_row);
  void check_time_of_row(const TextTable::Cell& head, const TextTable::Cell& cell,
                         const ComputedNumber& of_row);
  Head head_of(const TextTable::Cell& cell) const;
  void check_head(const Head& head, const ComputedNumber& number, const std::vector<MotionNumbers*>& motions);
  void refuse(const ComputedNumber& number, const std::string& message, const std::string& hint = "");

  const Lesson& lesson_;
  Report& report_;
  const Effort& effort_;
  EquationNotation notation_;  ///< with the words of motions as a whole
};

/// What a typed statement's number should be, in its unit, where it is off by more than half a unit of its
/// last digit at each of these times; nothing where it is right, or cannot be told.
std::optional<double> wrong_value(const TypedStatement& statement, const SceneModel& model,
                                  const std::vector<double>& times_s);

}  // namespace polhode
