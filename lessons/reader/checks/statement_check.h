// SPDX-License-Identifier: MIT
// Whether what formulas state in passing is so: in lines of prose, answers and displays of which nothing is
// called proved.
#pragma once

#include "lessons/claims/live_claims.h"
#include "lessons/claims/proof/proof.h"
#include "lessons/diagnostics/report.h"
#include "lessons/notation/tex_statements.h"
#include "lessons/reader/checks/numbers/known_numbers.h"
#include "lessons/reader/checks/prose/sentence.h"
#include "lessons/reader/lesson.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

/// When something is said to be so, by its words or, without such, by where it stands: a caption may say how
/// the motion begins.
SaidOf said_of(const Standing& standing, SaidOf when);

/// Of several motions side by side: what is said is so of one of them, or of each.
enum class SaidOfMotions { one, each };

class StatementCheck {
 public:
  using Motions = std::function<std::vector<ShownMotion>()>;

  /// All must outlive it.
  StatementCheck(const Lesson& lesson, Report& report, const Effort& effort);

  /// What is claimed in it, false or not, may be spoken of.
  void begin_stage(const Stage& stage);
  /// An error for each statement that can be read and is not so: neither in general, of the free body, of the
  /// motion of the step, nor under an assumption of the lesson that the sentence names; nor claimed in the
  /// stage. What a sentence supposes, asks or denies is not stated (sentence.h), and "at $t = 2$ s" it is
  /// stated of that time. `motions` is asked where it matters.
  void check_text(const RichText& text, const Motions& motions, SaidOf when = SaidOf::some_time,
                  SaidOfMotions of = SaidOfMotions::one);
  /// The same of a choice, which may name a state by its components.
  void check_choice(const RichText& text, const Motions& motions);
  /// The same of its numbers with units, outside of such statements: each is one that the lesson or its
  /// motion has (known_numbers.h), and where words say of what, "the energy is 5 J", it is that of it; in a
  /// row or a column of a table that is called something, one of its numbers at least.
  void check_typed_numbers(const RichText& text, const Motions& motions, SaidOf when = SaidOf::some_time,
                           SaidOfMotions of = SaidOfMotions::one);
  /// Numbers that are computed are of one of the motions, `own`: not of another that the clause names.
  void check_whose(const RichText& text, const std::vector<ShownMotion>& motions, std::size_t own);
  /// The statements of a display; `before` is the text that leads to it.
  void check_display(const Equation& equation, const RichText* before, const Motions& motions);

 private:
  /// Where a statement stands, and what is told of it.
  struct Context {
    const Standing& standing;
    const std::string& tex;
    std::size_t offset = 0;  ///< of the TeX in the source
    std::string unit_behind = {};
    SaidOf when = SaidOf::some_time;
    bool is_of_each = false;  ///< of the motions
  };
  void check(const Statements& stated, const Context& context, const Motions& motions);
  void check(const StatedLink& link, const Context& context, const Motions& motions);
  void check(const StatedComponents& components, const Context& context, const Motions& motions);
  void check_table(const TextTable& table, const Motions& motions);
  void check_axes(const TextTable& table, std::size_t column, const Motions& motions);
  void refuse_number(const TypedNumber& number, std::size_t offset, const std::string& why);
  void check_scripts(const Math& math, std::size_t offset);
  void check_units(const Statements& stated, std::size_t offset);
  void refuse(const StatedLink& link, const Context& context, const std::string& why,
              const std::string& hint);
  void refuse_on_motion(const StatedLink& link, const Context& context, const Motions& motions,
                        const std::string& why);
  void check_lines(const RichText& text, const Motions& motions, bool is_choice, SaidOf when,
                   SaidOfMotions of);
  bool check_range(const std::vector<TextSpan>& spans, std::size_t at, const Motions& motions, SaidOf when);
  bool holds_in_general(const StatedLink& link, const Standing& standing, const Motions& motions) const;
  static bool is_of_a_kind_of_body(const StatedLink& link, const Standing& standing);
  bool may_be_free(const Standing& standing, const std::vector<ShownMotion>& motions) const;
  bool is_claimed(const Equality& equality) const;
  /// Empty where all of them are so at one time of one of the motions, or of each, or none can tell.
  std::string why_not(const std::vector<StatedLink>& links, const Context& context,
                      const std::vector<ShownMotion>& motions) const;
  std::string why_not(const std::vector<StatedLink>& links, const Context& context,
                      const ShownMotion& motion) const;
  /// Empty if it is so at this state.
  std::string why_not(const StatedLink& link, const LiveState& live) const;
  /// The same of what is said of times of its own, or of `t_s`.
  std::string why_not(const StatedLink& link, const ShownMotion& motion, double t_s) const;

  const Lesson& lesson_;
  Report& report_;
  const Effort& effort_;
  Prover prover_;
  std::vector<const ClaimLine*> claimed_;
  std::string headline_;  ///< of the stage, in small letters: it may name an assumption
};

}  // namespace polhode
