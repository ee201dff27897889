// SPDX-License-Identifier: MIT
// Values of parts of a printed equation: texts in the language of claims that know where they come from.
// Internal to lessons/notation/ (tex_equation.h).
#pragma once

#include "lessons/claims/expressions/expression.h"
#include "lessons/claims/expressions/vocabulary.h"
#include "lessons/notation/tex_items.h"

#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace polhode {

struct TexTensor;

struct TexValue {
  enum class Type { scalar, vector, zero, tensor };
  /// How tightly the text holds together: what stands in a product needs no brackets from `product` on.
  enum class Level { sum, product, atom };
  /// What is written otherwise where it stands in a power, or alone on a side.
  enum class Form { plain, length, rate_of_length };

  Type type = Type::scalar;
  Level level = Level::atom;
  Form form = Form::plain;
  std::string text;                                            ///< of a tensor empty
  std::string of;                                              ///< of a length or its rate: the vector
  std::vector<std::pair<std::uint32_t, std::uint32_t>> marks;  ///< bytes of `text`, and of the TeX they say
  std::shared_ptr<const TexTensor> tensor;
  SourceSpan span;

  bool is_vector() const { return type == Type::vector; }
  bool is_tensor() const { return type == Type::tensor; }
  bool is_scalar() const { return type == Type::scalar || type == Type::zero; }
};

/// A linear map of vectors.
struct TexTensor {
  enum class Kind {
    identity,
    inertia,
    any_inertia,
    inverse_inertia,
    cross,
    product,
    sum,
    difference,
    scaled,
    rate,
    matrix
  };
  Kind kind = Kind::identity;
  std::shared_ptr<const TexTensor> a, b;
  TexValue value;                 ///< of `cross` the vector, of `scaled` the factor
  bool seen_from_space = true;    ///< of `rate`
  std::vector<TexValue> entries;  ///< of `matrix`: row by row
};

/// All throw TexFault where the types do not fit, or the text grows beyond kMaxExpressionBytes.
TexValue atom_value(std::string text, TexValue::Type type, SourceSpan span);
TexValue tensor_value(TexTensor tensor, SourceSpan span);
TexValue added(TexValue a, const TexValue& b, bool minus, SourceSpan span);
TexValue negated_value(const TexValue& a, SourceSpan span);
/// Of at most one vector or tensor.
TexValue multiplied(TexValue a, const TexValue& b, SourceSpan span);
TexValue divided(const TexValue& a, const TexValue& b, SourceSpan span);
TexValue raised(const TexValue& a, int exponent, SourceSpan span);
/// name(a) or name(a, b).
TexValue called(std::string_view name, const TexValue& a, const TexValue* b, TexValue::Type type,
                SourceSpan span);
TexValue component_of(const TexValue& vector, int axis, SourceSpan span);
TexValue length_of(const TexValue& vector, SourceSpan span);
/// d/dt, or d*/dt; of scalars there is no difference.
TexValue rate_of(const TexValue& a, bool seen_from_space, SourceSpan span);
TexValue applied(const TexTensor& tensor, const TexValue& vector, SourceSpan span);
TexValue trace_of(const TexValue& tensor, SourceSpan span);
TexValue unit_vector(int axis, SourceSpan span);

/// The whole as an expression; faults of the language point into the TeX.
Expression expression_of(const TexValue& value, const Vocabulary& vocabulary);

/// Whether a motion changes it: T, \vec\omega, but no moment, mass or axis of space.
bool changes(const Expression& is);

}  // namespace polhode
