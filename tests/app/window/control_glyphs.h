// SPDX-License-Identifier: MIT
// The glyphs of a font of the controls: from Dear ImGui 1.92 on there is a set of them for each size.
#pragma once

#include <imgui.h>

namespace polhode::test {

#if IMGUI_VERSION_NUM >= 19200

inline ImFontBaked& glyphs_of(ImFont& font) { return *font.GetFontBaked(font.LegacySize); }

/// What is drawn from now on for characters that the font has not.
inline void set_fallback(ImFont& font, ImWchar character) {
  ImFontBaked& glyphs = glyphs_of(font);
  glyphs.FallbackGlyphIndex = glyphs.Glyphs.index_from_ptr(glyphs.FindGlyphNoFallback(character));
}

#else

inline ImFont& glyphs_of(ImFont& font) { return font; }

/// What is drawn from now on for characters that the font has not.
inline void set_fallback(ImFont& font, ImWchar character) {
  font.FallbackChar = character;
  font.BuildLookupTable();
}

#endif

}  // namespace polhode::test
