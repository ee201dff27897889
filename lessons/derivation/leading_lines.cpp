// SPDX-License-Identifier: MIT
#include "lessons/derivation/leading_lines.h"

#include <algorithm>
#include <set>
#include <string>

namespace polhode {
namespace {

bool is_moment(const std::string& part) {
  const auto is = [&](Quantity moment) { return part == 'q' + std::to_string(static_cast<int>(moment)); };
  return is(Quantity::I1) || is(Quantity::I2) || is(Quantity::I3);
}

/// The product that a term of a canonical form is, "q2 12:0[q16,q17] /q1 ", without moments and divisors.
std::string core_of(const std::string& term) {
  std::string core, part;
  int depth = 0;
  for (const char c : term) {
    if (c == '(' || c == '[') ++depth;
    if (c == ')' || c == ']') --depth;
    if (c != ' ' || depth > 0) {
      part += c;
      continue;
    }
    if (!part.starts_with('/') && !is_moment(part)) core += part + ' ';
    part.clear();
  }
  return core;
}

std::vector<Equality> said_by(const DerivedLine& line) {
  std::vector<Equality> said = line.links;
  said.push_back(line.whole);
  return said;
}

std::set<std::string> terms_of(const DerivedLine& line) {
  std::set<std::string> terms;
  for (const Equality& equality : said_by(line))
    for (const CanonicalForm& form : {canonical_form(equality), expanded_form(equality)})
      for (const auto& [term, factor] : form) terms.insert(core_of(term));
  terms.erase("");
  return terms;
}

bool is_worked_line(const DerivedLine& line, const Derivation& derivation) {
  return std::any_of(derivation.worked.begin(), derivation.worked.end(), [&](const WorkedLine& worked) {
    return expanded_form(worked.line.whole) == expanded_form(line.whole);
  });
}

}  // namespace

std::vector<bool> lines_that_lead(const Derivation& derivation, const std::vector<DerivedLine>& lines) {
  std::vector<bool> lead(lines.size(), false);
  std::set<std::string> wanted;  // the terms of those that lead
  for (std::size_t i = lines.size(); i > 0; --i) {
    const DerivedLine& line = lines[i - 1];
    std::set<std::string> terms = terms_of(line);
    const auto is_wanted = [&](const std::string& term) { return wanted.contains(term); };
    lead[i - 1] = i == lines.size() || std::any_of(terms.begin(), terms.end(), is_wanted) ||
                  is_worked_line(line, derivation);
    if (lead[i - 1]) wanted.merge(terms);
  }
  return lead;
}

}  // namespace polhode
