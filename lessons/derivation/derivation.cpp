// SPDX-License-Identifier: MIT
#include "lessons/derivation/derivation.h"

#include "base/utf8.h"
#include "lessons/claims/expressions/expression_builder.h"
#include "lessons/claims/expressions/expression_variants.h"
#include "lessons/derivation/decided.h"
#include "lessons/derivation/slips.h"

#include <algorithm>
#include <array>

namespace polhode {
namespace {

using Mark = LineJudgement::Mark;

constexpr std::array<std::pair<Slip, std::string_view>, 17> kSlipNames{{{Slip::none, ""},
                                                                        {Slip::kind, "kind"},
                                                                        {Slip::signs, "signs"},
                                                                        {Slip::sign, "sign"},
                                                                        {Slip::transport, "transport"},
                                                                        {Slip::missing, "missing"},
                                                                        {Slip::extra, "extra"},
                                                                        {Slip::index, "index"},
                                                                        {Slip::frame, "frame"},
                                                                        {Slip::rate, "rate"},
                                                                        {Slip::inertia, "inertia"},
                                                                        {Slip::power, "power"},
                                                                        {Slip::factor, "factor"},
                                                                        {Slip::indices, "indices"},
                                                                        {Slip::torque, "torque"},
                                                                        {Slip::law, "law"},
                                                                        {Slip::other, "other"}}};

/// left − right, times a number; nothing where the sides do not fit together.
std::optional<Expression> difference(const Equality& equality, int above = 1, int below = 1) {
  try {
    ExpressionBuilder builder;
    const int left = builder.insert(equality.left, 0, 0), right = builder.insert(equality.right, 0, 0);
    builder.add(Operation::subtract, left, right, 0);
    Expression whole{equality.left.text + " - (" + equality.right.text + ')', builder.take(),
                     equality.left.constants ? equality.left.constants : equality.right.constants};
    return above == 1 && below == 1 ? whole : times(std::move(whole), above, below);
  } catch (const ExpressionFault&) {
    return std::nullopt;
  }
}

/// Whether two equations say the same, but for a number as a factor, for every body, ω, ω̇ and N.
bool say_the_same(const Equality& a, const Equality& b, const Given& given, const Prover& prover) {
  const auto left = difference(a);
  if (!left) return false;
  constexpr std::array<std::pair<int, int>, 10> kFactors{
      {{1, 1}, {-1, 1}, {2, 1}, {-2, 1}, {1, 2}, {-1, 2}, {3, 1}, {-3, 1}, {4, 1}, {-4, 1}}};
  for (const auto& [above, below] : kFactors) {
    auto right = difference(b, above, below);
    if (!right || !fit(left->type(), right->type())) return false;
    if (prover.settle({*left, std::move(*right)}, LawsAssumed::identity, given) == Verdict::holds)
      return true;
  }
  return false;
}

/// All that a line says: its links, and its ends.
std::vector<Equality> said_by(const DerivedLine& line) {
  std::vector<Equality> all = line.links;
  all.push_back(line.whole);
  return all;
}

std::set<std::string> letters_in(const std::vector<Equality>& equalities) {
  std::set<std::string> letters;
  for (const Equality& equality : equalities)
    for (const Expression* side : {&equality.left, &equality.right})
      letters.merge(polhode::letters_in(*side));
  return letters;
}

bool has_torque(const Equality& equality) {
  for (const Quantity N : {Quantity::N, Quantity::N1, Quantity::N2, Quantity::N3})
    if (equality.left.uses(N) || equality.right.uses(N)) return true;
  return false;
}

LineJudgement marked(Mark mark, std::string reason, std::string hint = {}) {
  LineJudgement judgement;
  judgement.mark = mark;
  judgement.reason = std::move(reason);
  judgement.hint = std::move(hint);
  return judgement;
}

class Judge {
 public:
  Judge(const Derivation& derivation, const std::vector<DerivedLine>& before, const LineNotation& how,
        const Prover& prover)
      : derivation_(derivation), before_(before), how_(how), prover_(prover) {}

  LineJudgement judge(const DerivedLine& line) const {
    for (const Equality& link : line.links) {
      if (!is_provable(link)) return without_proof(link);
      const Verdict verdict = settle(link, derivation_.laws);
      if (verdict == Verdict::holds) continue;
      if (verdict == Verdict::undecided)
        return prover_.is_defined(link, derivation_.laws, derivation_.given)
                   ? marked(Mark::unreadable, "its numbers become too large to be judged",
                            "write it with smaller powers")
                   : marked(Mark::unreadable, "this is nowhere defined", "is something divided by 0?");
      return wrong(link);
    }
    for (const Equality& link : line.links)
      if (!is_decided(link, derivation_, prover_)) return undecided(link);
    if (is_goal(derivation_, line, prover_)) return marked(Mark::goal, "");
    return useful(line);
  }

 private:
  Verdict settle(const Equality& link, LawsAssumed laws) const {
    return prover_.settle(link, laws, derivation_.given);
  }

  /// In motions with a torque its sides are not 0, and a slip shows.
  LineJudgement undecided(const Equality& link) const {
    LineJudgement judgement =
        marked(Mark::away, "true, but both sides are 0 here: this line does not decide the factor");
    const bool is_one_term = settle({link.left, zero_expression()}, derivation_.laws) != Verdict::holds;
    if (is_one_term) judgement.reason = "true, but a term is 0 here: this line does not decide its factor";
    const FoundSlip found = find_slip(
        link, possible_terms(),
        [&](const Equality& mended) { return settle(mended, LawsAssumed::motion) == Verdict::holds; },
        how_.notation->vocabulary);
    if (found.slip != Slip::other && found.slip != Slip::extra)
      judgement.hint = "with a torque it would fail: " + found.reason;
    return judgement;
  }

  LineJudgement useful(const DerivedLine& line) const {
    const std::vector<Equality> said = said_by(line);
    std::vector<CanonicalForm> forms;
    for (const Equality& equality : said)
      if (CanonicalForm form = canonical_form(equality); !form.empty()) forms.push_back(std::move(form));
    if (forms.empty()) return marked(Mark::away, "true, but both sides are the same");
    const auto is_said_by = [&](const DerivedLine& other) {
      const std::vector<Equality> known = said_by(other);
      return std::all_of(forms.begin(), forms.end(), [&](const CanonicalForm& form) {
        return std::any_of(known.begin(), known.end(),
                           [&](const Equality& old) { return canonical_form(old) == form; });
      });
    };
    if (is_said_by(derivation_.start)) return marked(Mark::away, "true: it is the line to start from");
    if (std::any_of(derivation_.facts.begin(), derivation_.facts.end(), is_said_by))
      return marked(Mark::away, "true: it is among what you may use");
    if (std::any_of(before_.begin(), before_.end(), is_said_by))
      return marked(Mark::away, "true, but it says what a line above says already");
    for (const std::string& letter : letters_in(said))
      if (letter != "e" && !derivation_.letters.contains(letter))
        return marked(Mark::away,
                      "true, but " + shown(letter) + " leads away: the goal does not speak of it");
    return {};
  }

  static std::string shown(const std::string& letter) { return letter == "omega" ? "ω" : letter; }

  FoundSlip slip_in(const Equality& link) const {
    return find_slip(
        link, possible_terms(),
        [&](const Equality& mended) { return settle(mended, derivation_.laws) == Verdict::holds; },
        how_.notation->vocabulary);
  }

  /// Of lengths that stand in sums nothing can be proved; but it may be seen that squares are forgotten.
  LineJudgement without_proof(const Equality& link) const {
    FoundSlip found = slip_in(link);
    if (found.slip == Slip::other)
      return marked(Mark::unreadable, "roots and angles are not judged here", "square both sides");
    LineJudgement judgement = marked(Mark::wrong, std::move(found.reason));
    judgement.slip = found.slip;
    return judgement;
  }

  LineJudgement wrong(const Equality& link) const {
    LineJudgement judgement = marked(Mark::wrong, "this does not hold");
    judgement.slip = Slip::other;
    judgement.counterexample = prover_.refute(link, derivation_.laws, derivation_.given);
    const bool is_identity = derivation_.laws == LawsAssumed::identity;
    if (is_identity && settle(link, LawsAssumed::motion) == Verdict::holds) {
      judgement.slip = Slip::law;
      judgement.reason = "this follows from Euler's law; here it has to hold whatever ω̇ is";
      return judgement;
    }
    const bool may_lack_torque =
        derivation_.laws == LawsAssumed::motion && !derivation_.given.sets_torque() && !has_torque(link);
    const bool vanishes = settle({link.right, zero_expression()}, LawsAssumed::free) == Verdict::holds &&
                          link.right.type() != ExpressionType::zero;
    if (may_lack_torque && !vanishes && settle(link, LawsAssumed::free) == Verdict::holds) {
      judgement.slip = Slip::torque;
      judgement.reason = "this is true without torque only";
      return judgement;
    }
    const FoundSlip found = slip_in(link);
    judgement.slip = found.slip;
    if (!found.reason.empty()) judgement.reason = found.reason;
    return judgement;
  }

  /// Terms of the lines above, of the goal, and those that are often forgotten.
  std::vector<std::string> possible_terms() const {
    std::vector<std::string> terms = {"N", "N1", "N2", "N3", "dot(omega, N)"};
    const auto add = [&](const Equality& equality) {
      for (const Expression* side : {&equality.left, &equality.right}) {
        std::vector<int> summands = summands_of(*side);
        if (summands.empty()) summands.push_back(static_cast<int>(side->nodes.size()) - 1);
        for (const int summand : summands) {
          const ExpressionNode& n = side->nodes[static_cast<std::size_t>(summand)];
          if (n.end > n.begin && n.end <= side->text.size())
            terms.push_back(side->text.substr(n.begin, n.end - n.begin));
        }
      }
    };
    for (const Equality& equality : said_by(derivation_.goal)) add(equality);
    for (const Equality& equality : said_by(derivation_.start)) add(equality);
    for (const WorkedLine& worked : derivation_.worked)
      for (const Equality& equality : said_by(worked.line)) add(equality);
    for (const DerivedLine& line : before_)
      for (const Equality& equality : said_by(line)) add(equality);
    std::sort(terms.begin(), terms.end());
    terms.erase(std::unique(terms.begin(), terms.end()), terms.end());
    return terms;
  }

  const Derivation& derivation_;
  const std::vector<DerivedLine>& before_;
  const LineNotation& how_;
  const Prover& prover_;
};

}  // namespace

std::set<std::string> letters_of(const Derivation& derivation) {
  std::vector<Equality> all = said_by(derivation.start);
  const auto add = [&all](const DerivedLine& line) {
    const std::vector<Equality> said = said_by(line);
    all.insert(all.end(), said.begin(), said.end());
  };
  add(derivation.goal);
  for (const DerivedLine& fact : derivation.facts) add(fact);
  for (const WorkedLine& worked : derivation.worked) add(worked.line);
  return letters_in(all);
}

std::string_view name_of(Slip slip) {
  return std::find_if(kSlipNames.begin(), kSlipNames.end(),
                      [slip](const auto& row) { return row.first == slip; })
      ->second;
}

std::string_view name_of(Mark mark) {
  switch (mark) {
    case Mark::holds:
      return "holds";
    case Mark::goal:
      return "goal";
    case Mark::away:
      return "leads away";
    case Mark::wrong:
      return "wrong";
    case Mark::unreadable:
      return "unreadable";
  }
  return "";
}

Result<DerivedLine, UnreadableLine> read_line(std::string_view typed, const LineNotation& how,
                                              const DerivedLine* above) {
  const TypedFormula formula = typed_formula(typed, how.names);
  const auto refuse = [&](std::string message, std::string hint, std::size_t at, bool of_kinds = false) {
    const int column = 1 + count_characters(typed.substr(0, std::min(at, typed.size())));
    return Failure<UnreadableLine>{{std::move(message), std::move(hint), column, formula.tex, of_kinds}};
  };
  if (formula.fault) return refuse(formula.fault->message, formula.fault->hint, formula.fault->at);
  if (typed.find_first_of("=<>") == typed.npos)
    return refuse("a line is an equation, with =",
                  above != nullptr ? "begin it with = to go on from the line above" : "", 0);
  const auto math = parse_math(formula.tex, how.macros);
  if (!math)
    return refuse(math.error().front().message, "", typed_offset(formula, math.error().front().offset));
  std::optional<Math> above_math;
  if (formula.goes_on) {
    if (above == nullptr) return refuse("there is no line above that this goes on from", "", 0);
    if (auto set = parse_math(above->tex, how.macros)) above_math = std::move(*set);
  }
  const auto read = read_equation(*math, *how.notation, above_math ? &*above_math : nullptr);
  if (!read)
    return refuse(read.error().reason, read.error().hint, typed_offset(formula, read.error().place.begin),
                  read.error().of_kinds);
  if (read->sentences.size() != 1 || read->is_tempting || read->has_condition)
    return refuse("a line is one equation", "write the next one below", 0);
  DerivedLine line{std::string(typed), formula.tex, {}, {}};
  for (const EquationLink& link : read->sentences.front().links) {
    if (link.relation != Relation::equal) return refuse("a line is an equation, with =", "", 0);
    line.links.push_back(link.equality);
  }
  line.whole = {formula.goes_on ? above->whole.left : line.links.front().left, line.links.back().right};
  return line;
}

bool is_goal(const Derivation& derivation, const DerivedLine& line, const Prover& prover) {
  const Equality& goal = derivation.goal.whole;
  const Words words = words_of(goal);
  const CanonicalForm form = expanded_form(goal);
  // What holds for all bodies and states is the same as any other such line: of that only its form can tell.
  const bool is_identity = derivation.laws == LawsAssumed::identity;
  const std::vector<Equality> said = said_by(line);
  return std::any_of(said.begin(), said.end(), [&](const Equality& equality) {
    if (!words.contains(words_of(equality)) || canonical_form(equality).empty()) return false;
    return expanded_form(equality) == form ||
           (!is_identity && say_the_same(equality, goal, derivation.given, prover));
  });
}

std::size_t next_worked(const Derivation& derivation, const std::vector<DerivedLine>& lines) {
  std::size_t next = 0;
  for (std::size_t i = 0; i < derivation.worked.size(); ++i) {
    const std::vector<Equality> sought = said_by(derivation.worked[i].line);
    for (const DerivedLine& line : lines)
      for (const Equality& equality : said_by(line))
        if (std::any_of(sought.begin(), sought.end(),
                        [&](const Equality& one) { return canonical_form(one) == canonical_form(equality); }))
          next = i + 1;
  }
  return next;
}

LineJudgement judge_line(const Derivation& derivation, const std::vector<DerivedLine>& before,
                         std::string_view typed, const LineNotation& how, const Prover& prover) {
  auto line = read_line(typed, how, before.empty() ? &derivation.start : &before.back());
  if (!line) {
    const UnreadableLine& fault = line.error();
    LineJudgement judgement =
        marked(fault.of_kinds ? Mark::wrong : Mark::unreadable, fault.message, fault.hint);
    judgement.slip = fault.of_kinds ? Slip::kind : Slip::none;
    judgement.column = fault.column;
    judgement.tex = fault.tex;
    return judgement;
  }
  LineJudgement judgement = Judge(derivation, before, how, prover).judge(*line);
  judgement.tex = line->tex;
  judgement.line = std::move(*line);
  return judgement;
}

}  // namespace polhode
