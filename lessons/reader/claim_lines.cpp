// SPDX-License-Identifier: MIT
#include "lessons/reader/claim_lines.h"

#include "base/numbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace polhode {
namespace {

constexpr std::string_view kWithin = "within";
constexpr std::string_view kImplies = "=>";

// One line, read from the outside in: tolerance, then the two sides, then the expressions.
class ClaimLineReader {
 public:
  ClaimLineReader(std::string_view line, int number, ClaimKind kind, Report& report,
                  const Vocabulary* vocabulary)
      : line_(line), start_{number, 1}, kind_(kind), report_(report), vocabulary_(vocabulary) {}

  std::optional<ClaimLine> read() {
    ClaimLine result;
    const std::string_view text = trimmed(line_);
    result.place = place_of(text);
    const auto statement = take_within(text, result);
    if (!statement) return std::nullopt;
    const std::size_t implies = statement->find(kImplies);
    if (kind_ == ClaimKind::non_sequitur) return read_inference(*statement, implies, result);
    if (implies != std::string_view::npos) {
      if (kind_ != ClaimKind::is_false && kind_ != ClaimKind::measured)
        return read_inference(*statement, implies, result);
      fail(statement->substr(implies), "what follows is neither false nor measured",
           "the kind non-sequitur says that it does not follow");
      return std::nullopt;
    }
    return read_sides(*statement, result.equality, &result.relation) ? std::optional(result) : std::nullopt;
  }

 private:
  SourcePlace place_of(std::string_view part) const {
    return advanced(start_, line_, static_cast<std::size_t>(part.data() - line_.data()));
  }
  void fail(std::string_view at, std::string message, std::string hint = {}) {
    report_.error(place_of(at), std::move(message), std::move(hint));
  }

  // The text before `within`, whose number goes into the claim; nothing if that is wrong.
  std::optional<std::string_view> take_within(std::string_view text, ClaimLine& claim) {
    const std::size_t at = text.rfind(kWithin);
    if (at == std::string_view::npos || !stands_alone(text, at)) return text;
    const std::string_view word = text.substr(at);
    if (kind_ != ClaimKind::measured) {
      fail(word, "\"within\" is for claims of the kind measured");
      return std::nullopt;
    }
    const std::string_view number_text = trimmed(word.substr(kWithin.size()));
    const auto number = parse_number(number_text);
    if (!number || !std::isfinite(*number) || *number <= 0) {
      fail(number_text, "\"within\" takes a relative tolerance greater than 0", "within 1e-9");
      return std::nullopt;
    }
    claim.within = *number;
    return trimmed(text.substr(0, at));
  }

  static bool stands_alone(std::string_view text, std::size_t at) {
    const std::string_view rest = text.substr(at + kWithin.size());
    const bool begins = at == 0 || text[at - 1] == ' ' || text[at - 1] == '\t';
    return begins && (rest.empty() || rest.front() == ' ' || rest.front() == '\t');
  }

  std::optional<ClaimLine> read_inference(std::string_view text, std::size_t implies, ClaimLine result) {
    if (implies == std::string_view::npos) {
      fail(text, "a non-sequitur reads premise => conclusion");
      return std::nullopt;
    }
    const std::string_view premise = trimmed(text.substr(0, implies));
    const std::string_view conclusion = trimmed(text.substr(implies + kImplies.size()));
    const bool premise_ok = read_equality(premise, result.equality);
    const bool conclusion_ok = read_equality(conclusion, result.conclusion.emplace());
    return premise_ok && conclusion_ok ? std::optional(result) : std::nullopt;
  }

  bool read_equality(std::string_view text, Equality& into) { return read_sides(text, into, nullptr); }

  /// `relation`: what stands between the sides; null: = alone can stand there.
  bool read_sides(std::string_view text, Equality& into, Relation* relation) {
    const std::size_t equals = text.find_first_of(relation == nullptr ? "=" : "<=>~");
    if (equals == std::string_view::npos) {
      fail(text, "a claim reads left = right, there is no = here");
      return false;
    }
    std::size_t end = equals + 1;
    if (text[equals] == '~') {
      if (text.substr(end, 1) != "=") {
        fail(text.substr(equals), "this relation is not read", "write ~= for what is approximately equal");
        return false;
      }
      ++end;
      *relation = Relation::approximate;
    } else if (relation != nullptr && text[equals] != '=') {
      const bool or_equal = text.substr(end, 1) == "=";
      if (or_equal) ++end;
      if (kind_ == ClaimKind::measured) {
        fail(text.substr(equals), "what is measured is an equality", "the kind identity, motion or free");
        return false;
      }
      *relation = text[equals] == '<' ? or_equal ? Relation::less_or_equal : Relation::less
                  : or_equal          ? Relation::greater_or_equal
                                      : Relation::greater;
    }
    const std::string_view left_text = trimmed(text.substr(0, equals));
    const std::string_view right_text = trimmed(text.substr(end));
    // Both are read, so that both are reported.
    auto left =
        read_expression(left_text, place_of(left_text.empty() ? text : left_text), report_, vocabulary_);
    auto right = read_expression(right_text, place_of(right_text), report_, vocabulary_);
    if (!left || !right) return false;
    into = {std::move(*left), std::move(*right)};
    if (relation != nullptr && is_order(*relation) && into.is_vector()) {
      fail(text.substr(equals), "of two vectors none is the greater", "compare norm(a) and norm(b)");
      return false;
    }
    if (fit(into.left.type(), into.right.type())) return check_lengths(text, into);
    fail(text.substr(equals), std::string(name_of(into.left.type())) + " and " +
                                  std::string(name_of(into.right.type())) + " cannot be equal");
    return false;
  }

  bool check_lengths(std::string_view text, const Equality& equality) {
    if (kind_ == ClaimKind::measured || is_provable(equality)) return true;
    if (has_angles(equality)) {
      fail(text, std::string(kNoAngles), "measure the claim");
      return false;
    }
    fail(text, "a length is a root, and a proof has none: it is a whole side here, norm(a) = norm(b)",
         "square both sides with norm2(a), or measure the claim");
    return false;
  }

  std::string_view line_;
  SourcePlace start_;
  ClaimKind kind_;
  Report& report_;
  const Vocabulary* vocabulary_;
};

}  // namespace

std::vector<ClaimLine> read_claim_lines(const SourceText& source, int first_line, int last_line,
                                        ClaimKind kind, Report& report, const Vocabulary* vocabulary) {
  std::vector<ClaimLine> lines;
  for (int line = first_line; line <= last_line && !report.is_full(); ++line) {
    const std::string_view text = source.line(line);
    if (is_blank(text)) continue;
    if (lines.size() == kMaxClaimLines) {
      report.error({line, 1}, "a claim has at most " + std::to_string(kMaxClaimLines) + " lines");
      break;
    }
    if (auto claim = ClaimLineReader(text, line, kind, report, vocabulary).read())
      lines.push_back(std::move(*claim));
  }
  return lines;
}

}  // namespace polhode
