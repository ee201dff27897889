// SPDX-License-Identifier: MIT
// Names as they are typed: "w1", "I_2", those of the lesson; and how each is printed.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace polhode {

/// Names of the lesson's symbols and how they are printed.
using TypedNames = std::map<std::string, std::string, std::less<>>;

/// The tensor of inertia in print.
inline constexpr std::string_view kTensorTex = "\\mathbf I";

/// A name in print: what stands under a dot, and its index.
struct PrintedName {
  std::string letter, index;
  bool is_vector = false, is_omega = false;

  std::string tex() const { return index.empty() ? letter : letter + "_{" + index + '}'; }
  /// With dots above; empty where print has none.
  std::string rate(std::size_t dots) const {
    const std::string dot = dots == 1 ? "\\dot" : "\\ddot";
    if (is_omega && dots == 1) return dot + '{' + letter + '}';
    if (is_vector || dots > 2) return "";
    return dot + '{' + letter + '}' + (index.empty() ? "" : "_{" + index + '}');
  }
};

/// What a name is printed as; nothing if there is none such.
std::optional<PrintedName> printed_name(const std::string& typed, const TypedNames& names);

}  // namespace polhode
