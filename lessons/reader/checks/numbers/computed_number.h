// SPDX-License-Identifier: MIT
// A number in the texts, formulas and tables of a lesson that the program computes.
#pragma once

#include "lessons/claims/live_claims.h"
#include "lessons/claims/motion_words.h"
#include "lessons/diagnostics/diagnostic.h"
#include "render/scene/description/scene.h"
#include "render/typeset/math/math.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace polhode {

/// What the numbers in a row of a ```table fence are of.
struct TableRow {
  Scene scene;  ///< its motion at the time at_s; of what pictures show of it nothing is kept
  SourcePlace place;
};

/// Of \live; of \value, which was typed and is to be what is computed; or of a cell of a ```table fence.
struct ComputedNumber {
  Expression expression;  ///< a scalar
  double unit_si = 1;     ///< of the unit in which it is shown
  LiveNumber written;
  SourcePlace place;                      ///< of the expression
  std::shared_ptr<const TableRow> row{};  ///< of a cell; null: it is a number of the step's motion
  std::optional<Dimension> dimension{};   ///< of the expression; nothing: it cannot be told

  bool is_typed() const { return !written.typed.empty(); }
};

/// What it is on a motion, in its unit; nothing where it has no value.
std::optional<double> value_of(const ComputedNumber& number, const LiveState& live);

/// A number of a motion at one time, in its unit; nothing where it has no value.
std::optional<double> value_of(const ComputedNumber& number, MotionNumbers& motion);

/// Of those of the numbers with these ids that stand in tables the values, where they have one; the motion of
/// each row is computed once.
/// @throws std::domain_error where a row cannot be (check_scene), and what `effort` throws
std::map<int, double> values_in_tables(const std::vector<ComputedNumber>& numbers,
                                       const std::vector<int>& ids, const Effort& effort = {});

/// What should have been typed: the value with as many digits behind the point and the same power of ten, or
/// with two digits where so few are far off. Nothing if what was typed is off by no more than half a unit of
/// its last digit, and by no more than 5 %. Precondition: it is typed.
std::optional<std::string> right_instead(const ComputedNumber& number, double value);

}  // namespace polhode
