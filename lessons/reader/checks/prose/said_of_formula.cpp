// SPDX-License-Identifier: MIT
#include "lessons/reader/checks/prose/said_of_formula.h"

#include "base/ascii.h"
#include "lessons/claims/customary_names.h"
#include "lessons/claims/expressions/dimension.h"
#include "lessons/notation/tex_sides.h"
#include "lessons/reader/checks/prose/clause.h"
#include "lessons/reader/checks/prose/quantity_words.h"
#include "lessons/reader/text_units.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <utility>

namespace polhode {
namespace {

/// What words say of two things, or of one and 0.
enum class Predicate { equal, greater, less, parallel, perpendicular, zero, constant };

using Phrase = std::pair<std::string_view, Predicate>;

/// Between one and the other.
constexpr std::array<Phrase, 14> kOfTwo{{{"is equal to", Predicate::equal},
                                         {"is the same as", Predicate::equal},
                                         {"is larger than", Predicate::greater},
                                         {"is greater than", Predicate::greater},
                                         {"is more than", Predicate::greater},
                                         {"exceeds", Predicate::greater},
                                         {"is smaller than", Predicate::less},
                                         {"is less than", Predicate::less},
                                         {"is parallel to", Predicate::parallel},
                                         {"is along", Predicate::parallel},
                                         {"is perpendicular to", Predicate::perpendicular},
                                         {"is normal to", Predicate::perpendicular},
                                         {"is orthogonal to", Predicate::perpendicular},
                                         {"is at right angles to", Predicate::perpendicular}}};
/// Behind both, which "and" joins.
constexpr std::array<Phrase, 6> kOfBoth{{{"are equal", Predicate::equal},
                                         {"are the same", Predicate::equal},
                                         {"are parallel", Predicate::parallel},
                                         {"are perpendicular", Predicate::perpendicular},
                                         {"are normal to each other", Predicate::perpendicular},
                                         {"are at right angles", Predicate::perpendicular}}};
/// Behind one.
constexpr std::array<Phrase, 13> kOfOne{{{"vanishes", Predicate::zero},
                                         {"is zero", Predicate::zero},
                                         {"is always zero", Predicate::zero},
                                         {"is nothing", Predicate::zero},
                                         {"is constant", Predicate::constant},
                                         {"is conserved", Predicate::constant},
                                         {"is a constant", Predicate::constant},
                                         {"does not change", Predicate::constant},
                                         {"never changes", Predicate::constant},
                                         {"stays constant", Predicate::constant},
                                         {"stays the same", Predicate::constant},
                                         {"remains constant", Predicate::constant},
                                         {"remains the same", Predicate::constant}}};

std::optional<Expression> read(const std::string& text, const Lesson& lesson) {
  const SourceText source(text);
  Report unused(source, "");
  return read_expression(text, {1, 1}, unused, &lesson.notation.vocabulary);
}

std::string text_of(const std::vector<TextSpan>& clause) {
  const bool is_text = clause.size() == 1 && clause.front().kind == TextSpan::Kind::text;
  return is_text ? std::string(without_blanks(clause.front().text)) : "";
}

class Sayings {
 public:
  Sayings(const std::vector<TextSpan>& line, std::size_t at, const Lesson& lesson)
      : line_(line), at_(at), lesson_(lesson) {
    if (!read_typed(line[at].math)) is_ = read_side(line[at].math, lesson.notation);
  }

  std::vector<StatedLink> all() const {
    std::vector<StatedLink> said;
    if (!is_) return said;
    if (auto before = named_before()) said.push_back(std::move(*before));
    if (auto behind = stands_alone() ? said_behind() : std::nullopt) said.push_back(std::move(*behind));
    return said;
  }

 private:
  StatedLink link(Expression left, Expression right, Relation relation) const {
    StatedLink link;
    link.left.is = std::move(left);
    link.right.is = std::move(right);
    link.relation = relation;
    link.source = {0, static_cast<std::uint32_t>(line_[at_].text.size())};
    return link;
  }

  VectorsSaid kind() const {
    return is_->type() == ExpressionType::vector ? VectorsSaid::as_vectors : VectorsSaid::as_lengths;
  }

  std::optional<StatedLink> named_before() const {
    // "is $I_1$ times the rate"
    const bool goes_on = at_ + 1 < line_.size() && !line_[at_].break_after &&
                         (line_[at_ + 1].kind == TextSpan::Kind::math ||
                          !starts_with_any(line_[at_ + 1].text, {".", ",", ";", ":", "!", ")"}));
    if (goes_on) return std::nullopt;
    std::vector<TextSpan> clause = clause_before(line_, at_);
    const auto relation = take_verb(clause);
    if (!relation || !has_words(clause)) return std::nullopt;
    auto said = quantity_said_at_end(clause, lesson_, kind());
    return said ? std::optional(link(std::move(*said), *is_, *relation)) : std::nullopt;
  }

  /// Not itself a part of what it ends, as in "the square of $T$ is".
  bool stands_alone() const {
    const std::vector<TextSpan> before = clause_before(line_, at_);
    if (before.empty()) return true;
    return before.back().kind == TextSpan::Kind::text &&
           (without_blanks(before.back().text).empty() || !goes_on_with_name(before.back().text));
  }

  std::optional<StatedLink> said_behind() const {
    const std::vector<TextSpan> behind = clause_behind(line_, at_);
    if (behind.empty() || behind.front().kind != TextSpan::Kind::text) return std::nullopt;
    const std::string words = text_of(behind);
    for (const auto& [phrase, predicate] : kOfOne)
      if (words == phrase || words == std::string(phrase) + " in space") return of_one(predicate);
    const bool joins_two = behind.size() == 3 && without_blanks(behind[0].text) == "and" &&
                           behind[1].kind == TextSpan::Kind::math;
    if (joins_two) {
      const std::string both = text_of({behind[2]});
      const auto other = read_side(behind[1].math, lesson_.notation);
      for (const auto& [phrase, predicate] : kOfBoth)
        if (both == phrase && other) return of_two(predicate, *other);
      return std::nullopt;
    }
    std::vector<TextSpan> rest = behind;
    for (const auto& [phrase, predicate] : kOfTwo)
      if (take_at_start(rest, phrase)) return of_two(predicate, quantity_said(rest, lesson_, kind()));
    const auto relation = take_verb_at_start(rest);
    auto said = relation ? quantity_said(rest, lesson_, kind()) : std::nullopt;
    return said ? std::optional(link(*is_, std::move(*said), *relation)) : std::nullopt;
  }

  static bool take_at_start(std::vector<TextSpan>& clause, std::string_view phrase) {
    std::string& text = clause.front().text;
    const std::string_view rest = without_blanks(text);
    if (!rest.starts_with(phrase) || (rest.size() > phrase.size() && is_letter(rest[phrase.size()])))
      return false;
    text = std::string(rest.substr(phrase.size()));
    return true;
  }

  std::optional<StatedLink> of_one(Predicate predicate) const {
    if (predicate == Predicate::zero) {
      StatedLink nothing = link(*is_, *read("0", lesson_), Relation::equal);
      nothing.is_in_words = true;
      return nothing;
    }
    auto rate = read("ddt(" + is_->text + ')', lesson_);
    if (!rate) return std::nullopt;
    StatedLink constant = link(std::move(*rate), *read("0", lesson_), Relation::equal);
    constant.is_of_all_times = true;
    return constant;
  }

  std::optional<StatedLink> of_two(Predicate predicate, const std::optional<Expression>& other) const {
    if (!other) return std::nullopt;
    const bool are_vectors = is_->type() == ExpressionType::vector && other->type() == ExpressionType::vector;
    if (predicate == Predicate::equal) return link(*is_, *other, Relation::equal);
    if (predicate == Predicate::greater || predicate == Predicate::less) {
      if (is_->type() == ExpressionType::vector || other->type() == ExpressionType::vector)
        return std::nullopt;
      return link(*is_, *other, predicate == Predicate::greater ? Relation::greater : Relation::less);
    }
    if (!are_vectors) return std::nullopt;
    const char* product = predicate == Predicate::parallel ? "cross(" : "dot(";
    auto made = read(product + is_->text + ", " + other->text + ')', lesson_);
    return made ? std::optional(link(std::move(*made), *read("0", lesson_), Relation::equal)) : std::nullopt;
  }

  const std::vector<TextSpan>& line_;
  std::size_t at_;
  const Lesson& lesson_;
  std::optional<Expression> is_;  ///< nothing: it is a number, or cannot be read
};

}  // namespace

std::vector<StatedLink> said_of_formula(const std::vector<TextSpan>& line, std::size_t at,
                                        const Lesson& lesson) {
  return Sayings(line, at, lesson).all();
}

std::string why_not_called(const std::vector<TextSpan>& line, std::size_t at, const Lesson& lesson) {
  if (at == 0 || line[at - 1].kind != TextSpan::Kind::text || read_typed(line[at].math)) return "";
  const auto is = read_side(line[at].math, lesson.notation);
  if (!is) return "";
  std::string words;
  for (const char c : without_blanks(line[at - 1].text))
    words += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  std::size_t begin = words.npos;  // of what follows the last article
  for (const std::string_view article : {"the ", "its "}) {
    const std::size_t found = words.rfind(article);
    const bool is_word = found != words.npos && (found == 0 || words[found - 1] == ' ');
    if (is_word && (begin == words.npos || found + article.size() > begin)) begin = found + article.size();
  }
  if (begin == words.npos) return "";
  const std::string name = words.substr(begin);
  const auto dimension = dimension_of(*is, {}).dimension;
  // The tip of an arrow has a velocity, too.
  if (name == "velocity" || can_have(dimensions_of_words(name), dimension)) return "";
  return "this is called " + in_quotes(name) + ", and is " + to_string(*dimension);
}

}  // namespace polhode
