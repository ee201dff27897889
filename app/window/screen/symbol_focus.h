// SPDX-License-Identifier: MIT
// The symbol of the page that is pointed at, or reached by Tab: it is lit in the figure, and explained beside
// itself.
#pragma once

#include "app/session/lesson_session.h"
#include "app/session/page_symbols.h"
#include "app/window/screen/page_view.h"

#include <optional>
#include <string>
#include <vector>

namespace polhode {

class SymbolFocus {
 public:
  using Symbols = std::vector<PageSymbol>;

  /// Among the symbols, for a ring round it: what keys have reached.
  std::optional<std::size_t> place() const { return focus_; }
  bool is_pointed_at() const { return hovered_.has_value(); }

  /// Precondition: there is a symbol at this place.
  void reach(LessonSession& session, const Symbols& symbols, std::size_t place);
  /// The name of what keys have reached; empty: nothing.
  std::string focused(const Symbols& symbols) const;
  void explain() { explains_ = focus_.has_value(); }
  void leave(LessonSession& session);
  /// Forgets what keys have reached and what the pointer is on: the page has changed.
  void forget(LessonSession& session);
  /// What is under the pointer, on the page or in the figure; nothing: no symbol is.
  void point_at(LessonSession& session, const Symbols& symbols, const std::optional<PageSymbol>& hovered);
  /// Says what the symbol stands for, and its value where what it stands in speaks of the motion that is
  /// shown. @param em of controls, px
  void draw_note(const LessonSession& session, const PageView& page, float em) const;

 private:
  void light_focus(LessonSession& session, const Symbols& symbols) const;

  std::optional<std::size_t> focus_;
  std::optional<PageSymbol> hovered_;
  bool explains_ = false;  ///< the symbol in focus
};

}  // namespace polhode
