// SPDX-License-Identifier: MIT
#include "tests/oracle/rewriting.h"

#include <map>

namespace polhode::oracle {
namespace {

using Holes = std::map<std::string, Term>;

/// from → to. Unless the law is `literal`, A, v and F stand for any vectors and m, Jxx and Jyy for any
/// scalars; those that `from` does not name are made up.
struct Law {
  LawsAssumed assumption;
  bool literal;
  Term from, to;
};

constexpr auto kAlways = LawsAssumed::identity;

std::vector<Law> laws() {
  struct Text {
    const char *from, *to;
  };
  const std::vector<Text> kGeneral = {
      {"m + Jxx", "Jxx + m"},
      {"m - Jxx", "-(Jxx - m)"},
      {"m*Jxx", "Jxx*m"},
      {"m", "m + Jxx - Jxx"},
      {"m", "(m*Jxx)/Jxx"},
      {"m", "2*m - m"},
      {"m", "m/4 + 0.75*m"},
      {"m*(Jxx + Jyy)", "m*Jxx + m*Jyy"},
      {"m*(Jxx - Jyy)", "m*Jxx - m*Jyy"},
      {"(m + Jxx)^2", "m^2 + 2*m*Jxx + Jxx^2"},
      {"m^2", "m*m"},
      {"m^3", "m*m^2"},
      {"m/Jxx", "m*Jxx^(-1)"},
      {"A + v", "v + A"},
      {"A - v", "-(v - A)"},
      {"A", "A + F - F"},
      {"A", "(m*A)/m"},
      {"A", "comp(A, 1)*e1 + comp(A, 2)*e2 + comp(A, 3)*e3"},
      {"m*(A + v)", "m*A + m*v"},
      {"(m + Jxx)*A", "m*A + Jxx*A"},
      {"cross(A, v)", "-cross(v, A)"},
      {"cross(A, v)", "cross(A, v + m*A)"},
      {"cross(A + v, F)", "cross(A, F) + cross(v, F)"},
      {"cross(A, cross(v, F))", "dot(A, F)*v - dot(A, v)*F"},
      {"cross(A, v)", "cross(A, v) + cross(A, cross(v, F)) + cross(v, cross(F, A)) + cross(F, cross(A, v))"},
      {"dot(A, v)", "dot(v, A)"},
      {"dot(A, v)", "comp(A, 1)*comp(v, 1) + comp(A, 2)*comp(v, 2) + comp(A, 3)*comp(v, 3)"},
      {"dot(A, v)", "(norm2(A + v) - norm2(A - v))/4"},
      {"dot(A, cross(v, F))", "dot(cross(A, v), F)"},
      {"dot(A, cross(v, F))", "dot(v, cross(F, A))"},
      {"dot(A, cross(A, v))", "0*m"},
      {"norm2(A)", "dot(A, A)"},
      {"norm2(cross(A, v))", "norm2(A)*norm2(v) - dot(A, v)^2"},
      {"norm2(A + v)", "norm2(A) + 2*dot(A, v) + norm2(v)"},
      {"comp(A, 2)", "dot(e2, A)"},
      {"comp(A + v, 1)", "comp(A, 1) + comp(v, 1)"},
      {"comp(cross(A, v), 1)", "comp(A, 2)*comp(v, 3) - comp(A, 3)*comp(v, 2)"},
      {"comp(cross(A, v), 3)", "comp(A, 1)*comp(v, 2) - comp(A, 2)*comp(v, 1)"},
      {"inertia(A)", "I1*comp(A, 1)*e1 + I2*comp(A, 2)*e2 + I3*comp(A, 3)*e3"},
      {"inertia(A + v)", "inertia(A) + inertia(v)"},
      {"inertia(m*A)", "m*inertia(A)"},
      {"dot(A, inertia(v))", "dot(inertia(A), v)"},
      {"dot(A, apply(J, v))", "dot(apply(J, A), v)"},
      {"apply(J, A + v)", "apply(J, A) + apply(J, v)"},
      // Jxx would stand for any scalar here.
      {"comp(apply(J, A), 1)", "dot(e1, apply(J, e1))*comp(A, 1) + Jxy*comp(A, 2) + Jxz*comp(A, 3)"},
      {"ddt(A)", "star(A) + cross(omega, A)"},
      {"star(A)", "ddt(A) - cross(omega, A)"},
      {"ddt(A + v)", "ddt(A) + ddt(v)"},
      {"ddt(m*A)", "ddt(m)*A + m*ddt(A)"},
      {"ddt(cross(A, v))", "cross(ddt(A), v) + cross(A, ddt(v))"},
      {"star(cross(A, v))", "cross(star(A), v) + cross(A, star(v))"},
      {"ddt(dot(A, v))", "dot(star(A), v) + dot(A, star(v))"},
      {"ddt(dot(A, v))", "dot(ddt(A), v) + dot(A, ddt(v))"},
      {"ddt(norm2(A))", "2*dot(A, star(A))"},
      {"ddt(m*Jxx)", "ddt(m)*Jxx + m*ddt(Jxx)"},
      {"ddt(m^3)", "3*m^2*ddt(m)"},
      {"ddt(m/Jxx)", "(ddt(m)*Jxx - m*ddt(Jxx))/Jxx^2"},
      {"star(inertia(A))", "inertia(star(A))"},
      {"star(apply(J, A))", "apply(J, star(A))"},
      {"ddt(inertia(A))", "inertia(star(A)) + cross(omega, inertia(A))"},
  };
  const std::vector<Text> kNamed = {
      {"T", "dot(omega, L)/2"},
      {"T", "(I1*w1^2 + I2*w2^2 + I3*w3^2)/2"},
      {"L", "inertia(omega)"},
      {"omega", "w1*e1 + w2*e2 + w3*e3"},
      {"p", "m*v"},
      {"w1", "dot(omega, e1)"},
      {"w2", "comp(L, 2)/I2"},
      {"w3", "comp(omega, 3)"},
      {"dw1", "comp(star(omega), 1)"},
      {"dw2", "comp(ddt(omega), 2)"},
      {"I1", "dot(e1, inertia(e1))"},
      {"I3", "norm2(inertia(e3))/I3"},
      {"Jxy", "dot(e1, apply(J, e2))"},
      {"Jzz", "trace(J) - Jxx - Jyy"},
      {"trace(J)", "Jxx + Jyy + Jzz"},
      {"N", "N1*e1 + N2*e2 + N3*e3"},
      {"N3", "comp(N, 3)"},
      {"e1", "cross(e2, e3)"},
      {"e2", "cross(e3, e1)"},
      {"e3", "cross(e1, e2)"},
      {"ddt(e2)", "w3*(-e1) + w1*e3"},
      {"ddt(w1)", "dw1"},
      {"ddt(omega)", "star(omega)"},
      {"ddt(T)", "dot(omega, inertia(star(omega)))"},
      {"star(omega)", "dw1*e1 + dw2*e2 + dw3*e3"},
      {"ez", "cross(ex, ey)"},
      {"ey", "dot(ey, e1)*e1 + dot(ey, e2)*e2 + dot(ey, e3)*e3"},
  };
  const std::vector<Text> kMotion = {
      {"N", "ddt(L)"},
      {"N", "inertia(star(omega)) + cross(omega, L)"},
      {"N1", "I1*dw1 + w2*w3*(I3 - I2)"},
      {"N2", "I2*dw2 + w3*w1*(I1 - I3)"},
      {"N3", "I3*dw3 + w1*w2*(I2 - I1)"},
      {"dw2", "(N2 - w3*w1*(I1 - I3))/I2"},
      {"dw3", "(N3 + w1*w2*(I1 - I2))/I3"},
      {"ddt(L)", "N"},
      {"ddt(T)", "dot(N, omega)"},
      {"F", "ddt(p)"},
      {"F", "m*ddt(v)"},
      {"ddt(p)", "F"},
  };
  const std::vector<Text> kFree = {
      {"N", "cross(N, L)"},          {"N1", "0*m"},
      {"ddt(L)", "ddt(T)*L"},        {"star(L)", "cross(L, omega)"},
      {"dw1", "w2*w3*(I2 - I3)/I1"}, {"T", "T + ddt(T)"},
      {"ddt(T)", "ddt(norm2(L))"},
  };
  std::vector<Law> laws;
  const auto take = [&laws](const std::vector<Text>& texts, LawsAssumed assumption, bool literal) {
    for (const Text& law : texts)
      laws.push_back({assumption, literal, term_from(law.from), term_from(law.to)});
  };
  take(kGeneral, kAlways, false);
  take(kNamed, kAlways, true);
  take(kMotion, LawsAssumed::motion, true);
  take(kFree, LawsAssumed::free, true);
  return laws;
}

bool is_hole(const Term& term) {
  const std::string& w = term.word;
  return w == "A" || w == "v" || w == "F" || w == "m" || w == "Jxx" || w == "Jyy";
}

bool match(const Term& pattern, const Term& term, Holes& holes) {
  if (is_hole(pattern)) {
    if (is_vector(pattern) != is_vector(term)) return false;
    const auto [hole, fresh] = holes.try_emplace(pattern.word, term);
    return fresh || hole->second == term;
  }
  if (pattern.operation != term.operation || pattern.word != term.word || pattern.integer != term.integer ||
      pattern.operands.size() != term.operands.size())
    return false;
  for (std::size_t i = 0; i < term.operands.size(); ++i)
    if (!match(pattern.operands[i], term.operands[i], holes)) return false;
  return true;
}

}  // namespace

Term Rewriter::leaf(bool vector, bool rates) {
  static const std::vector<std::string> kVectors = {"omega", "L",  "A",  "v",  "p", "e1",
                                                    "e2",    "e3", "ey", "ez", "N", "F"},
                                        kScalars = {"T",  "I1", "I2",  "I3",  "w1",  "w2",  "w3",
                                                    "m",  "3",  "0.5", "Jxx", "Jyz", "Jxy", "Jzz",
                                                    "N1", "N3", "N2",  "dw1", "dw2", "dw3"};
  constexpr std::size_t kVectorsWithoutRate = 2, kScalarsWithoutRate = 6;
  const auto& words = vector ? kVectors : kScalars;
  const std::size_t without = vector ? kVectorsWithoutRate : kScalarsWithoutRate;
  return term_from(words[below(words.size() - (rates ? 0 : without))]);
}

Term Rewriter::any(bool vector, int depth, bool rates) {
  if (depth == 0 || below(8) == 0) return leaf(vector, rates);
  static const std::vector<std::string> kVectorForms = {
      "A + v",      "A - v",      "m*A",         "A/m",    "-A",     "cross(A, v)", "cross(A, v)",
      "inertia(A)", "inertia(A)", "apply(J, A)", "ddt(A)", "ddt(A)", "star(A)",     "star(A)"};
  static const std::vector<std::string> kScalarForms = {
      "m + Jxx",   "m - Jxx",  "m*Jxx",      "m/Jxx",      "m^2",        "m^3",      "-m",     "dot(A, v)",
      "dot(A, v)", "norm2(A)", "comp(A, 1)", "comp(A, 2)", "comp(A, 3)", "trace(J)", "ddt(m)", "ddt(m)"};
  constexpr std::size_t kVectorRates = 4, kScalarRates = 2;
  const auto& forms = vector ? kVectorForms : kScalarForms;
  Term term = term_from(forms[below(forms.size() - (rates ? 0 : vector ? kVectorRates : kScalarRates))]);
  const bool is_rate = term.operation == Operation::ddt || term.operation == Operation::star;
  for (Term& operand : term.operands) operand = any(is_vector(operand), depth - 1, rates && !is_rate);
  return term;
}

Term Rewriter::rewritten(Term term, LawsAssumed assumption) {
  static const std::vector<Law> kLaws = laws();
  struct Choice {
    Term* spot;
    const Law* law;
    Holes holes;
  };
  std::vector<Choice> choices;
  for_each_spot(term, [&](Term& spot) {
    for (const Law& law : kLaws) {
      Holes holes;
      if (law.assumption > assumption) continue;
      if (law.literal ? law.from == spot : match(law.from, spot, holes))
        choices.push_back({&spot, &law, std::move(holes)});
    }
  });
  if (choices.empty()) return term;
  // A law of its own kind first, then a place for it: the ones that fit anywhere would crowd out the others.
  const Law* law = choices[below(choices.size())].law;
  std::erase_if(choices, [law](const Choice& choice) { return choice.law != law; });
  Choice& choice = choices[below(choices.size())];
  Term result = law->to;
  if (!law->literal) {
    std::vector<Term*> places;
    for_each_spot(result, [&](Term& spot) {
      if (is_hole(spot)) places.push_back(&spot);
    });
    for (Term* place : places) {
      const std::string hole = place->word;
      *place = choice.holes.try_emplace(hole, leaf(is_vector(*place), false)).first->second;
    }
  }
  *choice.spot = std::move(result);
  return term;
}

}  // namespace polhode::oracle
