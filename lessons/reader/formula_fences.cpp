// SPDX-License-Identifier: MIT
// Fences of formulas and claims.
#include "base/ascii.h"
#include "base/spelling.h"
#include "lessons/claims/expressions/expression_tex.h"
#include "lessons/reader/claim_lines.h"
#include "lessons/reader/claim_rules.h"
#include "lessons/reader/markdown/heading.h"
#include "lessons/reader/stage_builder.h"
#include "render/typeset/math/tree.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace polhode {
namespace {

/// How the lines are printed where they are not the formula itself.
void print_lines(Claim& claim, const Vocabulary& vocabulary) {
  if (claim.origin == Claim::Origin::formula) return;
  for (ClaimLine& line : claim.lines) line.tex = tex_of(line, claim.kind, &vocabulary);
}

/// Whether a formula is a quantity alone, with which one below may go on: no relation, no words.
bool states_nothing(const MathNode& node) {
  using Kind = MathNode::Kind;
  const bool is_word = node.kind == Kind::text && node.atom != MathClass::large;
  if (node.atom == MathClass::relation || is_word || node.kind == Kind::arrow || node.kind == Kind::cancel)
    return false;
  return std::all_of(node.children.begin(), node.children.end(), states_nothing);
}

/// "3", "3.2", "3a", "3'", "A": words beside an equation would say something of it.
bool is_tag(std::string_view tag) {
  const auto is_of_number = [](char c) { return is_digit(c) || c == '.'; };
  const auto is_mark = [](char c) { return c == '\'' || c == '*'; };
  auto at = std::find_if_not(tag.begin(), tag.end(), is_of_number);
  if (at != tag.end() && is_letter(*at)) ++at;
  return !tag.empty() && std::all_of(at, tag.end(), is_mark);
}

}  // namespace

void StageBuilder::add_math(const Fence& fence) {
  take_id(fence, equation_lines_, "equation");
  const std::string_view tex = source_.lines(fence.first_line, fence.last_line);
  if (trimmed_lines(tex).empty()) {
    report_.error(fence.place, "this equation is empty");
    return;
  }
  Equation equation{fence.words[1].text, std::string(tex), "", {}, source_.offset_of(tex), fence.place};
  if (auto math = texts_.formula(LocatedText(source_, tex))) equation.math = std::move(*math);
  equation.tag = equation.math.tag;
  take_tag(equation);
  terms_.insert(equation.math.terms.begin(), equation.math.terms.end());
  auto claim = fence.words.size() > 2 ? claim_printed_in(equation, fence) : std::nullopt;
  above_.reset();
  if (claim && claim->origin == Claim::Origin::formula && claim->kind != ClaimKind::non_sequitur)
    above_ = {equation.math, claim->kind, claim->given.names};
  else if (fence.words.size() == 2 && equation.math.root && states_nothing(*equation.math.root))
    above_ = {equation.math, {}};
  step().blocks.push_back(std::move(equation));
  if (!claim) return;
  parts_ += static_cast<int>(claim->lines.size());
  step().blocks.push_back(std::move(*claim));
}

/// What a fence ```math ID KIND claims: the formula, as it is printed. What cannot be read is an error where
/// it stands.
std::optional<Claim> StageBuilder::claim_printed_in(const Equation& equation, const Fence& fence) {
  const auto kind = kind_from(fence.words[2]);
  if (!kind || !equation.math.root) return std::nullopt;
  const auto place_of = [&](SourceSpan span) { return source_.place_of(equation.offset + span.begin); };
  const auto refuse = [&](const UnreadableEquation& fault) {
    report_.error(place_of(fault.place), "this formula cannot be proved as printed: " + fault.reason,
                  fault.hint.empty()
                      ? "or leave out the kind here, and say in a ```claim fence what is proved"
                      : fault.hint);
    return std::nullopt;
  };
  const auto whole = [](std::string reason, std::string hint = {}) {
    return UnreadableEquation{{0, 0}, std::move(reason), std::move(hint)};
  };
  if (kind == ClaimKind::is_false && !equation.math.live.empty())
    return refuse(whole("a live number is what it is on this motion, and false in general"));
  Claim claim{.equation = equation.id, .kind = *kind, .lines = {}, .place = fence.place};
  if (!take_given(fence, claim)) return std::nullopt;
  const bool goes_on =
      above_ && (!above_->kind || (above_->kind == kind && above_->given == claim.given.names));
  const auto read = read_equation(equation.math, front_.notation, goes_on ? &above_->math : nullptr);
  if (!read) return refuse(read.error());
  if (read->has_condition && !claim.given.empty())
    return refuse(whole("a condition in the formula does not go with what is given", "put it into [assume]"));
  auto lines = claim_lines_of(*read, *kind, place_of);
  if (!lines) return refuse(lines.error());
  claim.lines = std::move(*lines);
  claim.origin = read->is_part ? Claim::Origin::part : Claim::Origin::formula;
  if (!keeps_claim_rules(claim, front_.dimensions, report_)) return std::nullopt;
  print_lines(claim, front_.notation.vocabulary);
  return claim;
}

/// The assumptions that a fence names; false if there is something wrong with them.
bool StageBuilder::take_given(const Fence& fence, Claim& claim) {
  if (fence.given.size() > kMaxGiven) {
    report_.error(fence.given[kMaxGiven].place,
                  "a claim puts together at most " + std::to_string(kMaxGiven) + " assumptions");
    return false;
  }
  auto given = given_by(fence.given, front_.assumptions, report_);
  if (!given) return false;
  claim.given = std::move(*given);
  if (claim.kind == ClaimKind::free && (claim.given.sets_torque() || claim.given.small.has_torque())) {
    report_.error(fence.given.front().place, "this gives a torque, and the kind free says that there is none",
                  "the kind is motion");
    return false;
  }
  return true;
}

std::optional<ClaimKind> StageBuilder::kind_from(const PlacedText& word) {
  const auto kind = claim_kind_from(word.text);
  if (!kind)
    report_.error(word.place, "unknown kind of claim " + in_quotes(word.text),
                  suggestion(word.text, claim_kind_names()));
  return kind;
}

/// Several tags of one equation are joined by commas. An equation that is printed once more keeps its number.
void StageBuilder::take_tag(const Equation& equation) {
  std::size_t begin = 0;
  for (const std::size_t at : equation.math.tag_offsets) {
    const std::size_t end = std::min(equation.tag.find(", ", begin), equation.tag.size());
    const std::string tag = equation.tag.substr(begin, end - begin);
    begin = std::min(end + 2, equation.tag.size());
    const SourcePlace place = source_.place_of(equation.offset + at);
    if (!is_tag(tag))
      report_.error(place, "a tag is a number, or a letter, and not " + in_quotes(tag),
                    "for example 3, 3a or 3'; write words into the text");
    const auto [first, is_new] = tags_.try_emplace(tag, Tagged{place.line, equation.tex});
    if (!is_new && first->second.tex != equation.tex)
      report_.warning(
          place, "another equation has tag (" + tag + "), on line " + std::to_string(first->second.line));
  }
}

void StageBuilder::add_claim(const Fence& fence) {
  claimed_.push_back(fence.words[1]);
  const auto kind = kind_from(fence.words[2]);
  if (!kind) return;
  if (trimmed_lines(source_.lines(fence.first_line, fence.last_line)).empty()) {
    report_.error(fence.place, "this claim is empty", "write left = right on each line");
    return;
  }
  Claim claim{.equation = fence.words[1].text, .kind = *kind, .lines = {}, .place = fence.place};
  claim.in_other_words = fence.words.size() > 3;
  const Vocabulary& vocabulary = front_.notation.vocabulary;
  claim.lines = read_claim_lines(source_, fence.first_line, fence.last_line, *kind, report_, &vocabulary);
  parts_ += static_cast<int>(claim.lines.size());
  if (!take_given(fence, claim) || !keeps_claim_rules(claim, front_.dimensions, report_)) return;
  print_lines(claim, vocabulary);
  step().blocks.push_back(std::move(claim));
}

}  // namespace polhode
