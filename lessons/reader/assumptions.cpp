// SPDX-License-Identifier: MIT
#include "lessons/reader/assumptions.h"

#include "base/spelling.h"
#include "lessons/claims/expression_names.h"
#include "lessons/claims/expression_tex.h"
#include "lessons/claims/small_states.h"

#include <algorithm>
#include <utility>

namespace polhode {
namespace {

/// "I2 = I1"; reports what it is not.
std::optional<Setting> read_setting(const std::string& text, SourcePlace place, const Vocabulary& vocabulary,
                                    const std::map<int, Dimension>& dimensions, Report& report) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) {
    report.error(place, "an assumption reads quantity = expression, there is no = here",
                 "for example I2 = I1");
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

Given read_assumption(const TomlEntry& entry, const Vocabulary& vocabulary,
                      const std::map<int, Dimension>& dimensions, TextReader& texts) {
  Report& report = texts.report();
  Given given{{entry.key}, {}};
  const auto read = read_texts(entry, kMaxSettings, report);
  if (!read) return given;
  const std::vector<PlacedText>& lines = *read;
  for (const PlacedText& line : lines) {
    const SourcePlace place =
        texts.source().place_of(located_string(texts.source(), line.place, line.text).offset_of(0));
    auto setting = read_setting(line.text, place, vocabulary, dimensions, report);
    if (!setting) continue;
    if (const auto fault = why_not_set(*setting, given.settings))
      report.error(place, fault->message, fault->hint);
    else
      given.settings.push_back(std::move(*setting));
  }
  if (lines.empty()) report.error(entry.value.place, "nothing is assumed here", "for example [\"I2 = I1\"]");
  if (!given.empty() && given.settings.size() == lines.size() && !is_possible(given))
    report.error(entry.value.place, "no body is like this",
                 "moments are positive, and each is at most the sum of the other two");
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
  }
  if (names.size() > 1 && !is_possible(all)) {
    report.error(names.back().place, "no body is as these assumptions together say");
    return std::nullopt;
  }
  return all;
}

}  // namespace polhode
