// SPDX-License-Identifier: MIT
#include "lessons/claims/condition.h"

#include "lessons/claims/proof/rational_function.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace polhode {
namespace {

struct Settable {
  SymbolIndex symbol;
  Quantity quantity;
  const char* name;
};
/// In the order in which they are tried.
constexpr std::array<Settable, 9> kSettable{{{symbols::kTorque, Quantity::N1, "N1"},
                                             {symbols::kTorque + 1, Quantity::N2, "N2"},
                                             {symbols::kTorque + 2, Quantity::N3, "N3"},
                                             {symbols::kSpin, Quantity::w1, "w1"},
                                             {symbols::kSpin + 1, Quantity::w2, "w2"},
                                             {symbols::kSpin + 2, Quantity::w3, "w3"},
                                             {symbols::kMoments, Quantity::I1, "I1"},
                                             {symbols::kMoments + 1, Quantity::I2, "I2"},
                                             {symbols::kMoments + 2, Quantity::I3, "I3"}}};

/// What a symbol is called in expressions; empty of what has no name of its own.
std::string name_of(SymbolIndex symbol, const std::vector<std::string>& constants) {
  for (const Settable& known : kSettable)
    if (known.symbol == symbol) return known.name;
  constexpr std::array<const char*, 3> kNumbers{"m", "h", "k"};
  if (symbol >= symbols::kMass && symbol < symbols::kConstants) return kNumbers[symbol - symbols::kMass];
  const std::size_t constant = symbol - symbols::kConstants;
  return symbol >= symbols::kConstants && constant < constants.size() ? constants[constant] : "";
}

std::string text_of(Ratio::Whole whole) {
  if (whole == 0) return "0";
  std::string digits;
  for (Ratio::Whole rest = whole < 0 ? -whole : whole; rest != 0; rest /= 10)
    digits.insert(digits.begin(), static_cast<char>('0' + static_cast<int>(rest % 10)));
  return digits;
}

/// As an expression; nothing if a symbol in it has no name.
std::optional<std::string> text_of(const Terms& terms, const std::vector<std::string>& constants) {
  std::string text;
  for (const auto& [monomial, coefficient] : terms) {
    text += coefficient.sign() < 0 ? " - " : " + ";
    text += text_of(coefficient.above());
    if (coefficient.below() != 1) text += '/' + text_of(coefficient.below());
    for (SymbolIndex symbol = 0; symbol < kSymbols; ++symbol) {
      if (monomial[symbol] == 0) continue;
      const std::string name = name_of(symbol, constants);
      if (name.empty()) return std::nullopt;
      text += '*' + name + "^(" + std::to_string(monomial[symbol]) + ')';
    }
  }
  return text.empty() ? "0" : text;
}

/// x = value, so that the terms are 0; nothing if x occurs otherwise than once with a factor that is never 0.
std::optional<Terms> solved(const Terms& terms, SymbolIndex x) {
  std::optional<std::pair<Monomial, Ratio>> factor;
  Terms rest = terms;
  for (const auto& [monomial, coefficient] : terms) {
    if (monomial[x] == 0) continue;
    if (monomial[x] != 1 || factor) return std::nullopt;
    rest.erase(monomial);
    Monomial inverse{};
    for (SymbolIndex symbol = 0; symbol < kSymbols; ++symbol) {
      if (symbol == x || monomial[symbol] == 0) continue;
      const bool is_positive =
          symbol == symbols::kMass || (symbol >= symbols::kMoments && symbol < symbols::kTensor);
      if (!is_positive) return std::nullopt;
      inverse[symbol] = static_cast<std::int8_t>(-monomial[symbol]);
    }
    factor.emplace(inverse, -coefficient.reciprocal());
  }
  if (!factor) return std::nullopt;
  return multiplied(rest, {*factor});
}

bool uses_symbol(const Terms& terms, SymbolIndex symbol) {
  return std::any_of(terms.begin(), terms.end(),
                     [symbol](const auto& term) { return term.first[symbol] != 0; });
}

std::vector<std::string> names_of_constants(const Equality& premise, const Given& given) {
  for (const Expression* side : {&premise.left, &premise.right})
    if (side->constants) return *side->constants;
  for (const Setting& setting : given.settings)
    if (setting.value.constants) return *setting.value.constants;
  return {};
}

std::optional<Expression> expression_from(const std::string& text,
                                          const std::vector<std::string>& constants) {
  Vocabulary words;
  for (const std::string& name : constants) words.add_constant(name, 1, name);
  const SourceText source(text);
  Report report(source, "");
  return read_expression(text, {1, 1}, report, &words);
}

}  // namespace

Result<std::vector<Setting>> settings_of_condition(const Equality& premise, LawsAssumed laws,
                                                   const Given& given) {
  const auto refuse = [](std::string why) {
    return Failure{"this condition cannot be solved: " + std::move(why)};
  };
  for (const Expression* side : {&premise.left, &premise.right})
    for (const Quantity axis : {Quantity::ex, Quantity::ey, Quantity::ez})
      if (side->uses(axis)) return refuse("it depends on the attitude");
  const auto constants = names_of_constants(premise, given);
  try {
    start_algebra();
    const auto state = state_of(symbolic_numbers(false), laws, given);
    const Equality squared = with_lengths_squared(premise);
    const auto left = state ? value_in(*state, squared.left) : std::nullopt;
    const auto right = state ? value_in(*state, squared.right) : std::nullopt;
    if (!left || !right) return refuse("it is not defined, or has more than quotients in it");
    std::vector<Terms> components;
    for (std::size_t i = 0; i < 3; ++i) {
      const RationalFunction difference = (*left)[i].value - (*right)[i].value;
      if (!difference.is_polynomial()) return refuse("what it is divided by may be 0");
      if (!difference.is_zero()) components.push_back(difference.above());
    }
    std::vector<Setting> settings;
    for (const Terms& component : components) {
      std::optional<Setting> setting;
      for (const Settable& x : kSettable) {
        if (given.sets(x.quantity) ||
            (x.symbol >= symbols::kTorque && x.symbol < symbols::kForce && given.sets(Quantity::N)))
          continue;
        auto value = solved(component, x.symbol);
        if (!value) continue;
        const auto is_mixed = [&](const Terms& other) {
          return &other != &component && uses_symbol(other, x.symbol);
        };
        const bool tied = std::any_of(components.begin(), components.end(), is_mixed);
        const auto text = tied ? std::nullopt : text_of(*value, constants);
        auto expression = text ? expression_from(*text, constants) : std::nullopt;
        if (!expression) continue;
        setting = Setting{x.quantity, std::move(*expression), std::string(x.name) + " = " + *text, {}, {}};
        break;
      }
      if (!setting)
        return refuse("none of N1, N2, N3, w1, w2, w3, I1, I2, I3 stands in it once, times what is never 0");
      std::vector<Setting> before = given.settings;
      before.insert(before.end(), settings.begin(), settings.end());
      if (const auto fault = why_not_set(*setting, before)) return refuse(fault->message);
      settings.push_back(std::move(*setting));
    }
    return settings;
  } catch (const BeyondAlgebra&) {
    return refuse("it is too large");
  }
}

}  // namespace polhode
