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

/// Words of a sentence that supposes, asks or denies what it says.
bool supposes(std::string_view sentence) {
  if (sentence.find('?') != sentence.npos) return true;
  constexpr std::array<std::string_view, 31> kWords{
      "if",    "for",     "where",  "when",     "whenever", "with",   "without", "let",
      "set",   "suppose", "assume", "assuming", "unless",   "until",  "once",    "would",
      "were",  "should",  "could",  "not",      "no",       "never",  "nor",     "neither",
      "false", "wrong",   "cannot", "whether",  "either",   "choose", "such"};
  for (std::size_t at = 0; at < sentence.size();) {
    std::size_t end = at;
    std::string word;
    while (end < sentence.size() && std::isalpha(static_cast<unsigned char>(sentence[end])))
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(sentence[end++])));
    if (std::find(kWords.begin(), kWords.end(), word) != kWords.end()) return true;
    at = end + 1;
  }
  return false;
}

/// "At $\\omega_2 = 0$", "the curve on which $T = …$"
bool is_behind_at(const TextSpan& before) {
  std::string_view text = without_blanks(before.text);
  if (before.kind != TextSpan::Kind::text) return false;
  if (ends_with_any(text, {" on which", " at which", " along which"})) return true;
  return ends_with_any(text, {"at", "At"}) && (text.size() == 2 || !is_letter(text[text.size() - 3]));
}

/// Where a sentence ends in a text, behind its sign; npos.
std::size_t end_of_sentence(std::string_view text) {
  for (std::size_t i = 0; i < text.size(); ++i)
    if (std::string_view(".?!;").find(text[i]) != std::string_view::npos &&
        (i + 1 == text.size() || text[i + 1] == ' ' || text[i + 1] == '\n'))
      return i + 1;
  return text.npos;
}
std::size_t last_end_of_sentence(std::string_view text) {
  std::size_t last = text.npos, begin = 0;
  for (std::size_t end = 0; (end = end_of_sentence(text.substr(begin))) != text.npos; begin += end)
    last = begin + end;
  return last;
}

/// The words of the sentence that a formula stands in.
std::string sentence_around(const std::vector<TextSpan>& spans, std::size_t at) {
  std::string words;
  for (std::size_t k = at; k > 0; --k) {
    if (spans[k - 1].kind != TextSpan::Kind::text) continue;
    const std::size_t end = last_end_of_sentence(spans[k - 1].text);
    words.insert(0, spans[k - 1].text.substr(end == std::string::npos ? 0 : end) + ' ');
    if (end != std::string::npos) break;
  }
  for (std::size_t k = at + 1; k < spans.size(); ++k) {
    if (spans[k].kind != TextSpan::Kind::text) continue;
    const std::size_t end = end_of_sentence(spans[k].text);
    words += ' ' + spans[k].text.substr(0, end);
    if (end != std::string::npos) break;
  }
  return words;
}

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
  for (const Step& step : stage.steps)
    for (const Claim* claim : blocks_of<Claim>(step))
      for (const ClaimLine& line : claim->lines) claimed_.push_back(&line);
}

void StatementCheck::check_text(const RichText& text, const Motions& motions) {
  const auto check_spans = [&](const std::vector<TextSpan>& spans) {
    for (std::size_t i = 0; i < spans.size() && !report_.is_full(); ++i) {
      if (spans[i].kind != TextSpan::Kind::math) continue;
      const Statements stated = stated_in(spans[i].math, lesson_.notation);
      const bool is_place = i > 0 && is_behind_at(spans[i - 1]);
      if (stated.links.empty() || stated.is_condition || is_place || supposes(stated.words) ||
          supposes(sentence_around(spans, i)))
        continue;
      const bool goes_on =
          i + 1 < spans.size() && spans[i + 1].kind == TextSpan::Kind::text && !spans[i].break_after;
      const std::string unit = goes_on ? unit_behind(spans[i + 1].text) : "";
      for (const StatedLink& link : stated.links)
        check(link, link.ends_formula ? unit : "", spans[i].text, spans[i].source.begin, motions);
    }
  };
  for_each_line(text, lesson_, check_spans);
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
  const Statements stated = stated_in(equation.math, lesson_.notation);
  check_units(stated, equation.offset);
  if (stated.is_condition || supposes(stated.words)) return;
  // "If they are equal, all three vanish:"
  if (before != nullptr && !before->empty()) {
    std::vector<TextSpan> spans = before->back().spans;
    const bool is_ended = !spans.empty() && spans.back().kind == TextSpan::Kind::text &&
                          spans.back().text.find_last_not_of(' ') != std::string::npos &&
                          spans.back().text[spans.back().text.find_last_not_of(' ')] == '.';
    spans.emplace_back();
    if (!is_ended && supposes(sentence_around(spans, spans.size() - 1))) return;
  }
  for (const StatedLink& link : stated.links) check(link, "", equation.tex, equation.offset, motions);
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

bool StatementCheck::holds_in_general(const Equality& equality, Relation relation) const {
  if (!is_provable(equality)) return false;
  spend(effort_, 4 * kClaimLineEvaluations);
  const auto holds = [&](Assumption assumption, const Given& given) {
    if (relation == Relation::equal || relation == Relation::approximate)
      return prover_.settle(equality, assumption, given) == Verdict::holds;
    ClaimLine line;
    line.equality = equality;
    line.relation = relation;
    const Verdict verdict = prover_.settle_order(line, assumption, given).verdict;
    return verdict == Verdict::holds || verdict == Verdict::not_refuted;
  };
  if (holds(Assumption::identity, {}) || holds(Assumption::motion, {}) || holds(Assumption::free, {}))
    return true;
  return std::any_of(lesson_.assumptions.begin(), lesson_.assumptions.end(),
                     [&](const auto& one) { return holds(Assumption::motion, one.second); });
}

/// Empty where it is so on one of the motions, or none can tell.
std::string StatementCheck::why_not(const StatedLink& link, const std::vector<ShownMotion>& motions) const {
  std::string why;
  for (const ShownMotion& motion : motions)
    for (const double t_s : {motion.still_s, 0.0}) {
      const auto live = live_state(motion.model, t_s);
      if (!live) continue;
      ClaimLine line;
      line.equality = {*link.left.is, *link.right.is};
      const auto value = live_value(line, *live, View::space);
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
      const bool holds = link.relation == Relation::equal && typed == 0
                             ? value->residual <= std::max(value->tolerance, kRounding)
                             : compares(value->left[0], value->right[0], link.relation,
                                        typed + kRounding * std::abs(value->left[0]));
      if (holds) return "";
      if (why.empty())
        why = "at t = " + digits(t_s, 3) + " s its sides are " + digits(value->left[0], kDigitsOfHint) +
              " and " + digits(value->right[0], kDigitsOfHint);
    }
  return why;
}

void StatementCheck::check(const StatedLink& link, const std::string& unit_behind, const std::string& tex,
                           std::size_t offset, const Motions& motions) {
  if (!link.left.is || !link.right.is) return;
  StatedLink stated = link;
  const SourcePlace place =
      report_.source().place_of(std::min(offset + link.source.begin, report_.source().text().size()));
  const auto refuse = [&](const std::string& why, const std::string& hint) {
    report_.error(place, "this is stated and not so: " + why, hint);
  };
  if (stated.right.typed && stated.right.typed->unit.empty() && !unit_behind.empty()) {
    stated.right.typed->unit = unit_behind;
    const auto unit = scaled_unit(unit_behind);
    const SourceText source("");
    Report unused(source, "");
    stated.right.is = read_expression(digits(stated.right.typed->value * (unit ? unit->size : 1), 15), {1, 1},
                                      unused, nullptr);
    if (!stated.right.is) return;
  }
  const Equality sides{*stated.left.is, *stated.right.is};
  if (!fit(sides.left.type(), sides.right.type()))
    return refuse("a vector and a number stand beside this sign", "a length is |\\vec a|");
  if (is_claimed(sides) || holds_in_general(sides, link.relation)) return;
  const std::string why = why_not(stated, motions());
  if (!why.empty() || (!lesson_.stages.empty() && motions().empty()))
    refuse(why.empty() ? "it does not follow from anything (" + tex + ")" : why,
           "say for what it is so, or prove it in a ```math fence");
}

}  // namespace polhode
