// SPDX-License-Identifier: MIT
#include "lessons/reader/checks/statement_check.h"

#include "base/numbers.h"
#include "lessons/claims/expressions/dimension.h"
#include "lessons/claims/live_claims.h"
#include "lessons/reader/checks/clause.h"
#include "lessons/reader/checks/lint_budget.h"
#include "lessons/reader/checks/quantity_words.h"
#include "lessons/reader/checks/typed_numbers.h"
#include "lessons/reader/text_units.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

namespace polhode {
namespace {

constexpr int kDigitsOfHint = 6;

/// Rows of a computed table are of motions of their own (number_check_tables.cpp).
bool has_own_motions(const TextTable& table, const Lesson& lesson) {
  for (const auto& row : table.rows)
    for (const TextTable::Cell& cell : row)
      for (const TextSpan& span : cell)
        for (const LiveNumber& number : span.math.live)
          if (lesson.numbers[static_cast<std::size_t>(number.id)].row) return true;
  return false;
}

template <class Do>
void for_each_line(const RichText& text, const Lesson& lesson, const Do& act) {
  for (const TextBlock& block : text) {
    act(block.spans);
    if (has_own_motions(block.table, lesson)) continue;
    for (const auto& row : block.table.rows)
      for (const TextTable::Cell& cell : row) act(cell);
  }
}

std::string in_small_letters(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// Whether words name an assumption of the lesson: "symmetric" in "of a symmetric body", "near-two" in "near
/// two".
bool is_named(const std::string& assumption, std::string_view words) {
  std::string name = in_small_letters(assumption);
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '-' || c == '_'; }, ' ');
  for (std::size_t at = 0; (at = words.find(name, at)) != words.npos; ++at) {
    const std::size_t end = at + name.size();
    const bool begins = at == 0 || !is_letter(words[at - 1]),
               ends = end == words.size() || !is_letter(words[end]);
    if (begins && ends) return true;
  }
  return false;
}

/// A number has the unit that stands behind its formula.
void take_unit(StatedSide& side, const std::string& unit) {
  if (unit.empty()) return;
  side.typed->unit = unit;
  const auto scaled = scaled_unit(unit);
  const SourceText source("");
  Report unused(source, "");
  auto is =
      read_expression(digits(side.typed->value * (scaled ? scaled->size : 1), 15), {1, 1}, unused, nullptr);
  if (is) side.is = std::move(is);
}

/// The largest part of a typed number that is taken to be rounded off: of two digits half the last.
constexpr double kRoundedOff = 0.03;

bool compares(double l, double r, Relation relation, double allowed) {
  switch (relation) {
    case Relation::less:
      return l < r;
    case Relation::greater:
      return l > r;
    case Relation::less_or_equal:
      return l <= r + allowed;
    case Relation::greater_or_equal:
      return l >= r - allowed;
    case Relation::approximate:
      return std::abs(l - r) <= kSmallOnMotion * std::max(std::abs(l), std::abs(r)) + allowed;
    case Relation::equal:
      return std::abs(l - r) <= allowed;
  }
  return true;
}

}  // namespace

StatementCheck::StatementCheck(const Lesson& lesson, Report& report, const Effort& effort)
    : lesson_(lesson), report_(report), effort_(effort) {}

void StatementCheck::begin_stage(const Stage& stage) {
  claimed_.clear();
  headline_ = in_small_letters(stage.title);
  for (const Step& step : stage.steps)
    for (const Claim* claim : blocks_of<Claim>(step))
      for (const ClaimLine& line : claim->lines) claimed_.push_back(&line);
}

void StatementCheck::check_text(const RichText& text, const Motions& motions) {
  check_lines(text, motions, false);
}
void StatementCheck::check_choice(const RichText& text, const Motions& motions) {
  check_lines(text, motions, true);
}

void StatementCheck::check_lines(const RichText& text, const Motions& motions, bool is_choice) {
  for_each_line(text, lesson_, [&](const std::vector<TextSpan>& spans) {
    const auto is_formula = [](const TextSpan& span) { return span.kind == TextSpan::Kind::math; };
    if (std::none_of(spans.begin(), spans.end(), is_formula)) return;
    const Sentences sentences(spans, lesson_.notation);
    for (std::size_t i = 0; i < spans.size() && !report_.is_full(); ++i) {
      if (!is_formula(spans[i])) continue;
      const Standing standing = sentences.standing_of(i);
      const bool goes_on =
          i + 1 < spans.size() && spans[i + 1].kind == TextSpan::Kind::text && !spans[i].break_after;
      // "$\\vec\\omega = (0, 2, 0)$" chosen is a state.
      if (is_choice && spans.size() == 1 && !sentences.stated(i).components.empty()) continue;
      const Context context{standing, spans[i].text, spans[i].source.begin,
                            goes_on ? unit_behind(spans[i + 1].text) : ""};
      check(sentences.stated(i), context, motions);
      if (const auto said = said_of_formula(spans, i); said && standing.is_stated)
        check(*said, context, motions);
    }
  });
}

void StatementCheck::refuse_number(const TypedNumber& number, std::size_t offset, const std::string& why) {
  report_.error(report_.source().place_of(std::min(offset, report_.source().text().size())), why,
                "write \\value" + (number.unit.empty() ? "" : "[unit={" + number.unit + "}]") + '{' +
                    digits(number.value, 6) +
                    "}{EXPRESSION}; what is given of the world is a constant: [constants]");
}

void StatementCheck::check_typed_numbers(const RichText& text, const Motions& motions) {
  for_each_line(text, lesson_, [&](const std::vector<TextSpan>& line) {
    const std::vector<TextSpan> spans = with_numbers_apart(line);
    std::optional<Sentences> sentences;
    for (std::size_t i = 0; i < spans.size() && !report_.is_full(); ++i) {
      auto typed = spans[i].kind == TextSpan::Kind::math ? read_typed(spans[i].math) : std::nullopt;
      if (!typed) continue;
      const bool goes_on =
          i + 1 < spans.size() && spans[i + 1].kind == TextSpan::Kind::text && !spans[i].break_after;
      if (typed->unit.empty() && goes_on) typed->unit = unit_behind(spans[i + 1].text);
      // "The energy is 5 J": not that of anything else.
      std::vector<TextSpan> clause = clause_before(spans, i);
      const bool is_joined = take_verb(clause) && has_words(clause);
      const auto said = is_joined ? quantity_said_at_end(clause, lesson_) : std::nullopt;
      const bool is_right = said ? is_number_of(*typed, *said, motions(), effort_).value_or(true)
                                 : is_known_number(*typed, lesson_, motions(), effort_);
      if (is_right) continue;
      if (!sentences) sentences.emplace(spans, lesson_.notation);
      if (!sentences->standing_of(i).is_stated) continue;
      refuse_number(*typed, spans[i].source.begin,
                    said ? "this number is not that of " + said->text + ", which is said of it"
                         : "nobody computes this number with its unit, " + in_quotes(typed->unit));
    }
  });
  for (const TextBlock& block : text)
    if (!has_own_motions(block.table, lesson_)) check_rows(block.table, motions);
}

/// "| energy | 5 J |": a row of one number, and what it is in the first cell.
void StatementCheck::check_rows(const TextTable& table, const Motions& motions) {
  for (std::size_t r = 1; r < table.rows.size() && !report_.is_full(); ++r) {
    const auto& row = table.rows[r];
    const auto said = quantity_said(row.front(), lesson_);
    if (!said || said->type() == ExpressionType::vector) continue;
    std::vector<std::pair<TypedNumber, std::size_t>> numbers;
    for (std::size_t c = 1; c < row.size(); ++c)
      if (auto number = number_in_cell(row[c])) numbers.emplace_back(*number, row[c].front().source.begin);
    if (numbers.size() != 1 || is_number_of(numbers[0].first, *said, motions(), effort_).value_or(true))
      continue;
    refuse_number(numbers[0].first, numbers[0].second, "this number is not that of its row, " + said->text);
  }
}

/// No claim beside a formula makes right what adds metres to seconds.
void StatementCheck::check_units(const Statements& stated, std::size_t offset) {
  const auto refuse = [&](SourceSpan at, const std::string& why) {
    report_.error(report_.source().place_of(std::min(offset + at.begin, report_.source().text().size())),
                  "units disagree: " + why, "a claim beside a formula does not mend it");
  };
  for (const auto& [side, at] : stated.sides)
    if (const auto fault = dimension_of(side, {}).fault) return refuse(at, fault->message);
  for (const StatedLink& link : stated.links) {
    if (!link.left.is || !link.right.is || link.left.typed || link.right.typed) continue;
    const auto left = dimension_of(*link.left.is, {}).dimension,
               right = dimension_of(*link.right.is, {}).dimension;
    if (left && right && *left != *right)
      return refuse(link.source,
                    "the left side is " + to_string(*left) + ", the right side " + to_string(*right));
  }
}

/// "The energy is $2T$": what the words say that a formula is.
std::optional<StatedLink> StatementCheck::said_of_formula(const std::vector<TextSpan>& line,
                                                          std::size_t at) const {
  if (read_typed(line[at].math)) return std::nullopt;  // check_typed_numbers
  const auto is = read_side(line[at].math, lesson_.notation);
  if (!is) return std::nullopt;
  // "is $I_1$ times the rate"
  const bool goes_on = at + 1 < line.size() && !line[at].break_after &&
                       (line[at + 1].kind == TextSpan::Kind::math ||
                        !starts_with_any(line[at + 1].text, {".", ",", ";", ":", "!", ")"}));
  if (goes_on) return std::nullopt;
  std::vector<TextSpan> clause = clause_before(line, at);
  const auto relation = take_verb(clause);
  if (!relation || !has_words(clause)) return std::nullopt;
  const bool is_vector = is->type() == ExpressionType::vector;
  const auto said =
      quantity_said_at_end(clause, lesson_, is_vector ? VectorsSaid::as_vectors : VectorsSaid::as_lengths);
  if (!said) return std::nullopt;
  StatedLink link;
  link.left.is = said;
  link.right.is = is;
  link.relation = *relation;
  link.source = {0, static_cast<std::uint32_t>(line[at].text.size())};
  return link;
}

void StatementCheck::check_display(const Equation& equation, const RichText* before, const Motions& motions) {
  // "If they are equal, all three vanish:"
  std::vector<TextSpan> spans;
  if (before != nullptr && !before->empty()) spans = before->back().spans;
  TextSpan& own = spans.emplace_back();
  own.kind = TextSpan::Kind::math;
  own.text = equation.tex;
  own.math = equation.math;
  const Sentences sentences(spans, lesson_.notation);
  const Statements& stated = sentences.stated(spans.size() - 1);
  check_units(stated, equation.offset);
  check(stated, {sentences.standing_of(spans.size() - 1), equation.tex, equation.offset}, motions);
}

bool StatementCheck::is_claimed(const Equality& equality) const {
  const auto is_same = [&](const Equality& other) {
    return (other.left.text == equality.left.text && other.right.text == equality.right.text) ||
           (other.left.text == equality.right.text && other.right.text == equality.left.text);
  };
  return std::any_of(claimed_.begin(), claimed_.end(), [&](const ClaimLine* line) {
    return is_same(line->equality) || (line->conclusion && is_same(*line->conclusion));
  });
}

bool StatementCheck::holds_in_general(const StatedLink& link, const Standing& standing,
                                      const Motions& motions) const {
  const Equality equality{*link.left.is, *link.right.is};
  if (!is_provable(equality)) return false;
  spend(effort_, 4 * kClaimLineEvaluations);
  const auto holds = [&](Assumption assumption, const Given& given) {
    if (!is_order(link.relation)) return prover_.settle(equality, assumption, given) == Verdict::holds;
    ClaimLine line;
    line.equality = equality;
    line.relation = link.relation;
    const Verdict verdict = prover_.settle_order(line, assumption, given).verdict;
    return verdict == Verdict::holds || verdict == Verdict::not_refuted;
  };
  if (holds(Assumption::identity, {}) || holds(Assumption::motion, {})) return true;
  if (holds(Assumption::free, {}) && may_be_free(standing, motions())) return true;
  return std::any_of(lesson_.assumptions.begin(), lesson_.assumptions.end(), [&](const auto& one) {
    return (is_named(one.first, standing.words) || is_named(one.first, headline_)) &&
           holds(Assumption::motion, one.second);
  });
}

/// What holds without torque is not said where one acts, unless it is said of another motion.
bool StatementCheck::may_be_free(const Standing& standing, const std::vector<ShownMotion>& motions) const {
  const auto is_free = [](const ShownMotion& motion) { return motion.model.scene.torque.empty(); };
  return motions.empty() || std::any_of(motions.begin(), motions.end(), is_free) ||
         is_named("torque", standing.words) || is_named("free", standing.words) ||
         is_named("free", headline_) || is_named("torque", headline_);
}

std::string StatementCheck::why_not(const StatedLink& link, const LiveState& live) const {
  ClaimLine line;
  line.equality = {*link.left.is, *link.right.is};
  const auto value = live_value(line, live, View::space);
  if (!value) return "";
  const auto half_digit = [&](const StatedSide& side) {
    if (!side.typed) return 0.0;
    const auto unit = scaled_unit(side.typed->unit);
    const double half = 0.5 * side.typed->last_digit * (1 + 1e-9);
    // Of "= 3" nobody thinks that it is rounded, still less of "= 0".
    const double least = link.relation == Relation::approximate
                             ? half
                             : std::min(half, kRoundedOff * std::abs(side.typed->value));
    return least * (unit ? unit->size : 1);
  };
  const double typed = half_digit(link.left) + half_digit(link.right);
  constexpr double kRounding = 1e-9;
  const bool are_so = link.relation == Relation::equal && typed == 0
                          ? value->residual <= std::max(value->tolerance, kRounding)
                          : compares(value->left[0], value->right[0], link.relation,
                                     typed + kRounding * std::abs(value->left[0]));
  if (are_so != link.is_denied) return "";
  if (link.is_denied) return "both sides are equal";
  if (link.is_of_all_times) return "its rate is not 0";
  if (value->is_vector) return "its sides are not equal";
  return "its sides are " + digits(value->left[0], kDigitsOfHint) + " and " +
         digits(value->right[0], kDigitsOfHint);
}

std::string StatementCheck::why_not(const std::vector<StatedLink>& links, const Standing& standing,
                                    const std::vector<ShownMotion>& motions) const {
  // What does not change, and what is nowhere so, is told at several times of the motion.
  const auto is_of_all = [](const StatedLink& link) { return link.is_of_all_times; };
  const bool is_of_all_times = std::any_of(links.begin(), links.end(), is_of_all);
  std::string first;
  for (const ShownMotion& motion : motions) {
    std::vector<double> times_s{motion.still_s, 0.0};
    if (standing.at_s) times_s = {*standing.at_s};
    if (is_of_all_times) times_s = {motion.still_s, 0.37 * motion.model.span_s, 0.81 * motion.model.span_s};
    std::string of_motion;
    bool is_so = is_of_all_times;
    for (const double t_s : times_s) {
      const auto live = live_state(motion.model, t_s);
      if (!live) continue;
      std::string why;
      for (const StatedLink& link : links)
        if (why.empty()) why = why_not(link, *live);
      if (why.empty() && !is_of_all_times) return "";
      if (why.empty()) continue;
      is_so = false;
      if (of_motion.empty()) of_motion = "at t = " + digits(t_s, 3) + " s " + why;
    }
    if (is_so) return "";
    if (first.empty()) first = of_motion;
  }
  return first;
}

void StatementCheck::refuse(const StatedLink& link, const Context& context, const std::string& why,
                            const std::string& hint) {
  report_.error(
      report_.source().place_of(std::min(context.offset + link.source.begin, report_.source().text().size())),
      "this is stated and not so: " + why, hint);
}

void StatementCheck::refuse_on_motion(const StatedLink& link, const Context& context, const Motions& motions,
                                      const std::string& why) {
  if (!why.empty() || (!lesson_.stages.empty() && motions().empty()))
    refuse(link, context, why.empty() ? "it does not follow from anything (" + context.tex + ")" : why,
           "say for what it is so, or prove it in a ```math fence");
}

void StatementCheck::check(const Statements& stated, const Context& context, const Motions& motions) {
  if (stated.is_condition || !context.standing.is_stated) return;
  for (const StatedLink& link : stated.links) check(link, context, motions);
  for (const StatedComponents& components : stated.components) check(components, context, motions);
}

void StatementCheck::check(const StatedComponents& components, const Context& context,
                           const Motions& motions) {
  std::vector<std::vector<StatedLink>> readings{components.on_body, components.on_space};
  for (std::vector<StatedLink>& links : readings) {
    for (StatedLink& link : links)
      if (link.right.typed && link.right.typed->unit.empty()) take_unit(link.right, context.unit_behind);
    const auto holds = [&](const StatedLink& link) {
      return holds_in_general(link, context.standing, motions);
    };
    if (std::all_of(links.begin(), links.end(), holds)) return;
  }
  const std::string on_body = why_not(readings[0], context.standing, motions());
  if (!on_body.empty() && why_not(readings[1], context.standing, motions()).empty()) return;
  refuse_on_motion(components.on_body.front(), context, motions,
                   on_body.empty() ? "" : "on the axes of the body " + on_body);
}

/// "A rod has $I_2 = I_3$": what is said of the moments of a kind of body is not said of the one that is
/// shown.
bool StatementCheck::is_of_a_kind_of_body(const StatedLink& link, const Standing& standing) {
  const auto is_of_moments = [](const Expression& side) {
    return std::all_of(side.nodes.begin(), side.nodes.end(), [](const ExpressionNode& node) {
      return node.operation != Operation::quantity || node.quantity == Quantity::I1 ||
             node.quantity == Quantity::I2 || node.quantity == Quantity::I3;
    });
  };
  return standing.has_kind_of_body && is_of_moments(*link.left.is) && is_of_moments(*link.right.is);
}

void StatementCheck::check(const StatedLink& link, const Context& context, const Motions& motions) {
  if (!link.left.is || !link.right.is) return;
  StatedLink stated = link;
  if (stated.right.typed && link.ends_formula && stated.right.typed->unit.empty() &&
      !context.unit_behind.empty())
    take_unit(stated.right, context.unit_behind);
  const Equality sides{*stated.left.is, *stated.right.is};
  if (!fit(sides.left.type(), sides.right.type()))
    return refuse(link, context, "a vector and a number stand beside this sign", "a length is |\\vec a|");
  if (link.is_denied) {
    spend(effort_, kClaimLineEvaluations);
    if (is_provable(sides) && prover_.settle(sides, Assumption::free) == Verdict::holds)
      return refuse(link, context, "both sides are always equal", "write =");
  } else if (is_claimed(sides) || is_of_a_kind_of_body(link, context.standing) ||
             holds_in_general(stated, context.standing, motions)) {
    return;
  }
  refuse_on_motion(link, context, motions, why_not({stated}, context.standing, motions()));
}

}  // namespace polhode
