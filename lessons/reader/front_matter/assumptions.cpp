// SPDX-License-Identifier: MIT
#include "lessons/reader/front_matter/assumptions.h"

#include "base/spelling.h"
#include "lessons/claims/expressions/expression_names.h"
#include "lessons/claims/expressions/expression_tex.h"
#include "lessons/claims/proof/whole_number_states.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <utility>

namespace polhode {
namespace {

/// Whether units are known and one of them is not the other; reports it.
bool have_same_units(const Expression& left, const Expression& right, SourcePlace place,
                     const std::map<int, Dimension>& dimensions, Report& report) {
  const DimensionReading a = dimension_of(left, dimensions), b = dimension_of(right, dimensions);
  for (const DimensionReading* side : {&a, &b})
    if (side->fault) {
      report.error(place, side->fault->message);
      return false;
    }
  const bool any = left.type() == ExpressionType::zero || right.type() == ExpressionType::zero;
  if (any || !a.dimension || !b.dimension || *a.dimension == *b.dimension) return true;
  report.error(place, "units disagree: the left side is in " + to_string(*a.dimension) +
                          ", the right side in " + to_string(*b.dimension));
  return false;
}

/// What numbers and constants of the lesson alone come to; nothing where another quantity is among them.
std::optional<double> value_of_constants(const Expression& expression) {
  std::vector<double> values;
  for (const ExpressionNode& node : expression.nodes) {
    const double a = node.a >= 0 ? values[static_cast<std::size_t>(node.a)] : 0,
                 b = node.b >= 0 ? values[static_cast<std::size_t>(node.b)] : 0;
    switch (node.operation) {
      case Operation::number:
      case Operation::constant:
        values.push_back(node.number.value);
        break;
      case Operation::negate:
        values.push_back(-a);
        break;
      case Operation::add:
        values.push_back(a + b);
        break;
      case Operation::subtract:
        values.push_back(a - b);
        break;
      case Operation::multiply:
        values.push_back(a * b);
        break;
      case Operation::divide:
        values.push_back(a / b);
        break;
      case Operation::power:
        values.push_back(std::pow(a, node.integer));
        break;
      default:
        return std::nullopt;
    }
  }
  return values.back();
}

bool is_so_of_constants(const Bound& bound) {
  const auto left = value_of_constants(bound.sides.left), right = value_of_constants(bound.sides.right);
  if (!left || !right) return true;
  switch (bound.relation) {
    case Relation::less:
      return *left < *right;
    case Relation::less_or_equal:
      return *left <= *right;
    case Relation::greater:
      return *left > *right;
    case Relation::greater_or_equal:
      return *left >= *right;
    default:
      return true;
  }
}

/// "I3 > I1", of which `at` is the sign; reports what it is not.
std::optional<Bound> read_bound(const std::string& text, std::size_t at, SourcePlace place,
                                const Vocabulary& vocabulary, const std::map<int, Dimension>& dimensions,
                                Report& report) {
  const bool or_equal = text.compare(at + 1, 1, "=") == 0;
  Bound bound;
  bound.text = text;
  bound.place = place;
  bound.relation = text[at] == '<' ? or_equal ? Relation::less_or_equal : Relation::less
                   : or_equal      ? Relation::greater_or_equal
                                   : Relation::greater;
  const auto side = [&](std::size_t begin, std::size_t end) {
    const std::string_view part = trimmed(std::string_view(text).substr(begin, end - begin));
    const auto offset = static_cast<std::size_t>(part.data() - text.data());
    return read_expression(part, advanced(place, text, offset), report, &vocabulary);
  };
  auto left = side(0, at), right = side(at + (or_equal ? 2 : 1), text.size());
  if (!left || !right) return std::nullopt;
  bound.sides = {std::move(*left), std::move(*right)};
  if (const auto fault = why_not_bound(bound)) {
    report.error(place, fault->message, fault->hint);
    return std::nullopt;
  }
  if (!have_same_units(bound.sides.left, bound.sides.right, place, dimensions, report)) return std::nullopt;
  if (!is_so_of_constants(bound)) {
    report.error(place, "this is not so of the constants as the lesson gives them",
                 "assume what their values are like");
    return std::nullopt;
  }
  bound.tex = tex_of(bound, &vocabulary);
  return bound;
}

/// "I2 = I1"; reports what it is not.
std::optional<Setting> read_setting(const std::string& text, SourcePlace place, const Vocabulary& vocabulary,
                                    const std::map<int, Dimension>& dimensions, Report& report) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) {
    report.error(place, "an assumption reads quantity = expression, there is no = here",
                 "for example I2 = I1, or I3 > I1");
    return std::nullopt;
  }
  const std::string_view name = trimmed(std::string_view(text).substr(0, equals));
  const QuantityFacts* facts = find_quantity(name);
  if (facts == nullptr) {
    report.error(place, "what is assumed is that a quantity is something: " + in_quotes(name) + " is none",
                 suggestion(name, {"I1", "I2", "I3", "w1", "w2", "w3", "N", "N1", "N2", "N3", "F"}));
    return std::nullopt;
  }
  const std::string_view right = trimmed(std::string_view(text).substr(equals + 1));
  const auto begin = static_cast<std::size_t>(right.data() - text.data());
  auto value = read_expression(right, advanced(place, text, begin), report, &vocabulary);
  if (!value) return std::nullopt;
  if (!fit(facts->type, value->type())) {
    report.error(place, in_quotes(name) + " is " + std::string(name_of(facts->type)) + ", and this is " +
                            std::string(name_of(value->type())));
    return std::nullopt;
  }
  const DimensionReading is = dimension_of(*value, dimensions);
  if (is.fault) {
    report.error(advanced(place, text, begin + is.fault->begin), is.fault->message);
    return std::nullopt;
  }
  const auto shall_be = facts->dimension;
  if (is.dimension && shall_be && *is.dimension != *shall_be) {
    report.error(place, "units disagree: " + in_quotes(name) + " is in " + to_string(*shall_be) +
                            ", this is in " + to_string(*is.dimension));
    return std::nullopt;
  }
  Setting setting{facts->quantity, std::move(*value), text, {}, place};
  setting.tex = tex_of(setting, &vocabulary);
  return setting;
}

const std::vector<std::string> kSmallNames{"w1", "w2", "w3", "N", "N1", "N2", "N3", "h", "k"};

void read_small_quantities(const TomlEntry& entry, SmallQuantities& small, Report& report) {
  const auto names = read_texts(entry, kSmallNames.size(), report);
  if (!names) return;
  if (names->empty())
    report.error(entry.value.place, "nothing is small here", "for example [\"w1\", \"w3\"]");
  for (const PlacedText& name : *names) {
    const QuantityFacts* facts = find_quantity(name.text);
    if (facts == nullptr || !can_be_small(facts->quantity)) {
      report.error(
          name.place,
          "what can be small is w1 w2 w3, N, N1 N2 N3, h or k: " + in_quotes(name.text) + " is none of them",
          suggestion(name.text, kSmallNames));
      continue;
    }
    const auto overlaps = [&](Quantity other) {
      SmallQuantities alone;
      alone.quantities = {other};
      SmallQuantities this_one;
      this_one.quantities = {facts->quantity};
      return alone.has(facts->quantity) || this_one.has(other);
    };
    if (std::any_of(small.quantities.begin(), small.quantities.end(), overlaps))
      report.error(name.place, in_quotes(name.text) + " is small already");
    else
      small.quantities.push_back(facts->quantity);
  }
}

void read_order(const TomlEntry& entry, SmallQuantities& small, Report& report) {
  const auto* order = entry.value.as<std::int64_t>();
  if (order != nullptr && *order >= 1 && *order <= kMaxSmallOrder) {
    small.order = static_cast<int>(*order);
    return;
  }
  report.error(entry.value.place,
               "\"order\" is a whole number from 1 to " + std::to_string(kMaxSmallOrder) +
                   (entry.value.as<double>() != nullptr ? ", found one with a point"
                    : order == nullptr                  ? ", found " + std::string(entry.value.kind())
                                                        : ", found " + std::to_string(*order)),
               "1: products of two small quantities are left out");
}

/// { small = ["w1", "w3"], order = 1 }
Given read_small(const TomlEntry& entry, const TomlTable& table, Report& report) {
  Given given{{entry.key}, {}};
  SmallQuantities small;
  read_keys(table, "this assumption",
            {{"small", [&](const TomlEntry& e) { read_small_quantities(e, small, report); }},
             {"order", [&](const TomlEntry& e) { read_order(e, small, report); }}},
            report);
  if (table.find("small") == nullptr)
    report.error(entry.value.place, "this does not say what is small",
                 "write { small = [\"w1\", \"w3\"], order = 1 }");
  else if (table.find("order") == nullptr)
    report.error(entry.value.place, "this does not say to which order in what is small", "write order = 1");
  given.small = std::move(small);
  return given;
}

constexpr std::string_view
    kNoRoom = "these inequalities leave no room: of the bodies and states tried none is like this",
    kNoRoomHint = "what is equal is set with =";

Given read_assumption(const TomlEntry& entry, const Vocabulary& vocabulary,
                      const std::map<int, Dimension>& dimensions, TextReader& texts) {
  Report& report = texts.report();
  if (const auto* table = entry.value.as<TomlTable>()) return read_small(entry, *table, report);
  Given given{{entry.key}, {}};
  const auto read = read_texts(entry, kMaxSettings, report);
  if (!read) return given;
  const std::vector<PlacedText>& lines = *read;
  for (const PlacedText& line : lines) {
    const SourcePlace place =
        texts.source().place_of(located_string(texts.source(), line.place, line.text).offset_of(0));
    if (const std::size_t sign = line.text.find_first_of("<>"); sign != std::string::npos) {
      if (auto bound = read_bound(line.text, sign, place, vocabulary, dimensions, report))
        given.bounds.push_back(std::move(*bound));
      continue;
    }
    auto setting = read_setting(line.text, place, vocabulary, dimensions, report);
    if (!setting) continue;
    if (const auto fault = why_not_set(*setting, given.settings))
      report.error(place, fault->message, fault->hint);
    else
      given.settings.push_back(std::move(*setting));
  }
  if (lines.empty()) report.error(entry.value.place, "nothing is assumed here", "for example [\"I2 = I1\"]");
  const bool is_read = given.settings.size() + given.bounds.size() == lines.size();
  if (!given.empty() && is_read && !is_possible(given))
    report.error(entry.value.place, "no body is like this",
                 "moments are positive, and each is at most the sum of the other two");
  else if (is_read && !bounds_are_possible(given))
    report.error(entry.value.place, std::string(kNoRoom), std::string(kNoRoomHint));
  return given;
}

}  // namespace

Assumptions read_assumptions(const TomlEntry& entry, const Vocabulary& vocabulary,
                             const std::map<int, Dimension>& dimensions, TextReader& texts) {
  Assumptions assumptions;
  Report& report = texts.report();
  const auto* table = entry.value.as<TomlTable>();
  if (table == nullptr) {
    report.error(entry.value.place, "\"assume\" takes a table, found " + std::string(entry.value.kind()),
                 "write [assume], and symmetric = [\"I2 = I1\"] below");
    return assumptions;
  }
  if (table->entries.size() > kMaxAssumptions) {
    report.error(entry.place, "a lesson has at most " + std::to_string(kMaxAssumptions) + " assumptions");
    return assumptions;
  }
  for (const TomlEntry& one : table->entries) {
    if (is_id(one.key))
      assumptions.insert_or_assign(one.key, read_assumption(one, vocabulary, dimensions, texts));
    else
      report.error(one.place, "bad name of an assumption " + in_quotes(one.key), std::string(kIdRule));
  }
  return assumptions;
}

std::optional<Given> given_by(const std::vector<PlacedText>& names, const Assumptions& assumptions,
                              Report& report) {
  Given all;
  for (const PlacedText& name : names) {
    const auto found = assumptions.find(name.text);
    if (found == assumptions.end()) {
      std::vector<std::string> known;
      for (const auto& [one, given] : assumptions) known.push_back(one);
      std::string hint = known.empty() ? "the front matter has no [assume]" : suggestion(name.text, known);
      report.error(name.place, "unknown assumption " + in_quotes(name.text), std::move(hint));
      return std::nullopt;
    }
    if (std::find(all.names.begin(), all.names.end(), name.text) != all.names.end()) {
      report.error(name.place, in_quotes(name.text) + " is given twice");
      return std::nullopt;
    }
    all.names.push_back(name.text);
    for (const Setting& setting : found->second.settings) {
      if (const auto fault = why_not_set(setting, all.settings)) {
        report.error(name.place,
                     in_quotes(name.text) + " does not go with what stands before it: " + fault->message,
                     fault->hint);
        return std::nullopt;
      }
      all.settings.push_back(setting);
    }
    all.bounds.insert(all.bounds.end(), found->second.bounds.begin(), found->second.bounds.end());
    if (const SmallQuantities& small = found->second.small; !small.empty()) {
      if (!all.small.empty() && all.small.order != small.order) {
        report.error(name.place, in_quotes(name.text) + " is of another order than what stands before it",
                     "a claim holds to one order");
        return std::nullopt;
      }
      all.small.order = small.order;
      for (const Quantity quantity : small.quantities)
        if (!all.small.has(quantity)) all.small.quantities.push_back(quantity);
    }
  }
  if (const auto fault = why_not_together(all)) {
    report.error(names.back().place, fault->message, fault->hint);
    return std::nullopt;
  }
  if (names.size() > 1 && (!is_possible(all) || !bounds_are_possible(all))) {
    report.error(names.back().place, "no body is as these assumptions together say");
    return std::nullopt;
  }
  return all;
}

}  // namespace polhode
