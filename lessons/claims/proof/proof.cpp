// SPDX-License-Identifier: MIT
#include "lessons/claims/proof/proof.h"

#include "base/numbers.h"
#include "lessons/claims/condition.h"
#include "lessons/claims/expressions/degree.h"
#include "lessons/claims/expressions/lengths.h"
#include "lessons/claims/proof/counterexample_text.h"
#include "lessons/claims/proof/expansion.h"
#include "lessons/claims/proof/signs.h"
#include "lessons/claims/proof/whole_number_states.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>

namespace polhode {
namespace {

/// Whole numbers of fewer bits are 0 if the prime 2⁶¹ − 1 divides them; those of fewer than both together if
/// both primes do.
constexpr double kBitsOfOnePrime = 60, kBitsOfBoth = 187;

/// Of left − right, free of fractions, with what is given put in.
Degree degree_of_difference(const Equality& equality, const Given& given) {
  if (given.settings.empty())
    return degree_of_difference(equality.left.nodes.back().degree, equality.right.nodes.back().degree);
  const DegreeTable table(given);
  return degree_of_difference(table.of(equality.left), table.of(equality.right));
}

/// The words for a motion are constants too, numbered behind the lesson's (motion_words.h), and may be more
/// than a state has places for: they take places that are free. Nothing if these are too few.
std::optional<Equality> in_places_of_a_state(Equality equality, const Given& given) {
  std::array<bool, kMaxConstants> is_taken{};
  bool is_in_place = true;
  const auto look_at = [&](const Expression& expression) {
    for (const ExpressionNode& node : expression.nodes) {
      if (node.operation != Operation::constant) continue;
      const auto place = static_cast<std::size_t>(node.integer);
      if (place < kMaxConstants)
        is_taken[place] = true;
      else
        is_in_place = false;
    }
  };
  for (const Expression* side : {&equality.left, &equality.right}) look_at(*side);
  if (is_in_place) return equality;
  for (const Setting& setting : given.settings) look_at(setting.value);
  std::map<int, int> moved;
  for (Expression* side : {&equality.left, &equality.right}) {
    auto names = side->constants ? *side->constants : std::vector<std::string>();
    for (ExpressionNode& node : side->nodes) {
      if (node.operation != Operation::constant || node.integer < static_cast<int>(kMaxConstants)) continue;
      const auto [place, is_new] = moved.try_emplace(node.integer, 0);
      if (is_new) {
        const auto free = std::ranges::find(is_taken, false);
        if (free == is_taken.end()) return std::nullopt;
        *free = true;
        place->second = static_cast<int>(free - is_taken.begin());
      }
      names[static_cast<std::size_t>(place->second)] = names[static_cast<std::size_t>(node.integer)];
      node.integer = place->second;
    }
    side->constants = std::make_shared<const std::vector<std::string>>(std::move(names));
  }
  return equality;
}

constexpr std::uint64_t kSeed = 20250614;

/// FNV-1a of 64 bits, from `hash` on.
std::uint64_t hash_of(std::string_view text, std::uint64_t hash) {
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return hash;
}

/// std::uniform_int_distribution differs between libraries; the engine does not.
FieldElement random_residue(std::mt19937_64& random) {
  std::uint64_t bits = kPrime;
  while (bits >= kPrime) bits = random() >> 3;
  return FieldElement(static_cast<std::int64_t>(bits));
}

FieldElement random_unit(std::mt19937_64& random) {
  FieldElement element;
  while (element.is_zero()) element = random_residue(random);
  return element;
}

template <class N, class Draw>
StateNumbers<N> drawn_numbers(const Draw& draw) {
  StateNumbers<N> numbers;
  const auto fill = [&](auto& all) {
    for (N& one : all) one = draw();
  };
  fill(numbers.q);
  fill(numbers.I);
  fill(numbers.J);
  for (auto* vector : {&numbers.w, &numbers.dw, &numbers.v_S, &numbers.dv_S, &numbers.A_S, &numbers.dA_S,
                       &numbers.N_B, &numbers.F_S})
    fill(*vector);
  numbers.m = draw();
  numbers.h = draw();
  numbers.k = draw();
  fill(numbers.constants);
  for (auto* vector : {&numbers.ddw, &numbers.ddv_S, &numbers.ddA_S, &numbers.dN_B, &numbers.dF_S})
    fill(*vector);
  return numbers;
}

StateNumbers<FieldElement> random_numbers(std::mt19937_64& random) {
  const auto length2 = [](const std::array<FieldElement, 4>& q) {
    return q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
  };
  StateNumbers<FieldElement> numbers;
  do {
    numbers = drawn_numbers<FieldElement>([&] { return random_unit(random); });
  } while (length2(numbers.q).is_zero());
  return numbers;
}

/// "3" of "9", "0.5" of "0.25", but "√2" of "2": a number whose square, as a text, is written in full.
std::string root_text(const std::string& square) {
  constexpr int kDigits = 3;  // the square of so many has at most the 6 that number_text writes
  const double value = parse_number(square).value_or(0);
  const double root = parse_number(digits(std::sqrt(value), kDigits)).value_or(0);
  return number_text(root * root) == square ? number_text(root) : "√" + square;
}

/// The values of lengths, of whose squares those in `found` are.
std::optional<Counterexample> with_roots(std::optional<Counterexample> found, const Equality& equality) {
  const auto root = [](std::string& square, const Expression& side) {
    if (is_length(side)) square = root_text(square);
  };
  if (found) root(found->left, equality.left), root(found->right, equality.right);
  return found;
}

Judgement not_what_it_says(std::string message, std::string hint,
                           std::optional<Counterexample> counter = {}) {
  if (counter) message += ": " + to_string(*counter);
  return {Verdict::fails, std::move(message), std::move(hint), std::move(counter)};
}

Judgement undecided() {
  return {Verdict::undecided,
          "it cannot be decided whether this holds",
          "both sides must be defined almost everywhere: is something divided by 0, or a number too large?",
          {}};
}

/// What else could have been meant by an equality that fails under these laws.
std::string weaker_kind(const Equality& failing, LawsAssumed failed, const Prover& prover,
                        const Given& given) {
  const Equality equality = with_lengths_squared(failing);  // as a whole: below each side is looked at alone
  if (failed == LawsAssumed::identity &&
      prover.settle(equality, LawsAssumed::motion, given) == Verdict::holds)
    return "it follows from the equations of motion: its kind is motion";
  if (given.sets_torque()) return "";
  const bool both_vanish =
      equality.right.type() != ExpressionType::zero &&
      prover.settle({equality.right, zero_expression()}, LawsAssumed::free, given) == Verdict::holds;
  if (failed != LawsAssumed::free && !both_vanish &&
      prover.settle(equality, LawsAssumed::free, given) == Verdict::holds)
    return "it holds without torque: its kind is free";
  return "";
}

Judgement judge_equality(const ClaimLine& line, ClaimKind kind, const Prover& prover, const Given& given) {
  const LawsAssumed laws = laws_assumed_by(kind, given);
  const Verdict verdict = prover.settle(line.equality, laws, given);
  if (verdict == Verdict::holds) return {};
  if (verdict == Verdict::undecided) return undecided();
  return not_what_it_says("this does not hold", weaker_kind(line.equality, laws, prover, given),
                          prover.refute(line.equality, laws, given));
}

Judgement judge_order(const ClaimLine& line, ClaimKind kind, const Prover& prover, const Given& given) {
  Judgement judgement = prover.settle_inequality(line, laws_assumed_by(kind, given), given);
  if (kind != ClaimKind::is_false) return judgement;
  if (judgement.verdict == Verdict::fails) return {Verdict::holds, "", "", judgement.counterexample};
  if (judgement.verdict == Verdict::undecided) return judgement;
  return not_what_it_says(judgement.verdict == Verdict::holds
                              ? "this is called false, but it holds"
                              : "this is called false, but no state was found in which it fails",
                          "");
}

Judgement judge_false(const ClaimLine& line, const Prover& prover, const Given& given) {
  const LawsAssumed laws = laws_assumed_by(ClaimKind::is_false, given);
  const Verdict verdict = prover.settle(line.equality, laws, given);
  if (verdict == Verdict::undecided) return undecided();
  if (verdict == Verdict::holds)
    return not_what_it_says(laws == LawsAssumed::free
                                ? "this is called false, but it holds without torque"
                                : "this is called false, but it holds under the torque that is given",
                            "");
  Judgement judgement;
  judgement.counterexample = prover.refute(line.equality, laws, given);
  // What is given may leave so few bodies that it holds for all that can be.
  if (!given.empty() && !judgement.counterexample)
    return not_what_it_says("no possible body was found, as is given, for which this fails",
                            "perhaps it holds for all that can be");
  return judgement;
}

/// "to first order"
std::string to_order(const Given& given) {
  return "to " + std::string(name_of_order(given.small.order)) + " order";
}

/// What agrees to some order in what is small, or does not.
Judgement judge_approximation(const ClaimLine& line, ClaimKind kind, const Prover& prover,
                              const Given& given) {
  const LawsAssumed laws = laws_assumed_by(kind, given);
  Judgement judgement = prover.settle_in_series(line.equality, laws, given);
  if (judgement.verdict == Verdict::undecided) return judgement;
  const bool holds = judgement.verdict == Verdict::holds;
  if (kind == ClaimKind::is_false) {
    if (holds) return not_what_it_says("this is called false, but it holds " + to_order(given), "");
    if (!judgement.counterexample)
      return not_what_it_says("no possible body was found, as is given, for which this fails", "");
    return {Verdict::holds, "", "", judgement.counterexample};
  }
  if (holds) return {};
  const auto holds_under = [&](LawsAssumed other) {
    return prover.settle_in_series(line.equality, other, given).verdict == Verdict::holds;
  };
  if (laws == LawsAssumed::identity && holds_under(LawsAssumed::motion))
    judgement.hint = "it follows from the equations of motion: its kind is motion";
  else if (laws != LawsAssumed::free && !given.sets_torque() && !given.small.has_torque() &&
           holds_under(LawsAssumed::free))
    judgement.hint = "it holds without torque: its kind is free";
  return judgement;
}

/// What follows where the premise holds, which is put into the states as what is given is.
Judgement judge_implication(const ClaimLine& line, ClaimKind kind, const Prover& prover, const Given& given) {
  const LawsAssumed laws = laws_assumed_by(kind, given);
  const auto refuse = [](std::string why, std::string hint = {}) {
    return Judgement{Verdict::undecided, std::move(why), std::move(hint), {}};
  };
  auto settings = settings_of_condition(line.equality, laws, given);
  if (!settings)
    return refuse(settings.error(), "assume it in [assume], or claim only that it does not follow");
  Given all = given;
  all.settings.insert(all.settings.end(), settings->begin(), settings->end());
  if (!is_possible(all) || !bounds_are_possible(all))
    return refuse("this condition holds for no possible body");
  const Equality& conclusion = *line.conclusion;
  const int order = std::max(conclusion.left.order(), conclusion.right.order());
  if (order > 1 || (order > 0 && all.sets_spin()))
    return refuse("a condition holds at an instant, and says nothing of the rates of what it is about");
  const Verdict verdict = prover.settle(conclusion, laws, all);
  if (verdict == Verdict::holds) return {};
  if (verdict == Verdict::undecided) return undecided();
  return not_what_it_says("this does not follow", "", prover.refute(conclusion, laws, all));
}

Judgement judge_inference(const ClaimLine& line, const Prover& prover, const Given& given) {
  const auto order = [](const Equality& equality) {
    return std::max(equality.left.order(), equality.right.order());
  };
  if (order(*line.conclusion) > std::max(1, order(line.equality)))
    return {Verdict::undecided,
            "this asks for a rate of what the premise is about: of what holds all the time it would follow",
            "let the conclusion have no more derivatives than the premise",
            {}};
  Judgement judgement;
  judgement.counterexample = prover.refute_inference(line.equality, *line.conclusion, given);
  if (judgement.counterexample) return judgement;
  return not_what_it_says(
      "no body and state of small whole numbers was found at which the premise holds and "
      "the conclusion fails",
      "perhaps it does follow");
}

}  // namespace

Prover::Prover() {
  std::mt19937_64 random(kSeed);
  for (std::size_t laws = 0; laws < samples_.size(); ++laws)
    for (int n = 0; n < kMostSamples; ++n) {
      numbers_[laws].push_back(random_numbers(random));
      samples_[laws].push_back(state_of(numbers_[laws].back(), static_cast<LawsAssumed>(laws)));
    }
  wide_ = drawn_numbers<WideFieldElement>([&] {
    WideFieldElement element(1 + static_cast<std::int64_t>(random() >> 3));
    for (int n = 0; n < 2; ++n)
      element =
          element * WideFieldElement(std::int64_t{1} << 60) + 1 + static_cast<std::int64_t>(random() >> 3);
    return element;
  });
}

std::optional<bool> Prover::agrees_at(std::size_t sample, const Equality& equality, LawsAssumed laws,
                                      const Given& given) const {
  if (given.settings.empty()) return agree(equality, samples(laws)[sample]);
  const auto state = state_of(numbers_[static_cast<std::size_t>(laws)][sample], laws, given);
  return state ? agree(equality, *state) : std::nullopt;
}

bool Prover::is_defined(const Equality& stated, LawsAssumed laws, const Given& given) const {
  const std::optional<Equality> placed = in_places_of_a_state(stated, given);
  if (!placed) return false;
  const Equality equality = with_lengths_squared(*placed);
  for (std::size_t n = 0; n < samples(laws).size(); ++n)
    if (agrees_at(n, equality, laws, given)) return true;
  return false;
}

Verdict Prover::settle(const Equality& stated, LawsAssumed laws, const Given& given) const {
  const std::optional<Equality> placed = in_places_of_a_state(stated, given);
  if (!placed) return Verdict::undecided;
  const Equality equality = with_lengths_squared(*placed);
  int defined = 0;
  for (std::size_t n = 0; n < samples(laws).size(); ++n) {
    const std::optional<bool> agrees = agrees_at(n, equality, laws, given);
    if (!agrees) continue;
    if (!*agrees) return Verdict::fails;
    if (++defined < kSamples) continue;
    return agrees_at_its_own_points(equality, laws, given) ? confirmed(equality, laws, given)
                                                           : Verdict::fails;
  }
  return Verdict::undecided;
}

/// At points that depend on the claim's own text, so that no claim can be made up to agree at all of them.
bool Prover::agrees_at_its_own_points(const Equality& equality, LawsAssumed laws, const Given& given) const {
  constexpr int kOwnSamples = 2;
  std::uint64_t seed = hash_of(equality.left.text, hash_of(equality.right.text, kSeed));
  for (const Setting& setting : given.settings) seed = hash_of(setting.text, seed);
  std::mt19937_64 random(seed);
  for (int n = 0; n < kOwnSamples; ++n) {
    const auto state = state_of(random_numbers(random), laws, given);
    if (state && agree(equality, *state) == std::optional(false)) return false;
  }
  return true;
}

Verdict Prover::agree_in_series(const Equality& equality, LawsAssumed laws, const Given& given,
                                std::string& why) const {
  const int order = given.small.order;
  if (equality.left.nodes.size() + equality.right.nodes.size() > kMostExpandedNodes) {
    why = "its sides are too long to be expanded: they have more than " + std::to_string(kMostExpandedNodes) +
          " parts";
    return Verdict::undecided;
  }
  constexpr int kOwnSamples = 2;
  std::uint64_t seed = hash_of(equality.left.text, hash_of(equality.right.text, kSeed));
  for (const Setting& setting : given.settings) seed = hash_of(setting.text, seed);
  std::mt19937_64 random(seed);
  const bool says_zero =
      equality.left.type() == ExpressionType::zero || equality.right.type() == ExpressionType::zero;
  int defined = 0;
  bool are_zero = true;
  // As for what is exact: points of a fixed seed, and some that depend on the claim's own text.
  for (int n = 0; n < kMostSamples + kOwnSamples; ++n) {
    const bool is_own = n >= kMostSamples;
    if (!is_own && defined == kSamples) continue;
    const auto sides =
        expanded_sides(equality,
                       is_own ? random_numbers(random)
                              : numbers_[static_cast<std::size_t>(laws)][static_cast<std::size_t>(n)],
                       laws, given);
    if (!sides) continue;
    const OrderComparison comparison = compare_to_order(*sides, order);
    if (comparison.differ_at) return Verdict::fails;
    if (!comparison.is_known) {
      why = "so many terms cancel that it cannot be said what is left " + to_order(given);
      return Verdict::undecided;
    }
    are_zero = are_zero && comparison.are_zero;
    if (!is_own) ++defined;
  }
  if (defined < kSamples) return Verdict::undecided;
  if (are_zero && !says_zero) {
    why = "both sides are zero to that order: it says nothing";
    return Verdict::undecided;
  }
  const Degree degree = degree_of_difference(equality, given);
  if (std::max(degree.numerator, degree.denominator) >= kMostProvableDegree) return Verdict::undecided;
  const double bits = std::max(degree.numerator_bits, degree.denominator_bits);
  if (bits < kBitsOfOnePrime) return Verdict::holds;
  const auto wide = expanded_sides(equality, wide_, laws, given);
  if (!wide) return Verdict::undecided;
  const OrderComparison comparison = compare_to_order(*wide, order);
  if (comparison.differ_at) return Verdict::fails;
  return comparison.is_known && bits < kBitsOfBoth ? Verdict::holds : Verdict::undecided;
}

Judgement Prover::settle_in_series(const Equality& stated, LawsAssumed laws, const Given& given) const {
  const std::optional<Equality> placed = in_places_of_a_state(stated, given);
  if (!placed) return undecided();
  const Equality& equality = *placed;
  std::string why;
  const Verdict verdict = agree_in_series(equality, laws, given, why);
  if (verdict == Verdict::holds) return {};
  if (verdict == Verdict::undecided) {
    if (why.empty()) return undecided();
    const bool says_nothing = why.find("nothing") != why.npos;
    return {
        verdict,
        std::move(why),
        says_nothing ? "write 0 for one side, or claim a higher order" : "shorten it, or claim a lower order",
        {}};
  }
  int differ_at = given.small.order;
  auto counter = first_state_in_series(equality, laws, given, differ_at);
  std::string message = "this does not hold " + to_order(given);
  if (counter) message += ": the sides differ in the terms of ε^" + std::to_string(differ_at);
  return not_what_it_says(std::move(message), "", std::move(counter));
}

Verdict Prover::confirmed(const Equality& equality, LawsAssumed laws, const Given& given) const {
  const Degree degree = degree_of_difference(equality, given);
  if (degree.numerator >= kMostProvableDegree) return Verdict::undecided;
  const double bits = degree.numerator_bits;
  if (bits < kBitsOfOnePrime) return Verdict::holds;
  const auto state = state_of(wide_, laws, given);
  const std::optional<bool> agrees = state ? agree(equality, *state) : std::nullopt;
  if (agrees && !*agrees) return Verdict::fails;
  return agrees && bits < kBitsOfBoth ? Verdict::holds : Verdict::undecided;
}

Judgement Prover::settle_inequality(const ClaimLine& line, LawsAssumed laws, const Given& given) const {
  const bool is_upward = line.relation == Relation::greater || line.relation == Relation::greater_or_equal;
  const bool is_strict = line.relation == Relation::greater || line.relation == Relation::less;
  const std::optional<Equality> placed = in_places_of_a_state(line.equality, given);
  if (!placed) return undecided();
  const Equality& sides = *placed;
  const Equality larger_first = is_upward ? sides : Equality{sides.right, sides.left};
  if (is_never_less(larger_first, is_strict, laws, given)) return {};
  int tried = 0;
  auto counter = with_roots(
      first_whole_number_state(with_lengths_squared(sides), nullptr, laws, given, line.relation, &tried),
      sides);
  if (counter) return not_what_it_says("this does not hold", "", std::move(counter));
  if (tried == 0) return undecided();
  Judgement judgement;
  judgement.verdict = Verdict::not_refuted;
  judgement.states = tried;
  judgement.message = "no proof was found; it held in all of " + std::to_string(tried) + " states";
  return judgement;
}

std::optional<Counterexample> Prover::refute(const Equality& stated, LawsAssumed laws,
                                             const Given& given) const {
  const std::optional<Equality> placed = in_places_of_a_state(stated, given);
  if (!placed) return std::nullopt;
  const Equality& equality = *placed;
  return with_roots(first_whole_number_state(with_lengths_squared(equality), nullptr, laws, given), equality);
}

std::optional<Counterexample> Prover::refute_inference(const Equality& premise, const Equality& conclusion,
                                                       const Given& given) const {
  const Equality premise_squared = with_lengths_squared(premise);
  return with_roots(first_whole_number_state(with_lengths_squared(conclusion), &premise_squared,
                                             LawsAssumed::motion, given),
                    conclusion);
}

LawsAssumed laws_assumed_by(ClaimKind kind, const Given& given) {
  if (kind == ClaimKind::is_false && given.sets_torque()) return LawsAssumed::motion;
  switch (kind) {
    case ClaimKind::identity:
    case ClaimKind::definition:
      return LawsAssumed::identity;
    case ClaimKind::free:
    case ClaimKind::is_false:
      return LawsAssumed::free;
    default:
      return LawsAssumed::motion;
  }
}

namespace {

Judgement judge_as_its_kind(const ClaimLine& line, ClaimKind kind, const Prover& prover, const Given& given) {
  if (line.relation == Relation::approximate && !given.small.empty())
    return judge_approximation(line, kind, prover, given);
  if (line.conclusion && kind != ClaimKind::non_sequitur) return judge_implication(line, kind, prover, given);
  if (is_order(line.relation)) return judge_order(line, kind, prover, given);
  if (kind == ClaimKind::is_false) return judge_false(line, prover, given);
  if (kind == ClaimKind::non_sequitur) return judge_inference(line, prover, given);
  return judge_equality(line, kind, prover, given);
}

/// Exact arithmetic takes cos(acos(a)) for a, whatever a is: whether there is such an angle, states tell.
bool has_its_angles(const Equality& equality, LawsAssumed laws, const Given& given) {
  if (!equality.left.uses(Operation::acos) && !equality.right.uses(Operation::acos)) return true;
  int tried = 0;
  first_whole_number_state(with_lengths_squared(equality), nullptr, laws, given, Relation::equal, &tried);
  return tried > 0;
}

}  // namespace

Judgement judge(const ClaimLine& line, ClaimKind kind, const Prover& prover, const Given& given) {
  if (kind == ClaimKind::measured) return {};
  Judgement judgement = judge_as_its_kind(line, kind, prover, given);
  if (judgement.verdict != Verdict::holds) return judgement;
  const LawsAssumed laws = laws_assumed_by(kind, given);
  if (has_its_angles(line.equality, laws, given) &&
      (!line.conclusion || has_its_angles(*line.conclusion, laws, given)))
    return judgement;
  return {Verdict::undecided,
          "an angle in this was found in no state: its cosine is never between -1 and 1",
          "",
          {}};
}

}  // namespace polhode
