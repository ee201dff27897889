// SPDX-License-Identifier: MIT
#include "tests/oracle/mutants.h"

#include <algorithm>
#include <set>
#include <utility>

namespace polhode::oracle {
namespace {

using O = Operation;

Term with(O operation, std::vector<Term> operands, int integer = 0) {
  return {operation, "", integer, std::move(operands)};
}
Term number(const char* word) { return {O::number, word, 0, {}}; }

/// w1 → w2, w3; Jxy → the other five.
std::vector<Term> other_names(const Term& leaf) {
  static const std::vector<std::string> kTensor = {"Jxx", "Jxy", "Jxz", "Jyy", "Jyz", "Jzz"};
  std::vector<Term> others;
  const auto rename = [&](std::string word) {
    if (word == leaf.word) return;
    others.push_back(leaf);
    others.back().word = std::move(word);
  };
  if (leaf.word.front() == 'J')
    for (const std::string& word : kTensor) rename(word);
  else if (leaf.word.size() > 1 && leaf.word.back() >= '1' && leaf.word.back() <= '3')
    for (const char digit : {'1', '2', '3'}) rename(leaf.word.substr(0, leaf.word.size() - 1) + digit);
  else if (leaf.word == "ex" || leaf.word == "ey" || leaf.word == "ez")
    for (const char axis : {'x', 'y', 'z'}) rename(std::string("e") + axis);
  else if (leaf.word == "omega" || leaf.word == "L")
    rename(leaf.word == "L" ? "omega" : "L");
  return others;
}

/// 1 → 2 → 3 → 1 in all of it.
Term turned(Term term) {
  for_each_spot(term, [](Term& spot) {
    if (spot.operation == O::comp) spot.integer = (spot.integer + 1) % 3;
    if (spot.operation != O::quantity || spot.word.front() == 'J') return;
    char& digit = spot.word.back();
    if (digit >= '1' && digit <= '3') digit = static_cast<char>('1' + (digit - '1' + 1) % 3);
  });
  return term;
}

void change_number(const Term& spot, std::vector<Term>& changed) {
  changed.push_back(with(O::multiply, {number("2"), spot}));
  changed.push_back(with(O::negate, {spot}));
  changed.push_back(with(O::add, {spot, number("1")}));
}

void change_sum(const Term& spot, std::vector<Term>& changed) {
  const Term &a = spot.operands[0], &b = spot.operands[1];
  const bool adds = spot.operation == O::add;
  changed.push_back(with(adds ? O::subtract : O::add, {a, b}));
  changed.push_back(with(O::subtract, {b, a}));
  changed.push_back(a);
  changed.push_back(adds ? b : with(O::negate, {b}));
  changed.push_back(turned(spot));
  changed.push_back(with(spot.operation, {turned(a), b}));
  changed.push_back(with(spot.operation, {a, turned(b)}));
}

void change_product(const Term& spot, std::vector<Term>& changed) {
  const Term &a = spot.operands[0], &b = spot.operands[1];
  changed.push_back(a);
  if (spot.operation == O::multiply) changed.push_back(b);
  changed.push_back(with(O::multiply, {spot, number("2")}));
  changed.push_back(with(O::divide, {spot, number("2")}));
  changed.push_back(turned(spot));
}

/// All that a slip may make of the term itself.
std::vector<Term> changed_here(const Term& spot) {
  std::vector<Term> changed;
  switch (spot.operation) {
    case O::number:
      change_number(spot, changed);
      break;
    case O::quantity:
      changed = other_names(spot);
      changed.push_back(with(O::negate, {spot}));
      changed.push_back(with(O::multiply, {number("2"), spot}));
      break;
    case O::negate:
      changed.push_back(spot.operands[0]);
      break;
    case O::add:
    case O::subtract:
      change_sum(spot, changed);
      break;
    case O::multiply:
    case O::divide:
      change_product(spot, changed);
      break;
    case O::power:
      changed.push_back(spot.operands[0]);
      changed.push_back(with(O::power, spot.operands, spot.integer + 1));
      break;
    case O::dot:
    case O::cross:
      changed.push_back(with(spot.operation, {spot.operands[1], spot.operands[0]}));
      changed.push_back(with(spot.operation, {spot.operands[0], spot.operands[0]}));
      changed.push_back(with(O::multiply, {number("2"), spot}));
      break;
    case O::inertia:
      changed.push_back(spot.operands[0]);
      changed.push_back(with(O::apply, spot.operands));
      break;
    case O::apply:
      changed.push_back(with(O::inertia, spot.operands));
      break;
    case O::ddt:
      changed.push_back(with(O::star, spot.operands));
      changed.push_back(with(O::negate, {spot}));
      break;
    case O::star:
      changed.push_back(with(O::ddt, spot.operands));
      changed.push_back(with(O::negate, {spot}));
      break;
    case O::comp:
      for (const int step : {1, 2})
        changed.push_back(with(O::comp, spot.operands, (spot.integer + step) % 3));
      break;
    case O::norm2:
    case O::norm:
    case O::trace:
    case O::constant:
    case O::pi:
    case O::sqrt:
    case O::sin:
    case O::cos:
    case O::acos:
    case O::atan2:
    case O::exp:
    case O::log:
      changed.push_back(with(O::multiply, {number("2"), spot}));
      break;
  }
  return changed;
}

}  // namespace

std::vector<Expression> mutants_of(const Expression& expression) {
  Term whole = term_of(expression);
  std::set<std::string> texts{text_of(whole)};
  std::vector<Expression> mutants;
  for_each_spot(whole, [&](Term& spot) {
    for (Term& changed : changed_here(spot)) {
      std::swap(spot, changed);
      std::string text = text_of(whole);
      std::swap(spot, changed);
      if (!texts.insert(text).second) continue;
      if (auto mutant = expression_from(text)) mutants.push_back(std::move(*mutant));
    }
  });
  return mutants;
}

}  // namespace polhode::oracle
