// SPDX-License-Identifier: MIT
// Sides of a printed equation: sums of products of factors (tex_equation.h). Internal to
// lessons/notation/.
//
// tex_terms.cpp has the grammar, tex_names.cpp what letters mean, tex_operators.cpp rates, sums, functions,
// fractions and arrays.
#pragma once

#include "lessons/notation/tex_equation.h"
#include "lessons/notation/tex_value.h"

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace polhode {

/// Reads sides. What is set is how: which formula, what its indices stand for, what conditions hold.
class TexTerms {
 public:
  TexTerms(const Math& math, const EquationNotation& notation);

  using Items = std::span<const TexItem>;

  /// A whole side.
  TexValue side(Items items);
  /// A sum; `where` is the place of one that is missing.
  TexValue sum(Items items, SourceSpan where);

  /// Whether the lesson says that this is something else than what is built in.
  bool is_redefined(const TexItem& item);

  /// The axis, 1 to 3, that an index letter stands for.
  std::map<char32_t, int> indices;
  /// I_{xy} occurs: 𝐈 is any inertia tensor.
  bool any_inertia = false;
  /// Components of ω⃗ that a condition says are 0.
  std::array<bool, 3> no_spin_about{};
  /// What is struck out is left out.
  bool without_struck = false;
  /// Contents of underbraces and their labels, as they are come by; null: they were taken already.
  std::vector<std::pair<TexValue, TexValue>>* labels = nullptr;
  /// Numbers of \live are read, as their expressions.
  bool may_be_live = false;
  /// π is read, and ω, L and vectors of the lesson without their arrows as lengths: of what is computed, for
  /// no proof has either.
  bool has_pi = false;
  /// A rate as seen from the body was read; any rate; 𝐈_S; 𝐈 without an index; a tensor by its components.
  bool has_body_rate = false, has_rate = false, has_space_inertia = false, has_inertia = false,
       has_matrix = false;

  bool is_conditioned() const;

  /// The axis that a character names, or its letter stands for; nothing if it is no index.
  std::optional<int> axis_of(const MathNode& character) const;

 private:
  struct Symbol {
    const EquationSymbol* declared;
    std::shared_ptr<const TexItems> kept;  ///< of one whose items were not
    Items items;
    const MathNode* begin;  ///< of the first, without groups; null: it is no letter
  };
  struct Factor {
    TexValue value;
    bool number = false, fraction_of_numbers = false, function_like = false, lone = false;
    SourceSpan span;
  };

  std::optional<TexValue> product(Items items);
  TexValue run(Items items, std::size_t& at);
  void take_time(const TexItem& before, Items items, std::size_t& at, Factor& factor);
  TexValue chain(std::vector<TexValue> runs, const std::vector<const TexItem*>& signs);
  Factor factor(Items items, std::size_t& at);
  Factor timeless_factor(Items items, std::size_t& at);
  TexValue rate_of_run(Items items, std::size_t& at, bool from_space, SourceSpan place);
  std::optional<TexValue> rate_by_fraction(Items items, std::size_t& at);
  std::optional<TexValue> inline_rate(Items items, std::size_t& at);
  TexValue big_sum(Items items, std::size_t& at);
  TexValue trace(Items items, std::size_t& at);
  TexValue function(Items items, std::size_t& at);
  Factor number(Items items, std::size_t& at);
  Factor live_number(Items items, std::size_t& at);
  std::optional<TexValue> declared(Items items, std::size_t& at);
  TexValue meaning_of(const EquationSymbol& symbol, SourceSpan span) const;
  TexValue group(const TexItem& item);
  TexValue base_of(const TexItem& item, bool& took_sub, bool& took_sup);
  std::optional<TexValue> length_without_arrow(const TexItem& item) const;
  /// Ω where \vec\Omega is declared.
  bool is_letter_of_declared_vector(char32_t c) const;
  TexValue letter(const TexItem& item, bool& took_sub);
  TexValue arrow_or_bold(const TexItem& item, char32_t letter, bool& took_sub, bool& took_sup);
  TexValue inertia(const TexItem& item, bool& took_sub, bool& took_sup);
  TexValue hat(const TexItem& item, const MathNode& base, bool& took_sub);
  TexValue dotted(const TexItem& item, const MathNode& base, bool twice, bool& took_sub);
  TexValue rate_of_scalar(const TexValue& of, bool twice, SourceSpan span);
  TexValue fraction(const TexItem& item);
  TexValue determinant(const TexItem& item);
  TexValue matrix(const TexItem& item);
  TexValue quantity(std::string_view name, SourceSpan span) const;
  TexValue rate(const TexValue& of, bool from_space, SourceSpan span);
  TexValue raised_by(TexValue base, const TexItem& item, bool took_sub, bool took_sup);
  std::vector<int> axes_of(const MathNode& sub) const;
  int axis_in(const TexItem& item) const;
  void spend(SourceSpan span);

  const Math& math_;
  const EquationNotation& notation_;
  std::vector<Symbol> symbols_;
  int factors_ = 0;
  int depth_ = 0;
  mutable std::map<char32_t, int> used_;  // indices, and how often they were
};

/// I_{xy} or I_{12} somewhere: two indices at an italic I.
bool has_tensor_component(const MathNode& node);

/// The only child of a row in a row, through what only decorates.
const MathNode& plain_node(const MathNode& node);

}  // namespace polhode
