// SPDX-License-Identifier: MIT
#include "lessons/reader/checks/statement_check.h"

#include "base/ascii.h"
#include "base/numbers.h"
#include "lessons/claims/answers/typed_unit.h"
#include "lessons/claims/expressions/dimension.h"
#include "lessons/claims/live_claims.h"
#include "lessons/reader/checks/formula_signs.h"
#include "lessons/reader/checks/lint_budget.h"
#include "lessons/reader/checks/numbers/typed_numbers.h"
#include "lessons/reader/checks/prose/clause.h"
#include "lessons/reader/checks/prose/quantity_words.h"
#include "lessons/reader/checks/prose/said_of_formula.h"
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

constexpr double kRounding = 1e-9;  // of what is computed

/// What the digits that are typed on both sides leave open, SI.
double rounded_off(const StatedLink& link) {
  const auto of = [&](const StatedSide& side) {
    if (!side.typed) return 0.0;
    const auto unit = scaled_unit(side.typed->unit);
    return rounded_off(*side.typed, link.relation) * (unit ? unit->size : 1);
  };
  return of(link.left) + of(link.right);
}

}  // namespace

StatementCheck::StatementCheck(const Lesson& lesson, Report& report, const Effort& effort)
    : lesson_(lesson), report_(report), effort_(effort) {}

void StatementCheck::begin_stage(const Stage& stage) {
  claimed_.clear();
  headline_ = in_small_letters(stage.title);
  for (const Step& step : stage.steps)
    for (const Claim* claim : blocks_of<Claim>(step))
      for (const ClaimLine& line : claim->lines)
        if (claim->kind != ClaimKind::is_false) claimed_.push_back(&line);
}

void StatementCheck::check_text(const RichText& text, const Motions& motions, SaidOf when, SaidOfMotions of) {
  check_lines(text, motions, false, when, of);
}
void StatementCheck::check_choice(const RichText& text, const Motions& motions) {
  check_lines(text, motions, true, SaidOf::some_time, SaidOfMotions::one);
}

namespace {

/// What the motions that stand side by side may be called: "the second body", "the coin" where the others
/// are none.
std::vector<CalledBy> names_of(const std::vector<ShownMotion>& motions) {
  constexpr std::array<const char*, 3> kOrdinals{"first", "second", "third"};
  constexpr std::array<const char*, 2> kSides{"left", "right"};
  std::vector<CalledBy> names(motions.size());
  for (std::size_t i = 0; i < motions.size(); ++i) {
    for (const char* noun : {"body", "scene", "picture", "figure", "motion", "top", "one"}) {
      if (i < kOrdinals.size()) names[i].push_back({kOrdinals[i], noun});
      if (i < kSides.size() && motions.size() == kSides.size()) names[i].push_back({kSides[i], noun});
    }
    const std::string& name = motions[i].model.scene.body.name;
    const auto has_name = [&](const ShownMotion& one) { return one.model.scene.body.name == name; };
    if (std::count_if(motions.begin(), motions.end(), has_name) > 1) continue;
    std::vector<std::string> words{"the"};
    for (std::size_t at = 0; at <= name.size();) {
      const std::size_t end = std::min(name.find_first_of("-_", at), name.size());
      words.push_back(in_small_letters(name.substr(at, end - at)));
      at = end + 1;
    }
    names[i].push_back(std::move(words));
  }
  return names;
}

/// Of several motions the one that the clause of a span names; all of them where it names none.
StatementCheck::Motions motions_meant(const Sentences& sentences, std::size_t span,
                                      const StatementCheck::Motions& motions) {
  return [&sentences, span, &motions] {
    const std::vector<ShownMotion> all = motions();
    const auto named = all.size() > 1 ? sentences.thing_named(span, names_of(all)) : std::nullopt;
    return named ? std::vector<ShownMotion>{all[*named]} : all;
  };
}

}  // namespace

SaidOf said_of(const Standing& standing, SaidOf when) {
  if (standing.at_s || standing.is_of_moment) return SaidOf::some_time;
  return standing.is_always ? SaidOf::all_times : when;
}

void StatementCheck::check_whose(const RichText& text, const std::vector<ShownMotion>& motions,
                                 std::size_t own) {
  if (motions.size() < 2 || own >= motions.size()) return;
  const std::vector<CalledBy> names = names_of(motions);
  for_each_line(text, lesson_, [&](const std::vector<TextSpan>& spans) {
    std::optional<Sentences> sentences;
    for (std::size_t i = 0; i < spans.size() && !report_.is_full(); ++i) {
      if (spans[i].math.live.empty()) continue;
      if (!sentences) sentences.emplace(spans, lesson_.notation);
      const auto named = sentences->thing_named(i, names);
      if (!named || *named == own) continue;
      for (const LiveNumber& live : spans[i].math.live) {
        const ComputedNumber& number = lesson_.numbers[static_cast<std::size_t>(live.id)];
        if (number.row) continue;
        const auto value_on = [&](const ShownMotion& motion) {
          MotionNumbers numbers(motion.model, motion.still_s, effort_);
          return value_of(number, numbers);
        };
        const auto here = value_on(motions[own]), there = value_on(motions[*named]);
        if (!here || !there || std::abs(*here - *there) <= kRounding * (std::abs(*here) + std::abs(*there)))
          continue;
        report_.error(number.place,
                      "this number is that of the step's own scene, " + digits(*here, kDigitsOfHint) +
                          ", and another one is named beside it, of which it is " +
                          digits(*there, kDigitsOfHint),
                      "write it into the caption of that scene, whose numbers are its own");
      }
    }
  });
}

void StatementCheck::check_lines(const RichText& text, const Motions& all_motions, bool is_choice,
                                 SaidOf when, SaidOfMotions of) {
  for_each_line(text, lesson_, [&](const std::vector<TextSpan>& spans) {
    const auto is_formula = [](const TextSpan& span) { return span.kind == TextSpan::Kind::math; };
    if (std::none_of(spans.begin(), spans.end(), is_formula)) return;
    const Sentences sentences(spans, lesson_.notation);
    for (std::size_t i = 0; i < spans.size() && !report_.is_full(); ++i) {
      if (!is_formula(spans[i])) continue;
      Standing standing = sentences.standing_of(i);
      const SaidOf said_when = said_of(standing, when);
      const Motions motions = motions_meant(sentences, i, all_motions);
      const bool goes_on =
          i + 1 < spans.size() && spans[i + 1].kind == TextSpan::Kind::text && !spans[i].break_after;
      check_scripts(spans[i].math, spans[i].source.begin);
      // "$\\vec\\omega = (0, 2, 0)$" chosen is a state.
      if (is_choice && spans.size() == 1 && !sentences.stated(i).components.empty()) continue;
      const Context context{standing,
                            spans[i].text,
                            spans[i].source.begin,
                            goes_on ? unit_behind(spans[i + 1].text) : "",
                            said_when,
                            of == SaidOfMotions::each || sentences.speaks_of_each(i)};
      check(sentences.stated(i), context, motions);
      if (!standing.is_stated) continue;
      for (const StatedLink& said : said_of_formula(spans, i, lesson_)) check(said, context, motions);
      if (const std::string why = why_not_called(spans, i, lesson_); !why.empty())
        report_.error(report_.source().place_of(std::min(context.offset, report_.source().text().size())),
                      why, "say what it is; where the words before it speak of something else, put a comma");
    }
  });
}

void StatementCheck::refuse_number(const TypedNumber& number, std::size_t offset, const std::string& why) {
  report_.error(report_.source().place_of(std::min(offset, report_.source().text().size())), why,
                "write \\value" + (number.unit.empty() ? "" : "[unit={" + number.unit + "}]") + '{' +
                    digits(number.value, 6) +
                    "}{EXPRESSION}; what is given of the world is a constant: [constants]");
}

namespace {

/// "5 J is", "5 kg m² is".
std::optional<Relation> take_verb_behind_unit(std::vector<TextSpan>& clause) {
  constexpr int kWordsOfUnit = 4;
  for (int words = 0; words <= kWordsOfUnit; ++words) {
    if (const auto relation = take_verb_at_start(clause)) return relation;
    if (clause.empty() || clause.front().kind != TextSpan::Kind::text) break;
    const std::string text(without_blanks(clause.front().text));
    const std::size_t end = text.find(' ');
    if (end == text.npos) break;
    clause.front().text = text.substr(end);
  }
  return std::nullopt;
}

/// Whether "1 rpm is" before a number says the same in another unit; nothing where no such thing stands
/// there.
std::optional<bool> is_of_other_unit(const std::vector<TextSpan>& spans, std::size_t at,
                                     const TypedNumber& typed) {
  std::vector<TextSpan> clause = clause_before(spans, at);
  const auto relation = take_verb(clause);
  if (!relation) return std::nullopt;
  std::string words;
  for (const TextSpan& span : clause) words += span.text;
  const std::string_view all = without_blanks(words);
  const std::size_t end = std::min(all.find(' '), all.size());
  const auto number = parse_number(all.substr(0, end));
  if (end == all.size() || typed.unit.empty()) return std::nullopt;
  const auto unit = typed_unit(without_blanks(all.substr(end))), other = typed_unit(typed.unit);
  if (!number || !unit || !other || unit->scaled.dimension != other->scaled.dimension) return std::nullopt;
  const double value = *number * unit->scaled.size / other->scaled.size;
  return std::abs(value - typed.value) <= rounded_off(typed, *relation);
}

/// What part of something a sentence speaks of: 0.5 of "half the spin"; 1 where it says none.
double part_said_in(const std::string& words) {
  constexpr std::array<std::pair<std::string_view, double>, 5> kParts{
      {{"half", 0.5}, {"twice", 2}, {"double", 2}, {"a third", 1 / 3.0}, {"a quarter", 0.25}}};
  const auto found = std::ranges::find_if(kParts, [&](const auto& one) {
    return (' ' + words + ' ').find(' ' + std::string(one.first) + ' ') != std::string::npos;
  });
  return found == kParts.end() ? 1 : found->second;
}

/// "Spin 200 rad/s" leaves open about which axis.
bool is_spin(const std::vector<TextSpan>& clause) {
  return clause.size() == 1 && in_small_letters(std::string(without_blanks(clause.front().text))) == "spin";
}
std::optional<bool> is_some_spin(const TypedNumber& number, const Lesson& lesson,
                                 const std::vector<ShownMotion>& motions, const Effort& effort, SaidOf when) {
  std::optional<bool> is_some;
  for (const char* name : {"spin about axis 1", "spin about axis 2", "spin about axis 3", "angular speed"}) {
    TextSpan words;
    words.text = name;
    const auto spin = quantity_said({words}, lesson);
    const auto is_this =
        spin ? is_number_of(number, *spin, motions, effort, Relation::equal, when) : std::nullopt;
    if (is_this) is_some = is_some.value_or(false) || *is_this;
  }
  return is_some;
}

}  // namespace

/// "The tilt stays between 20° and 30°": true where that is what is said of these two numbers; an error if it
/// is not so.
bool StatementCheck::check_range(const std::vector<TextSpan>& spans, std::size_t at, const Motions& motions,
                                 SaidOf when) {
  constexpr std::size_t kToOther = 2;
  const auto is_formula = [&](std::size_t i) {
    return i < spans.size() && spans[i].kind == TextSpan::Kind::math;
  };
  if (!is_formula(at) || is_formula(at + 1) || !is_formula(at + kToOther)) return false;
  auto low = read_typed(spans[at].math), high = read_typed(spans[at + kToOther].math);
  std::string_view between = without_blanks(spans[at + 1].text);
  if (!low || !high || !between.ends_with("and")) return false;
  between = without_blanks(between.substr(0, between.size() - std::string_view("and").size()));
  if (!between.empty() && whole_unit(between).empty()) return false;
  if (low->unit.empty()) low->unit = whole_unit(between);
  if (const std::size_t behind = at + kToOther + 1;
      high->unit.empty() && behind < spans.size() && !is_formula(behind))
    high->unit = unit_behind(spans[behind].text);
  std::vector<TextSpan> clause = clause_before(spans, at);
  const auto of_all_times = take_between(clause);
  const auto said = of_all_times ? quantity_said_at_end(clause, lesson_) : std::nullopt;
  if (!said) return false;
  const Sentences sentences(spans, lesson_.notation);
  const Standing standing = sentences.standing_of(at);
  if (!standing.is_stated) return true;
  when = *of_all_times && !standing.at_s ? SaidOf::all_times : said_of(standing, when);
  const auto is_so = is_between(*said, *low, *high, motions_meant(sentences, at, motions)(), effort_, when);
  if (!is_so.value_or(true))
    report_.error(report_.source().place_of(
                      std::min<std::size_t>(spans[at].source.begin, report_.source().text().size())),
                  "this is stated and not so: " + said->text + " is not " +
                      (when == SaidOf::all_times ? "always " : "") + "between these two numbers",
                  "say between which it is, or when");
  return true;
}

void StatementCheck::check_typed_numbers(const RichText& text, const Motions& all_motions, SaidOf when,
                                         SaidOfMotions of) {
  for_each_line(text, lesson_, [&](const std::vector<TextSpan>& line) {
    const std::vector<TextSpan> spans = with_numbers_apart(line);
    const Sentences sentences(spans, lesson_.notation);
    for (std::size_t i = 0; i < spans.size() && !report_.is_full(); ++i) {
      if (check_range(spans, i, all_motions, when)) {
        i += 2;  // the other number
        continue;
      }
      auto typed = spans[i].kind == TextSpan::Kind::math ? read_typed(spans[i].math) : std::nullopt;
      if (!typed) continue;
      const bool goes_on =
          i + 1 < spans.size() && spans[i + 1].kind == TextSpan::Kind::text && !spans[i].break_after;
      if (typed->unit.empty() && goes_on) typed->unit = unit_behind(spans[i + 1].text);
      // "The energy is 5 J": not that of anything else.
      std::vector<TextSpan> clause = clause_before(spans, i);
      auto relation = take_comparison(clause);
      if (!relation) relation = take_verb(clause);
      const bool has_subject =
          has_words(clause) || (!clause.empty() && clause.front().kind == TextSpan::Kind::math);
      const bool is_joined = relation && has_subject;
      auto said = is_joined ? quantity_said_at_end(clause, lesson_) : std::nullopt;
      // "Tilt 60°": a name and its number, as captions have them.
      const bool is_named_alone = !relation && !typed->unit.empty() && has_words(clause);
      if (is_named_alone && (said = quantity_said(clause, lesson_))) relation = Relation::equal;
      std::vector<TextSpan> behind = clause_behind(spans, i);
      if (!said && (relation = take_verb_behind_unit(behind))) said = quantity_said(behind, lesson_);
      const Motions motions = motions_meant(sentences, i, all_motions);
      const Standing standing = sentences.standing_of(i);
      const bool is_of_each = of == SaidOfMotions::each || sentences.speaks_of_each(i);
      const auto is_so_on = [&](const std::vector<ShownMotion>& some) {
        return is_number_of(*typed, *said, some, effort_, *relation, said_of(standing, when), standing.at_s);
      };
      const auto is_conversion = is_of_other_unit(spans, i, *typed);
      const auto is_so_of_said = [&]() -> std::optional<bool> {
        if (is_conversion) return is_conversion;
        if (is_named_alone && !said && is_spin(clause))
          return is_some_spin(*typed, lesson_, motions(), effort_, said_of(standing, when));
        if (!said) return std::nullopt;
        const std::vector<ShownMotion> all = motions();
        const auto is_so = is_so_on(all);
        if (!is_so || !is_of_each) return is_so;
        return std::all_of(all.begin(), all.end(),
                           [&](const ShownMotion& one) { return is_so_on({one}).value_or(true); });
      };
      const std::optional<bool> is_of_said = is_so_of_said();
      const auto is_known = [&](const TypedNumber& number) {
        const auto on = [&](const std::vector<ShownMotion>& some) {
          return is_known_number(number, lesson_, some, effort_, standing.at_s);
        };
        const std::vector<ShownMotion> all = motions();
        // "The middle one, at 42 rad/s" below three pictures is of one of them, however it is called.
        return sentences.speaks_of_each(i) && !all.empty()
                   ? std::all_of(all.begin(), all.end(), [&](const ShownMotion& one) { return on({one}); })
                   : on(all);
      };
      if (is_of_said ? *is_of_said : is_known(*typed)) continue;
      // "With half the spin, 100 rad/s": so much of what the motion has.
      const double part = part_said_in(standing.words);
      if (!is_of_said && part != 1 && is_known({typed->value / part, typed->last_digit / part, typed->unit}))
        continue;
      // "A coin of 5 g" is not the body that is shown.
      if (!standing.is_stated || (standing.has_kind_of_body && !is_of_said)) continue;
      refuse_number(*typed, spans[i].source.begin,
                    is_conversion ? "this number is not that of the other unit before it"
                    : is_of_said  ? "this number is not that of " + (said ? said->text : "the spin") +
                                       ", which is said of it"
                                 : "nobody computes this number with its unit, " + in_quotes(typed->unit));
    }
  });
  for (const TextBlock& block : text)
    if (!has_own_motions(block.table, lesson_)) check_table(block.table, all_motions);
}

namespace {

/// What a row or a column is called, without the unit behind that; nothing where it is called otherwise.
struct CellName {
  std::optional<Expression> is;
  std::string unit;
};
CellName name_in(TextTable::Cell cell, const Lesson& lesson) {
  CellName name;
  if (!cell.empty() && cell.back().kind == TextSpan::Kind::text)
    name.unit = take_unit_at_end(cell.back().text);
  name.is = quantity_said(cell, lesson);
  const auto is_measured = [](const ExpressionNode& node) { return node.operation == Operation::quantity; };
  const bool is_quantity = name.is && name.is->type() != ExpressionType::vector &&
                           std::any_of(name.is->nodes.begin(), name.is->nodes.end(), is_measured);
  if (!is_quantity) name.is.reset();
  return name;
}

struct CellNumber {
  TypedNumber number;
  std::size_t offset = 0;
};

}  // namespace

/// "moment" above the numbers of axes 1, 2 and 3.
void StatementCheck::check_axes(const TextTable& table, std::size_t column, const Motions& motions) {
  const auto text_of = [](const TextTable::Cell& cell) { return cell.size() == 1 ? cell.front().text : ""; };
  const std::string first = in_small_letters(text_of(table.rows.front().front()));
  if (column == 0 || (first != "axis" && first != "i")) return;
  std::string name = text_of(table.rows.front()[column]);
  const std::string unit = take_unit_at_end(name);
  for (std::size_t r = 1; r < table.rows.size() && !report_.is_full(); ++r) {
    TextSpan about;
    about.text = name + " about axis " + text_of(table.rows[r].front());
    const auto said = quantity_said({about}, lesson_);
    auto number = said ? number_in_cell(table.rows[r][column]) : std::nullopt;
    if (!number) continue;
    if (number->unit.empty()) number->unit = unit;
    if (!is_number_of(*number, *said, motions(), effort_).value_or(true))
      refuse_number(*number, table.rows[r][column].front().source.begin,
                    "this number is not that of its row, " + said->text);
  }
}

/// "| energy | 5 J |", or 5 below "energy (J)": what stands beside and below may be of other bodies, but not
/// all of it. A ratio without a unit may be anybody's.
void StatementCheck::check_table(const TextTable& table, const Motions& motions) {
  if (table.rows.empty()) return;
  std::vector<CellName> heads, rows;
  for (const TextTable::Cell& cell : table.rows.front()) heads.push_back(name_in(cell, lesson_));
  for (const auto& row : table.rows) rows.push_back(name_in(row.front(), lesson_));
  const auto number_at = [&](std::size_t r, std::size_t c) -> std::optional<CellNumber> {
    const TextTable::Cell& cell = table.rows[r][c];
    auto number = number_in_cell(cell);
    if (!number) return std::nullopt;
    if (number->unit.empty()) number->unit = heads[c].unit.empty() ? rows[r].unit : heads[c].unit;
    return CellNumber{*number, cell.front().source.begin};
  };
  const auto check_line = [&](const Expression& said, const std::vector<CellNumber>& numbers,
                              const char* of) {
    if (numbers.empty() || report_.is_full()) return;
    const bool is_some = std::any_of(numbers.begin(), numbers.end(), [&](const CellNumber& one) {
      return is_number_of(one.number, said, motions(), effort_).value_or(true);
    });
    if (!is_some)
      refuse_number(numbers.front().number, numbers.front().offset,
                    "this number is not that of its " + std::string(of) + ", " + said.text);
  };
  for (std::size_t r = 1; r < table.rows.size(); ++r) {
    if (!rows[r].is) continue;
    std::vector<CellNumber> numbers;
    for (std::size_t c = 1; c < table.rows[r].size(); ++c)
      if (const auto number = heads[c].is ? std::nullopt : number_at(r, c)) numbers.push_back(*number);
    check_line(*rows[r].is, numbers, "row");
  }
  for (std::size_t c = 0; c < heads.size(); ++c) {
    check_axes(table, c, motions);
    if (!heads[c].is) continue;
    const auto dimension = dimension_of(*heads[c].is, {}).dimension;
    std::vector<CellNumber> numbers;
    for (std::size_t r = 1; r < table.rows.size(); ++r)
      if (const auto number = rows[r].is ? std::nullopt : number_at(r, c))
        if (!number->number.unit.empty() || (dimension && *dimension != kNumber)) numbers.push_back(*number);
    check_line(*heads[c].is, numbers, "column");
  }
}

void StatementCheck::check_scripts(const Math& math, std::size_t offset) {
  if (math.root && has_empty_script(*math.root))
    report_.error(report_.source().place_of(std::min(offset, report_.source().text().size())),
                  "an index or a power in this formula is empty", "leave it out");
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
  check_scripts(equation.math, equation.offset);
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
  const auto holds = [&](LawsAssumed laws, const Given& given) {
    if (!is_order(link.relation)) return prover_.settle(equality, laws, given) == Verdict::holds;
    ClaimLine line;
    line.equality = equality;
    line.relation = link.relation;
    return prover_.settle_inequality(line, laws, given).verdict == Verdict::holds;
  };
  if (holds(LawsAssumed::identity, {}) || holds(LawsAssumed::motion, {})) return true;
  if (holds(LawsAssumed::free, {}) && may_be_free(standing, motions())) return true;
  return std::any_of(lesson_.assumptions.begin(), lesson_.assumptions.end(), [&](const auto& one) {
    return (is_named(one.first, standing.words) || is_named(one.first, headline_)) &&
           holds(LawsAssumed::motion, one.second);
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
  const double typed = rounded_off(link);
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

std::string StatementCheck::why_not(const StatedLink& link, const ShownMotion& motion, double t_s) const {
  const auto quantity = [&](const StatedSide& side) {
    const auto live = live_state(motion.model, side.at_s.value_or(t_s));
    return live ? live_quantity(*side.is, *live, View::space) : std::nullopt;
  };
  const auto left = quantity(link.left), right = quantity(link.right);
  if (!left || !right) return "";
  constexpr double kSaidInWords = 0.03;  // of "vanishes", "is constant"
  double in_words = 0;
  if (link.is_in_words)
    for (const double part : {0.0, 0.37, 0.81})
      if (const auto live = live_state(motion.model, part * motion.model.span_s))
        if (const auto then = live_quantity(*link.left.is, *live, View::space))
          for (const double x : then->components) in_words = std::max(in_words, kSaidInWords * std::abs(x));
  for (std::size_t i = 0; i < (left->is_vector ? left->components.size() : 1); ++i) {
    const double l = left->components[i], r = right->components[i];
    const double allowed = rounded_off(link) + in_words + kRounding * (std::abs(l) + std::abs(r));
    if (compares(l, r, link.relation, allowed) == link.is_denied)
      return "its sides are " + digits(l, kDigitsOfHint) + " and " + digits(r, kDigitsOfHint);
  }
  return "";
}

namespace {

/// Whether both sides of each are 0 at a time, beside what they are later. Of numbers that are typed, and of
/// what is said to be 0, that tells enough.
bool are_zero(const std::vector<StatedLink>& links, const SceneModel& model, double t_s, double later_s) {
  constexpr double kNothing = 1e-6;
  const auto now = live_state(model, t_s), later = live_state(model, later_s);
  if (!now || !later) return false;
  const auto size_of = [](const Expression& side, const LiveState& live) {
    double size = 0;
    if (const auto value = live_quantity(side, live, View::space))
      for (const double x : value->components) size = std::max(size, std::abs(x));
    return size;
  };
  return std::all_of(links.begin(), links.end(), [&](const StatedLink& link) {
    if (link.relation != Relation::equal || link.is_denied || link.is_in_words || link.is_of_a_time() ||
        link.left.typed || link.right.typed || link.left.is_time() || link.right.is_time() ||
        link.left.is->type() == ExpressionType::zero || link.right.is->type() == ExpressionType::zero)
      return false;
    const auto both = [&](const LiveState& live) {
      return std::max(size_of(*link.left.is, live), size_of(*link.right.is, live));
    };
    return both(*now) <= kNothing * both(*later);
  });
}

}  // namespace

std::string StatementCheck::why_not(const std::vector<StatedLink>& links, const Context& context,
                                    const std::vector<ShownMotion>& motions) const {
  std::string first;
  for (const ShownMotion& motion : motions) {
    std::string why = why_not(links, context, motion);
    if (why.empty() && !context.is_of_each) return "";
    if (first.empty()) first = std::move(why);
  }
  return first;
}

std::string StatementCheck::why_not(const std::vector<StatedLink>& links, const Context& context,
                                    const ShownMotion& motion) const {
  const Standing& standing = context.standing;
  // What does not change, and what is nowhere so, is told at several times of the motion.
  const auto is_of_all = [](const StatedLink& link) { return link.is_of_all_times; };
  const bool is_constant = std::any_of(links.begin(), links.end(), is_of_all),
             is_of_all_times = is_constant || context.when != SaidOf::some_time;
  std::vector<double> times_s =
      polhode::times_of(motion, is_of_all_times ? SaidOf::all_times : SaidOf::some_time);
  if (standing.at_s) times_s = {*standing.at_s};
  if (is_constant) times_s = {motion.still_s, 0.37 * motion.model.span_s, 0.81 * motion.model.span_s};
  std::string of_motion;
  bool is_so = is_of_all_times;
  const auto why_at = [&](double t_s) -> std::optional<std::string> {  // nothing: it cannot be told
    const auto live = live_state(motion.model, t_s);
    if (!live) return std::nullopt;
    std::string why;
    for (const StatedLink& link : links)
      if (why.empty())
        why = link.is_of_a_time() || link.is_in_words ? why_not(link, motion, t_s) : why_not(link, *live);
    return why;
  };
  // 0 = 0 tells nothing where the sides are apart at other times; but what is said of a moment is so then.
  const auto why_later = [&](double t_s) -> std::string {
    if (standing.at_s || standing.is_of_moment) return "";
    for (const double part : {0.37, 0.81}) {
      const double later_s = part * motion.model.span_s;
      if (const auto why = why_at(later_s);
          why && !why->empty() && are_zero(links, motion.model, t_s, later_s))
        return "at t = " + digits(later_s, 3) + " s " + *why;
    }
    return "";
  };
  if (context.when == SaidOf::start_or_all_times && !is_constant && why_at(0) == "" && why_later(0).empty())
    return "";
  for (const double t_s : times_s) {
    const auto why = why_at(t_s);
    if (!why) continue;
    if (why->empty() && !is_of_all_times) {
      const std::string later = why_later(t_s);
      if (later.empty()) return "";
      if (of_motion.empty()) of_motion = later;
      continue;
    }
    if (why->empty()) continue;
    is_so = false;
    if (of_motion.empty()) of_motion = "at t = " + digits(t_s, 3) + " s " + *why;
  }
  return is_so ? "" : of_motion;
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
      return !link.is_of_a_time() && holds_in_general(link, context.standing, motions);
    };
    if (std::all_of(links.begin(), links.end(), holds)) return;
  }
  const std::string on_body = why_not(readings[0], context, motions());
  if (!on_body.empty() && why_not(readings[1], context, motions()).empty()) return;
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
  if (stated.is_of_a_time()) {
    if (motions().empty()) return;
  } else if (link.is_denied) {
    spend(effort_, kClaimLineEvaluations);
    if (is_provable(sides) && prover_.settle(sides, LawsAssumed::free) == Verdict::holds)
      return refuse(link, context, "both sides are always equal", "write =");
  } else if (is_claimed(sides) || is_of_a_kind_of_body(link, context.standing) ||
             holds_in_general(stated, context.standing, motions)) {
    return;
  }
  refuse_on_motion(link, context, motions, why_not({stated}, context, motions()));
}

}  // namespace polhode
