// SPDX-License-Identifier: MIT
// The symbols and terms on a page that is set: where they stand, which is under the pointer, in which order
// Tab goes through them.
#pragma once

#include "render/scene/sheet.h"
#include "render/type/fonts.h"

#include <optional>
#include <string>
#include <vector>

namespace polhode {

/// One occurrence.
struct PageSymbol {
  std::string name;      ///< of the symbol ("omega"), else of the \term
  bool is_term = false;  ///< it is no symbol of the lesson
  TypeBox box;           ///< px of the page; all its ink
};

/// In reading order: text after text as they lie on the sheet, each from left to right as it is set. What is
/// beside each other and of the same name is one.
std::vector<PageSymbol> symbols_on(const Sheet& sheet, const Fonts& fonts);

/// The innermost (smallest) one within `reach` px of the point; nothing if there is none.
std::optional<std::size_t> symbol_at(const std::vector<PageSymbol>& symbols, const Vec2& point, double reach);

/// Marks behind all of that name, and a ring round the one in focus, for Sheet::shapes.
std::vector<FlatShape> marks_of(const std::vector<PageSymbol>& symbols, const std::string& lit,
                                std::optional<std::size_t> focus, const Color& mark, const Color& ring,
                                double em);

}  // namespace polhode
