// SPDX-License-Identifier: MIT
#include "lessons/notation/tex_value.h"

#include <algorithm>
#include <string_view>

namespace polhode {
namespace {

using Type = TexValue::Type;
using Level = TexValue::Level;

void check_size(const TexValue& value) {
  if (value.text.size() > kMaxExpressionBytes)
    throw TexFault(value.span,
                   "written out this has more than " + std::to_string(kMaxExpressionBytes) + " bytes");
}

void append(TexValue& to, std::string_view text) { to.text += text; }
void append(TexValue& to, const TexValue& part, bool brackets = false) {
  if (brackets) to.text += '(';
  const auto shift = static_cast<std::uint32_t>(to.text.size());
  for (const auto& [at, tex] : part.marks) to.marks.emplace_back(at + shift, tex);
  to.text += part.text;
  if (brackets) to.text += ')';
  check_size(to);
}

TexValue made(Type type, Level level, SourceSpan span) {
  TexValue value;
  value.type = type;
  value.level = level;
  value.span = span;
  return value;
}

std::string_view name_of(const TexValue& value) {
  if (value.type == Type::tensor) return "a tensor";
  if (value.type == Type::zero) return "0";
  return value.type == Type::vector ? "a vector" : "a scalar";
}

TexValue zero_value(SourceSpan span) { return atom_value("0", Type::zero, span); }

}  // namespace

TexValue atom_value(std::string text, Type type, SourceSpan span) {
  TexValue value = made(type, Level::atom, span);
  value.marks.emplace_back(0, span.begin);
  value.text = std::move(text);
  check_size(value);
  return value;
}

TexValue tensor_value(TexTensor tensor, SourceSpan span) {
  TexValue value = made(Type::tensor, Level::atom, span);
  value.tensor = std::make_shared<const TexTensor>(std::move(tensor));
  return value;
}

TexValue added(TexValue a, const TexValue& b, bool minus, SourceSpan span) {
  const bool zeros = a.type == Type::zero || b.type == Type::zero;
  if (a.type != b.type && !zeros)
    throw TexKindFault(b.span,
                       std::string(name_of(a)) + " and " + std::string(name_of(b)) + " cannot be added");
  if (a.is_tensor() || b.is_tensor()) {
    if (b.type == Type::zero) return a;
    if (a.type == Type::zero) return minus ? negated_value(b, span) : b;
    TexTensor sum;
    sum.kind = minus ? TexTensor::Kind::difference : TexTensor::Kind::sum;
    sum.a = a.tensor;
    sum.b = b.tensor;
    return tensor_value(std::move(sum), span);
  }
  a.type = a.type == Type::zero ? b.type : a.type;
  a.level = Level::sum;
  a.form = TexValue::Form::plain;
  a.span = span;
  append(a, minus ? " - " : " + ");
  append(a, b, b.level == Level::sum);
  return a;
}

TexValue negated_value(const TexValue& a, SourceSpan span) {
  if (a.is_tensor()) return multiplied(atom_value("(-1)", Type::scalar, span), a, span);
  TexValue value = made(a.type, Level::sum, span);
  append(value, "-");
  append(value, a, a.level == Level::sum);
  return value;
}

TexValue multiplied(TexValue a, const TexValue& b, SourceSpan span) {
  if (a.is_tensor() || b.is_tensor()) {
    TexTensor product;
    if (a.is_tensor() && b.is_tensor()) {
      product.kind = TexTensor::Kind::product;
      product.a = a.tensor;
      product.b = b.tensor;
    } else {
      const TexValue &factor = a.is_tensor() ? b : a, &tensor = a.is_tensor() ? a : b;
      if (factor.is_vector()) throw TexFault(span, "which product of a vector and a tensor?");
      product.kind = TexTensor::Kind::scaled;
      product.a = tensor.tensor;
      product.value = factor;
    }
    return tensor_value(std::move(product), span);
  }
  if (a.is_vector() && b.is_vector())
    throw TexKindFault(span, "which product of two vectors?", "write \\cdot or \\times between them");
  const bool zeros = a.type == Type::zero && b.type == Type::zero;
  const Type type = a.is_vector() || b.is_vector() ? Type::vector : zeros ? Type::zero : Type::scalar;
  if (a.level == Level::sum) {
    TexValue bracketed = made(type, Level::product, span);
    append(bracketed, a, true);
    a = std::move(bracketed);
  }
  // In place, so that long products take linear time.
  a.type = type;
  a.level = Level::product;
  a.form = TexValue::Form::plain;
  a.span = span;
  append(a, "*");
  append(a, b, b.level == Level::sum || b.text.find('/') != std::string::npos);
  return a;
}

TexValue divided(const TexValue& a, const TexValue& b, SourceSpan span) {
  if (!b.is_scalar()) throw TexFault(b.span, "nothing can be divided by " + std::string(name_of(b)));
  if (a.is_tensor()) {
    const TexValue one = atom_value("1", Type::scalar, span);
    return multiplied(divided(one, b, span), a, span);
  }
  TexValue value = made(a.type, Level::product, span);
  append(value, a, a.level == Level::sum);
  append(value, "/");
  append(value, b, b.level != Level::atom);
  return value;
}

TexValue raised(const TexValue& a, int exponent, SourceSpan span) {
  const bool is_length = a.form == TexValue::Form::length;
  if (is_length && exponent > 0 && exponent % 2 == 0) {
    TexValue square = made(Type::scalar, Level::atom, span);
    square.marks = a.marks;
    square.text = "norm2(" + a.of + ")";
    return exponent == 2 ? square : raised(square, exponent / 2, span);
  }
  if (a.is_vector() && exponent == 2) return called("norm2", a, nullptr, Type::scalar, span);
  if (!a.is_scalar())
    throw TexFault(span, std::string(name_of(a)) + " has no such power",
                   a.is_vector() ? "only the square of a vector is read" : "");
  TexValue value = made(Type::scalar, Level::product, span);
  append(value, a, a.level != Level::atom);
  append(value, exponent < 0 ? "^(" + std::to_string(exponent) + ")" : "^" + std::to_string(exponent));
  return value;
}

TexValue called(std::string_view name, const TexValue& a, const TexValue* b, Type type, SourceSpan span) {
  TexValue value = made(type, Level::atom, span);
  value.marks.emplace_back(0, span.begin);
  append(value, name);
  append(value, "(");
  append(value, a);
  if (b != nullptr) {
    append(value, ", ");
    append(value, *b);
  }
  append(value, ")");
  return value;
}

TexValue component_of(const TexValue& vector, int axis, SourceSpan span) {
  if (!vector.is_vector()) throw TexFault(span, std::string(name_of(vector)) + " has no components");
  const std::string n = std::to_string(axis);
  if (vector.text == "omega") return atom_value("w" + n, Type::scalar, span);
  if (vector.text == "N") return atom_value("N" + n, Type::scalar, span);
  const TexValue index = atom_value(n, Type::scalar, span);
  return called("comp", vector, &index, Type::scalar, span);
}

TexValue length_of(const TexValue& vector, SourceSpan span) {
  if (!vector.is_vector())
    throw TexFault(span, "the absolute value of " + std::string(name_of(vector)) + " is not read",
                   "bars are for lengths of vectors");
  TexValue value = called("norm", vector, nullptr, Type::scalar, span);
  value.form = TexValue::Form::length;
  value.of = vector.text;
  return value;
}

TexValue rate_of(const TexValue& a, bool seen_from_space, SourceSpan span) {
  if (a.is_tensor()) {
    TexTensor rate;
    rate.kind = TexTensor::Kind::rate;
    rate.a = a.tensor;
    rate.seen_from_space = seen_from_space;
    return tensor_value(std::move(rate), span);
  }
  const bool star = a.is_vector() && !seen_from_space;
  TexValue value = called(star ? "star" : "ddt", a, nullptr, a.type, span);
  if (a.form == TexValue::Form::length) {
    value.form = TexValue::Form::rate_of_length;
    value.of = a.of;
  }
  return value;
}

TexValue unit_vector(int axis, SourceSpan span) {
  return atom_value("e" + std::to_string(axis), Type::vector, span);
}

TexValue applied(const TexTensor& tensor, const TexValue& vector, SourceSpan span) {
  using Kind = TexTensor::Kind;
  if (!vector.is_vector())
    throw TexFault(span, "a tensor is applied to a vector, this is " + std::string(name_of(vector)));
  switch (tensor.kind) {
    case Kind::identity:
      return vector;
    case Kind::inertia:
      return called("inertia", vector, nullptr, Type::vector, span);
    case Kind::any_inertia: {
      const TexValue name = atom_value("J", Type::scalar, span);
      return called("apply", name, &vector, Type::vector, span);
    }
    case Kind::inverse_inertia: {
      TexValue sum;
      for (int axis = 1; axis <= 3; ++axis) {
        const TexValue moment = atom_value("I" + std::to_string(axis), Type::scalar, span);
        const TexValue part = multiplied(divided(component_of(vector, axis, span), moment, span),
                                         unit_vector(axis, span), span);
        sum = axis == 1 ? part : added(std::move(sum), part, false, span);
      }
      return sum;
    }
    case Kind::cross:
      return called("cross", tensor.value, &vector, Type::vector, span);
    case Kind::product:
      return applied(*tensor.a, applied(*tensor.b, vector, span), span);
    case Kind::sum:
    case Kind::difference:
      return added(applied(*tensor.a, vector, span), applied(*tensor.b, vector, span),
                   tensor.kind == Kind::difference, span);
    case Kind::scaled:
      return multiplied(tensor.value, applied(*tensor.a, vector, span), span);
    case Kind::rate: {
      // (dA/dt) ê = d(A ê)/dt − A dê/dt of a unit vector; of others, linear in their components.
      const auto of_axis = [&](const TexValue& e) {
        const TexValue whole = rate_of(applied(*tensor.a, e, span), tensor.seen_from_space, span);
        return added(whole, applied(*tensor.a, rate_of(e, tensor.seen_from_space, span), span), true, span);
      };
      if (vector.text == "e1" || vector.text == "e2" || vector.text == "e3") return of_axis(vector);
      TexValue sum;
      for (int axis = 1; axis <= 3; ++axis) {
        const TexValue part =
            multiplied(component_of(vector, axis, span), of_axis(unit_vector(axis, span)), span);
        sum = axis == 1 ? part : added(std::move(sum), part, false, span);
      }
      return sum;
    }
    case Kind::matrix: {
      TexValue sum = zero_value(span);
      bool empty = true;
      for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 3; ++column) {
          const TexValue& entry = tensor.entries[3 * row + column];
          if (entry.type == Type::zero && entry.text == "0") continue;
          const TexValue component = component_of(vector, static_cast<int>(column) + 1, span);
          const TexValue part = multiplied(multiplied(entry, component, span),
                                           unit_vector(static_cast<int>(row) + 1, span), span);
          sum = empty ? part : added(std::move(sum), part, false, span);
          empty = false;
        }
      return empty ? multiplied(sum, vector, span) : sum;
    }
  }
  return vector;
}

TexValue trace_of(const TexValue& tensor, SourceSpan span) {
  if (!tensor.is_tensor()) throw TexFault(span, "the trace is that of a tensor");
  TexValue sum;
  for (int axis = 1; axis <= 3; ++axis) {
    const TexValue e = unit_vector(axis, span), image = applied(*tensor.tensor, e, span);
    const TexValue part = called("dot", e, &image, Type::scalar, span);
    sum = axis == 1 ? part : added(std::move(sum), part, false, span);
  }
  return sum;
}

Expression expression_of(const TexValue& value, const Vocabulary& vocabulary) {
  const SourceText source(value.text);
  Report report(source, "");
  auto expression = read_expression(value.text, {1, 1}, report, &vocabulary);
  if (expression) return std::move(*expression);
  const auto diagnostics = report.take();
  const Diagnostic& first = diagnostics.front();
  const auto at = static_cast<std::uint32_t>(first.place.column - 1);
  SourceSpan place = value.span;
  for (const auto& [text_at, tex_at] : value.marks)
    if (text_at <= at && tex_at >= value.span.begin && tex_at < value.span.end) place.begin = tex_at;
  throw TexFault(place, first.message, first.hint);
}

bool changes(const Expression& is) {
  return std::any_of(is.nodes.begin(), is.nodes.end(), [](const ExpressionNode& node) {
    if (node.operation != Operation::quantity) return false;
    switch (node.quantity) {
      case Quantity::I1:
      case Quantity::I2:
      case Quantity::I3:
      case Quantity::m:
      case Quantity::h:
      case Quantity::k:
      case Quantity::ex:
      case Quantity::ey:
      case Quantity::ez:
      case Quantity::Jxx:
      case Quantity::Jxy:
      case Quantity::Jxz:
      case Quantity::Jyy:
      case Quantity::Jyz:
      case Quantity::Jzz:
        return false;
      default:
        return true;
    }
  });
}

}  // namespace polhode
