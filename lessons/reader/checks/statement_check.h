// SPDX-License-Identifier: MIT
// Whether what formulas state in passing is so: in lines of prose, answers and displays of which nothing is
// called proved.
#pragma once

#include "lessons/claims/proof/proof.h"
#include "lessons/diagnostics/report.h"
#include "lessons/notation/tex_statements.h"
#include "lessons/reader/checks/known_numbers.h"
#include "lessons/reader/lesson.h"

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

class StatementCheck {
 public:
  using Motions = std::function<std::vector<ShownMotion>()>;

  /// All must outlive it.
  StatementCheck(const Lesson& lesson, Report& report, const Effort& effort);

  /// What is claimed in it, false or not, may be spoken of.
  void begin_stage(const Stage& stage);
  /// An error for each statement that can be read and is not so: neither in general, of the free body, of the
  /// motion of the step or under an assumption of the lesson, nor claimed in the stage. What a sentence
  /// supposes, asks or denies is not stated. `motions` is asked at most once, where it matters.
  void check_text(const RichText& text, const Motions& motions);
  /// The same of its numbers with units, outside of such statements: each is one that the lesson or its
  /// motion has (known_numbers.h).
  void check_typed_numbers(const RichText& text, const Motions& motions);
  /// The statements of a display; `before` is the text that leads to it.
  void check_display(const Equation& equation, const RichText* before, const Motions& motions);

 private:
  void check(const StatedLink& link, const std::string& unit_behind, const std::string& tex,
             std::size_t offset, const Motions& motions);
  void check_units(const Statements& stated, std::size_t offset);
  bool holds_in_general(const Equality& equality, Relation relation) const;
  bool is_claimed(const Equality& equality) const;
  std::string why_not(const StatedLink& link, const std::vector<ShownMotion>& motions) const;

  const Lesson& lesson_;
  Report& report_;
  const Effort& effort_;
  Prover prover_;
  std::vector<const ClaimLine*> claimed_;
};

}  // namespace polhode
