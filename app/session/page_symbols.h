// SPDX-License-Identifier: MIT
// The symbols, terms and links on a page that is set: where they stand, which is under the pointer, in which
// order Tab goes through them.
#pragma once

#include "render/drawing/sheet.h"
#include "render/typeset/fonts.h"

#include <optional>
#include <string>
#include <vector>

namespace polhode {

/// One occurrence.
struct PageSymbol {
  std::string name;      ///< of the symbol ("omega"), or of the \term
  bool is_term = false;  ///< a \term, or a link (is_link_name); symbols in it are there as well
  TypeBox box;           ///< px of the page; all its ink
  TypeBox around{};      ///< about, of the formula or paragraph that it stands in
};

/// All symbols of a page in reading order: text after text as they lie on the sheet, each text from left to
/// right as it is set, a term before the symbols in it. Neighbours of the same name count as one, of a link
/// those on one line. Some 20 µs for a page.
std::vector<PageSymbol> symbols_on(const Sheet& sheet, const Fonts& fonts);

/// The innermost (smallest) one within `reach` px of the point; nothing if there is none.
std::optional<std::size_t> symbol_at(const std::vector<PageSymbol>& symbols, const Vec2& point, double reach);

/// Marks behind all of that name, and a ring round the one in focus. To be put at the end of Sheet::shapes:
/// they lie over panels and under all type. `em` is that of prose.
std::vector<FlatShape> marks_of(const std::vector<PageSymbol>& symbols, const std::string& lit,
                                std::optional<std::size_t> focus, const Color& mark, const Color& ring,
                                double em);

}  // namespace polhode
