// SPDX-License-Identifier: MIT
#include "lessons/reader/checks/statement_check.h"

#include "base/numbers.h"
#include "lessons/claims/expressions/dimension.h"
#include "lessons/claims/live_claims.h"
#include "lessons/reader/checks/lint_budget.h"
#include "lessons/reader/checks/number_check.h"
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
      check(sentences.stated(i),
            {standing, spans[i].text, spans[i].source.begin, goes_on ? unit_behind(spans[i + 1].text) : ""},
            motions);
    }
  });
}

namespace {

struct FoundNumber {
  TypedNumber number;
  std::size_t offset = 0;  ///< in the span
};

/// "5 kJ", "27°" in plain text.
std::vector<FoundNumber> numbers_with_units(const std::string& text) {
  std::vector<FoundNumber> found;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (!is_digit(text[i])) continue;
    const std::size_t begin = i;
    std::size_t point = text.npos;
    while (i < text.size() && (is_digit(text[i]) || (text[i] == '.' && point == text.npos &&
                                                     i + 1 < text.size() && is_digit(text[i + 1])))) {
      if (text[i] == '.') point = i;
      ++i;
    }
    const bool is_part = begin > 0 && (is_letter(text[begin - 1]) || text[begin - 1] == '.' ||
                                       text[begin - 1] == '^' || text[begin - 1] == '_');
    const auto value = parse_number(text.substr(begin, i - begin));
    std::string unit = unit_behind(std::string_view(text).substr(i));
    if (is_part || !value || unit.empty()) continue;
    const double last = point == text.npos ? 1 : std::pow(10.0, -static_cast<double>(i - point - 1));
    found.push_back({{*value, last, std::move(unit)}, begin});
  }
  return found;
}

}  // namespace

void StatementCheck::check_typed_numbers(const RichText& text, const Motions& motions) {
  const auto check_number = [&](const TypedNumber& number, std::size_t offset) {
    if (is_known_number(number, lesson_, motions(), effort_)) return;
    report_.error(report_.source().place_of(std::min(offset, report_.source().text().size())),
                  "nobody computes this number with its unit, " + in_quotes(number.unit),
                  "write \\value[unit={" + number.unit + "}]{" + digits(number.value, 6) +
                      "}{EXPRESSION}; what is given of the world is a constant: [constants]");
  };
  for_each_line(text, lesson_, [&](const std::vector<TextSpan>& spans) {
    for (std::size_t i = 0; i < spans.size() && !report_.is_full(); ++i) {
      const TextSpan& span = spans[i];
      if (span.kind == TextSpan::Kind::text) {
        // A blank that no line breaks at is a stretch of its own.
        std::string words;
        std::vector<std::pair<std::size_t, std::size_t>> places;
        for (; i < spans.size() && spans[i].kind == TextSpan::Kind::text; ++i) {
          places.emplace_back(words.size(), spans[i].source.begin);
          words += spans[i].code ? std::string(spans[i].text.size(), '-') : spans[i].text;
          if (spans[i].break_after) words += '\n';
        }
        --i;
        for (const FoundNumber& one : numbers_with_units(words)) {
          const auto next = std::find_if(places.begin(), places.end(),
                                         [&](const auto& place) { return place.first > one.offset; });
          check_number(one.number, std::prev(next)->second + one.offset - std::prev(next)->first);
        }
      } else if (auto typed = read_typed(span.math)) {
        const bool goes_on =
            i + 1 < spans.size() && spans[i + 1].kind == TextSpan::Kind::text && !span.break_after;
        if (typed->unit.empty() && goes_on) typed->unit = unit_behind(spans[i + 1].text);
        check_number(*typed, span.source.begin);
      }
    }
  });
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
  } else if (is_claimed(sides) || holds_in_general(stated, context.standing, motions)) {
    return;
  }
  refuse_on_motion(link, context, motions, why_not({stated}, context.standing, motions()));
}

}  // namespace polhode
