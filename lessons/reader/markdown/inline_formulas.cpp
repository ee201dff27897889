// SPDX-License-Identifier: MIT
// Formulas of texts, and the numbers in them.
#include "lessons/claims/motion_words.h"
#include "lessons/reader/markdown/inline_text.h"
#include "render/typeset/math/tree.h"

#include <utility>

namespace polhode {

std::optional<Math> TextReader::formula(const LocatedText& tex) {
  return parse(tex, 0, tex.text().size(), macros_);
}

std::optional<Math> TextReader::parse_inline(const LocatedText& text, std::size_t begin, std::size_t end,
                                             const MathMacros& macros, bool may_compute) {
  auto math = parse(text, begin, end, macros, may_compute);
  if (!math) return std::nullopt;
  const auto refuse = [&](std::size_t at, const char* what) {
    report_.error(source().place_of(text.offset_of(begin + at)), what, "write it as a ```math fence");
  };
  if (!math->tag_offsets.empty())
    refuse(math->tag_offsets.front(), "\\tag numbers a display, and this formula stands in a line of text");
  else if (math->root->kind == MathNode::Kind::grid)
    refuse(0, "& and \\\\ make rows of a display, and this formula stands in a line of text");
  else
    return math;
  return std::nullopt;
}

std::optional<Math> TextReader::parse(const LocatedText& text, std::size_t begin, std::size_t end,
                                      const MathMacros& macros, bool may_compute) {
  // Whether there is still room when so many are added; that there is not is said once.
  const auto has_room_for = [&](std::size_t bytes) {
    const bool was_full = math_bytes_ > kMaxLessonMathBytes;
    math_bytes_ += bytes;
    if (!was_full && math_bytes_ > kMaxLessonMathBytes)
      report_.error(source().place_of(text.offset_of(begin)),
                    "the formulas of a lesson have at most " + std::to_string(kMaxLessonMathBytes) +
                        " bytes in all, with the signs that macros stand for");
    return math_bytes_ <= kMaxLessonMathBytes;
  };
  if (!has_room_for(end - begin <= kMaxMathBytes ? end - begin : 0))
    return std::nullopt;  // refused for itself
  const std::pair<std::size_t, std::string> key{macros.size(), text.text().substr(begin, end - begin)};
  if (const auto known = known_formulas_.find(key); known != known_formulas_.end())
    return has_room_for(known->second.made) ? std::optional(known->second) : std::nullopt;
  auto math = parse_math(key.second, macros, written_in_);
  if (math) {
    const bool has_room = has_room_for(math->made);
    if (math->live.empty()) known_formulas_.emplace(key, *math);
    return has_room && take_numbers_of(*math, text, begin, may_compute) ? std::optional(std::move(*math))
                                                                        : std::nullopt;
  }
  for (const TypeError& error : math.error())
    report(error, source().place_of(text.offset_of(begin + error.offset)));
  return std::nullopt;
}

/// Reads what the numbers of a formula are; false if one is wrong, which is reported.
bool TextReader::take_numbers_of(Math& math, const LocatedText& text, std::size_t begin, bool may_compute) {
  bool all_right = true;
  for (LiveNumber& number : math.live) {
    const auto place_of = [&](std::size_t at) { return source().place_of(text.offset_of(begin + at)); };
    const SourcePlace place = place_of(number.offset);
    if (!may_compute || !language_) {
      report_.error(place,
                    "a computed number stands in text, call-outs, footnotes, captions and displays only");
      return false;
    }
    if (!has_room_for_number(place)) return false;
    auto computed = computed_number(number, place, place_of(number.unit_offset));
    if (computed && number.typed.empty() && has_motion_words(computed->expression)) {
      report_.error(place, "this is a number of the motion as a whole, and \\live shows what it is now",
                    "write it with \\value, or as a column of a ```table");
      computed.reset();
    }
    all_right = all_right && computed;
    if (!computed) continue;
    number.id = computed->written.id = static_cast<int>(numbers_.size());
    numbers_.push_back(std::move(*computed));
  }
  return all_right;
}

bool TextReader::has_room_for_number(SourcePlace place) {
  if (numbers_.size() < kMaxNumbers) return true;
  report_.error(place, "a lesson has at most " + std::to_string(kMaxNumbers) + " computed numbers");
  return false;
}

std::optional<ComputedNumber> TextReader::computed_number(const LiveNumber& written, SourcePlace place,
                                                          SourcePlace unit_place) {
  if (!language_) return std::nullopt;
  auto expression = read_expression(written.expression, place, report_, &language_->vocabulary);
  if (!expression) return std::nullopt;
  if (expression->type() == ExpressionType::vector) {
    report_.error(place, "a computed number is a scalar, this is a vector", "take a component: comp(a, 1)");
    return std::nullopt;
  }
  const DimensionReading reading = dimension_of(*expression, language_->dimensions);
  if (const auto& fault = reading.fault) {
    report_.error(advanced(place, written.expression, fault->begin), fault->message);
    return std::nullopt;
  }
  ComputedNumber computed{std::move(*expression), 1, written, place};
  computed.dimension = reading.dimension;
  if (!written.unit.empty() && !take_unit(computed, unit_place)) return std::nullopt;
  return computed;
}

std::optional<Math> TextReader::formula_of(ComputedNumber number) {
  if (!has_room_for_number(number.place)) return std::nullopt;
  auto math = parse_math("\\live{0}", {}, written_in_).value();
  LiveNumber& shown = math.live.front();
  number.written.whole = shown.whole;
  number.written.id = static_cast<int>(numbers_.size());
  shown = number.written;
  numbers_.push_back(std::move(number));
  return math;
}

/// The number is that of SI: it has to be told how much of that its unit is.
bool TextReader::take_unit(ComputedNumber& number, SourcePlace place) {
  const auto unit = scaled_unit(number.written.unit);
  if (!unit) {
    report_.error(place, "unknown unit " + in_quotes(number.written.unit),
                  "the units of numbers are " + std::string(kUnitNames));
    return false;
  }
  if (const std::string why = why_not_in(number.expression, number.written.unit); !why.empty()) {
    report_.error(place, why);
    return false;
  }
  number.unit_si = unit->size;
  if (!number.dimension || *number.dimension == unit->dimension) return true;
  report_.error(place, "units disagree: the expression is " + to_string(*number.dimension) + ", and " +
                           in_quotes(number.written.unit) + " is " + to_string(unit->dimension));
  return false;
}

/// A mistake in a macro is one, however often the macro is used.
void TextReader::report(const TypeError& error, SourcePlace used_at) {
  const auto body = macro_bodies_.find(error.macro);
  if (body == macro_bodies_.end()) return report_.error(used_at, error.message, error.hint);
  if (!said_of_macros_.emplace(error.macro, error.macro_offset, error.message).second) return;
  report_.error(source().place_of(body->second.offset_of(error.macro_offset)),
                error.message + ", as line " + std::to_string(used_at.line) + " uses it", error.hint);
}

}  // namespace polhode
