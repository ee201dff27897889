// SPDX-License-Identifier: MIT
#include "app/narration/verdict_row.h"

#include "base/words/verdict_words.h"
#include "lessons/claims/expressions/expression_tex.h"
#include "physics/method.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace polhode {

bool refutes(ClaimKind kind) { return kind == ClaimKind::is_false || kind == ClaimKind::non_sequitur; }

namespace {

Phrase word_of(ClaimKind kind) {
  switch (kind) {
    case ClaimKind::identity:
      return words::kAlwaysTrue;
    case ClaimKind::definition:
      return words::kDefinition;
    case ClaimKind::law:
      return words::kLaw;
    case ClaimKind::motion:
      return words::kTrueInEveryMotion;
    case ClaimKind::free:
      return words::kTrueWithoutTorque;
    case ClaimKind::is_false:
      return words::kFalse;
    case ClaimKind::measured:
      return words::kCheckedOnThisMotion;
    case ClaimKind::non_sequitur:
      return words::kDoesNotFollow;
  }
  return words::kLaw;
}

Certainty certainty_of(ClaimKind kind) {
  if (refutes(kind)) return Certainty::refuted;
  const bool is_stated =
      kind == ClaimKind::definition || kind == ClaimKind::law || kind == ClaimKind::measured;
  return is_stated ? Certainty::stated : Certainty::proved;
}

std::string how_it_is_computed(const Scene* scene, Language language) {
  if (!scene) return "";
  const MotionSpec& motion = scene->motion;
  const MethodFacts& facts = facts_of(motion.method.value_or(default_method(problem_of(*scene))));
  if (facts.control == StepControl::none) return std::string(words::kInClosedForm.in(language));
  if (facts.control == StepControl::fixed)
    return words::kWithMethodAndStep.with(language, {facts.name, fmt::format("{:g}", *motion.step_s)});
  return words::kWithMethodAndTolerance.with(
      language, {facts.name, fmt::format("{:g}", motion.tolerance.value_or(kDefaultTolerance))});
}

std::string joined(const std::string& words, const std::string& more) {
  return words.empty() ? more : more.empty() ? words : words + ", " + more;
}

std::string_view order_in_words(int order, Language language) {
  return words::kOrders.at(static_cast<std::size_t>(order - 1)).in(language);
}

/// "given $I_2 = I_1$, to first order in $\\omega_1$"; what is measured is not of an order: "for small …".
std::string words_of(const Given& given, ClaimKind kind, Language language) {
  const auto listed = [](const std::vector<std::string>& formulas, std::string words) {
    for (const std::string& tex : formulas) words += (&tex == &formulas.front() ? " $" : ", $") + tex + '$';
    return formulas.empty() ? std::string() : words;
  };
  const std::string order =
      given.small.empty() || kind == ClaimKind::measured
          ? std::string(words::kForSmall.in(language))
          : words::kToOrderIn.with(language, {order_in_words(given.small.order, language)});
  return joined(listed(printed_conditions(given), std::string(words::kGiven.in(language))),
                listed(printed_small(given), order));
}

/// What is true of other motions than the one beside it does not stand there as if it were of that, too.
std::string why_not_of_this(ClaimKind kind, const Scene& scene, Language language) {
  const bool is_of_motions = kind == ClaimKind::free || kind == ClaimKind::motion || kind == ClaimKind::law;
  if (is_of_motions && loses_energy_inside(scene)) return std::string(words::kNotOfThisBody.in(language));
  return kind == ClaimKind::free && !scene.torque.empty() ? std::string(words::kHereOneActs.in(language))
                                                          : "";
}

/// The words of a state, which are English beside its formulas.
std::string state_in(const Counterexample& counter, Language language) {
  std::string state = counter.state_tex;
  for (const Phrase& phrase : {words::kAnyState, words::kAttitude}) {
    const std::string_view english = phrase.in(Language::en);
    if (const std::size_t at = state.find(english); at != state.npos)
      state.replace(at, english.size(), phrase.in(language));
  }
  return state;
}

/// Of what is false, or does not follow.
std::string words_of(const Counterexample& counter, ClaimKind kind, Language language) {
  const std::string sides =
      fmt::format("${} \\ne {}$", numbers_as_tex(counter.left), numbers_as_tex(counter.right));
  if (kind == ClaimKind::non_sequitur)
    return words::kPremiseHolds.with(language, {state_in(counter, language), sides});
  return words::kForExampleAt.with(language, {state_in(counter, language), sides});
}

/// Numbers of a row: two or three digits of the largest component, a factor of ten set apart where it is not
/// near 1. What is nothing beside the terms it comes from is 0.
class SideText {
 public:
  explicit SideText(const std::vector<LiveValue>& values) : is_vector_(values.front().is_vector) {
    constexpr double kNothing = 1e-6;
    double largest = 0, size = 0;
    for (const LiveValue& value : values) {
      size = std::max(size, value.size);
      for (const auto& side : {value.left, value.right})
        for (const double x : side) largest = std::max(largest, std::abs(x));
    }
    is_nothing_ = largest <= kNothing * size;
    const int exponent = is_nothing_ ? 0 : static_cast<int>(std::floor(std::log10(largest)));
    if (exponent < -1 || exponent > 2) factor_ = exponent;
    decimals_ = std::clamp(2 - (exponent - factor_), 0, 2);
  }

  /// Whether two sides differ by no more than the last digit that is printed.
  bool are_alike(const std::array<double, 3>& a, const std::array<double, 3>& b) const {
    const double last = std::pow(10.0, factor_ - decimals_);
    for (std::size_t i = 0; i < 3; ++i)
      if (!(std::abs(a[i] - b[i]) <= last)) return is_nothing_;
    return true;
  }

  /// Every side is 0, or no more than rounding beside its terms.
  bool is_nothing() const { return is_nothing_; }

  std::string operator()(const std::array<double, 3>& side) const {
    if (is_nothing_ || side == std::array<double, 3>{}) return "0";
    const std::string tail = factor_ == 0 ? "" : fmt::format("${{\\cdot}}10^{{{}}}$", factor_);
    if (!is_vector_) return number(side[0]) + tail;
    return fmt::format("({}, {}, {}){}", number(side[0]), number(side[1]), number(side[2]), tail);
  }

 private:
  std::string number(double value) const {
    std::string text = fmt::format("{:.{}f}", value / std::pow(10.0, factor_), decimals_);
    if (text.find_first_not_of("-0.") == std::string::npos) return "0";
    return text.front() == '-' ? "−" + text.substr(1) : text;
  }

  bool is_vector_;
  bool is_nothing_ = false;
  int factor_ = 0, decimals_ = 2;
};

/// The lines of one equation: those of a chain follow each other.
using ChainLines = std::vector<const ClaimLine*>;

bool is_zero(const Expression& side) { return side.type() == ExpressionType::zero; }

/// The equations of a claim that get numbers.
std::vector<ChainLines> chains_of(const Claim& claim) {
  std::vector<ChainLines> chains;
  for (const ClaimLine& line : claim.lines) {
    if (!line.is_side_by_side) continue;
    if (!line.goes_on || chains.empty()) chains.emplace_back();
    chains.back().push_back(&line);
  }
  std::erase_if(chains, [&](const ChainLines& chain) {
    const auto says_zero = [](const ClaimLine* line) {
      return is_zero(line->equality.left) || is_zero(line->equality.right);
    };
    return claim.kind != ClaimKind::is_false && std::any_of(chain.begin(), chain.end(), says_zero);
  });
  if (chains.size() > kMostLiveRows) chains.clear();
  return chains;
}

std::string frame_of(bool is_vector, View view) {
  return !is_vector ? "" : view == View::space ? "in $S$ " : "in $S^*$ ";
}

/// What is called approximately equal differs by no more than a tenth of the larger side.
bool are_near(const LiveValue& value) {
  constexpr double kNear = 0.1;
  double apart = 0, left = 0, right = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    apart = std::hypot(apart, value.left[i] - value.right[i]);
    left = std::hypot(left, value.left[i]);
    right = std::hypot(right, value.right[i]);
  }
  return apart <= kNear * std::max(left, right);
}

struct Row {
  std::string text;  ///< "5.18 = 5.18 = 5.18"; empty if a side has no value, or the step is too long to tell
  bool is_nothing = true;  ///< "0 = 0", or no text
};

Row row_of(const ChainLines& chain, bool refutes, const LiveState& live, View view) {
  std::vector<LiveValue> values;
  for (const ClaimLine* line : chain) {
    const auto value = live_value(*line, live, view);
    if (!value || value->tolerance > kDecisive) return {};
    values.push_back(*value);
  }
  const SideText side(values);
  std::string left = side(values.front().left);
  std::string text = frame_of(values.front().is_vector, view) + left;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const LiveValue& value = values[i];
    const ClaimLine& line = *chain[i];
    const bool is_equal = line.relation == Relation::equal;
    const bool apart = value.residual > value.tolerance;
    // What is equal is printed equal, whichever way the last digit was rounded; what is so within a tolerance
    // of the author's own, or is not known better than to that, has the two numbers it has.
    const bool is_one_number = is_equal && !apart && !line.within && value.right != std::array<double, 3>{} &&
                               side.are_alike(value.left, value.right);
    std::string right = is_one_number ? left : side(value.right);
    const bool is_rough = is_equal && !apart && right != left;
    if (refutes && !apart) return {};  // of inequalities too: whether one fails here is not said
    const bool is_far = line.relation == Relation::approximate && !are_near(value) && left != right;
    text += (apart || is_far ? " ≠ "
             : is_rough      ? " ≈ "
                             : ' ' + std::string(sign_of(line.relation)) + ' ') +
            right;
    left = right;
  }
  return {text, side.is_nothing()};
}

/// "to within 0.9 %": the roughest of the tolerances that the author gave; empty where there is none.
std::string within_of(const Claim& claim, Language language) {
  double within = 0;
  for (const ClaimLine& line : claim.lines) within = std::max(within, line.within.value_or(0.0));
  return within == 0 ? "" : words::kToWithin.with(language, {fmt::format("{:.2g}", 100.0 * within)});
}

/// Why a measured claim fails on its motion; nothing if it holds.
std::optional<std::string> why_not_measured(const Claim& claim, const SceneModel& model, Language language) {
  for (const ClaimLine& line : claim.lines) {
    const auto measured = measure(line.equality, line.within, model, claim.given);
    if (!measured) return std::string(words::kHasNoValue.in(language));
    if (measured->tolerance > kDecisive) return std::string(words::kStepTooLong.in(language));
    if (!measured->decides()) return std::string(words::kTermsCancel.in(language));
    if (!measured->holds()) return words::kFailsAt.with(language, {fmt::format("{:.3g}", measured->t_s)});
  }
  return std::nullopt;
}

Phrase claimed_is(const Claim& claim, Certainty certainty) {
  if (claim.origin == Claim::Origin::part) return words::kInPart;
  if (certainty == Certainty::proved) return words::kProved;
  if (certainty == Certainty::stated)
    return claim.kind == ClaimKind::measured ? words::kChecked : words::kStated;
  return words::kClaimed;
}

VerdictRow verdict_on(const Claim& claim, const Scene* scene, const SceneModel* model, Language language) {
  VerdictRow row{.claim = &claim,
                 .certainty = certainty_of(claim.kind),
                 .word = std::string(word_of(claim.kind).in(language)),
                 .note = words_of(claim.given, claim.kind, language),
                 .claimed = {}};
  const auto is_instead = [&](Certainty certainty, const Phrase& word, std::string note) {
    row.certainty = certainty;
    row.word = word.in(language);
    row.note = std::move(note);
  };
  if (scene != nullptr) row.note = joined(row.note, why_not_of_this(claim.kind, *scene, language));
  std::optional<Counterexample> counter;
  bool holds = true;
  int states = 0;  // in which what is not refuted held, the fewest of a line; 0: there is no such line
  for (const ClaimLine& line : claim.lines) {
    if (line.judgement && line.judgement->verdict == Verdict::not_refuted)
      states = states == 0 ? line.judgement->states : std::min(states, line.judgement->states);
    holds = holds && line.judgement && line.judgement->verdict == Verdict::holds;
    if (!counter && line.judgement) counter = line.judgement->counterexample;
    if (claim.origin != Claim::Origin::formula) row.claimed.push_back(line.tex);
  }
  if (!holds && counter)
    is_instead(Certainty::refuted, words::kDoesNotHold, to_string(*counter));
  else if (states > 0)
    is_instead(Certainty::open, words::kNotProved,
               words::kNotRefuted.with(language, {std::to_string(states)}));
  else if (!holds)
    is_instead(Certainty::open, words::kNotProved, "");
  else if (refutes(claim.kind) && counter)
    row.example = words_of(*counter, claim.kind, language);
  // "A does not give B" is what the formula says, and it is right.
  if (holds && claim.kind == ClaimKind::non_sequitur && claim.origin == Claim::Origin::formula) {
    row.certainty = Certainty::proved;
    row.word = words::kAnExampleShowsIt.in(language);
  }
  if (claim.kind != ClaimKind::measured || !holds) return row;
  if (scene == nullptr) {
    is_instead(Certainty::open, words::kNotConfirmed, std::string(words::kNoMotionHere.in(language)));
    return row;
  }
  row.note = joined(joined(how_it_is_computed(scene, language), within_of(claim, language)), row.note);
  if (const auto why = model ? why_not_measured(claim, *model, language) : std::nullopt)
    is_instead(Certainty::open, words::kNotConfirmed, *why);
  return row;
}

}  // namespace

VerdictRow verdict_row(const Claim& claim, const Scene* scene, const SceneModel* model, Language language) {
  VerdictRow row = verdict_on(claim, scene, model, language);
  row.claimed_is = claimed_is(claim, row.certainty).in(language);
  for (std::string* text : {&row.note, &row.example}) *text = with_decimals(std::move(*text), language);
  return row;
}

std::vector<std::string> widest_live_rows(const Claim& claim, Language language) {
  std::vector<std::string> rows;
  for (const ChainLines& chain : chains_of(claim)) {
    const bool is_vector = chain.front()->equality.is_vector();
    const std::string side = is_vector ? "(−0.00, −0.00, −0.00)" : "−0.00${\\cdot}10^{-4}$";
    std::string row = frame_of(is_vector, View::body) + side;
    for (std::size_t i = 0; i < chain.size(); ++i) row += " = " + side;
    rows.push_back(with_decimals(std::move(row), language));
  }
  return rows;
}

std::vector<std::string> live_rows(const Claim& claim, const LiveState& live, View view, Language language) {
  const auto value = holds_on(claim.given, live) ? live_value(claim, live, view) : std::nullopt;
  if (!value) return {};
  const bool refutes = claim.kind == ClaimKind::is_false;
  if (value->tolerance > kDecisive)
    return refutes ? std::vector<std::string>()
                   : std::vector<std::string>{std::string(words::kStepTooLong.in(language))};
  std::vector<std::string> rows;
  bool all_are_nothing = true;
  for (const ChainLines& chain : chains_of(claim)) {
    Row row = row_of(chain, refutes, live, view);
    all_are_nothing = all_are_nothing && row.is_nothing;
    rows.push_back(with_decimals(std::move(row.text), language));
  }
  // 0 = 0 alone tells nothing, as where no torque acts; beside others it says which of them it is.
  if (all_are_nothing && !refutes) rows.assign(rows.size(), "");
  return rows;
}

}  // namespace polhode
