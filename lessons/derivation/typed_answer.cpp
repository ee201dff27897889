// SPDX-License-Identifier: MIT
#include "lessons/derivation/typed_answer.h"

#include "base/utf8.h"
#include "lessons/diagnostics/report.h"
#include "lessons/notation/tex_numbers.h"

#include <array>

namespace polhode {
namespace {

Failure<UnreadableLine> refuse(std::string message, std::string hint, int column, bool of_kinds = false) {
  return {{std::move(message), std::move(hint), column, "", of_kinds}};
}

int column_at(std::string_view text, std::size_t at) {
  return 1 + count_characters(text.substr(0, std::min(at, text.size())));
}

Result<TypedAnswer, UnreadableLine> read_as_claim(std::string_view text, const LineNotation& how) {
  const SourceText source(text);
  Report report(source, "");
  auto read = read_expression(text, {1, 1}, report, &how.notation->vocabulary);
  if (read) return TypedAnswer{std::move(*read)};
  const Diagnostic fault = report.take().front();
  return refuse(fault.message, fault.hint, fault.place.column);
}

/// No formula prints them but as a symbol of the lesson; answers may have them.
constexpr std::array<const char*, 2> kAnyNumbers{"h", "k"};

Result<TypedAnswer, UnreadableLine> read_as_line(std::string_view text, const LineNotation& how) {
  TypedNames names = how.names;
  EquationNotation notation = *how.notation;
  for (const char* number : kAnyNumbers)
    if (names.try_emplace(number, number).second)
      notation.symbols.push_back({number, parse_math(number).value(), ""});
  const TypedFormula formula = typed_formula(text, names);
  if (formula.fault)
    return refuse(formula.fault->message, formula.fault->hint, column_at(text, formula.fault->at));
  const auto place = [&](std::size_t tex_at) { return column_at(text, typed_offset(formula, tex_at)); };
  const auto math = parse_math(formula.tex, how.macros);
  if (!math) return refuse(math.error().front().message, "", place(math.error().front().offset));
  auto read = read_one_side(*math, notation);
  if (!read)
    return refuse(read.error().reason, read.error().hint, place(read.error().place.begin),
                  read.error().of_kinds);
  return TypedAnswer{std::move(*read), false};
}

}  // namespace

Result<TypedAnswer, UnreadableLine> read_typed_answer(std::string_view text, const LineNotation& how) {
  if (SourceText(text).line_count() > 1) return refuse("an answer is one line", "", 0);
  if (const std::size_t equals = text.find('='); equals != text.npos)
    return refuse("an answer is one side of an equation",
                  "type what stands behind the =", column_at(text, equals));
  auto as_claim = read_as_claim(text, how);
  if (as_claim) return as_claim;
  auto as_line = read_as_line(text, how);
  return as_line || as_line.error().column >= as_claim.error().column ? as_line : as_claim;
}

}  // namespace polhode
