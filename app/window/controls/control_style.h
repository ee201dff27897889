// SPDX-License-Identifier: MIT
// How controls look: the fonts and colours of the page.
#pragma once

#include "app/page/page_theme.h"
#include "render/typeset/fonts.h"

struct ImFont;

namespace polhode {

/// Sizes of the window's own parts, px of the display.
struct ControlSizes {
  float em = 17;      ///< of the controls' type
  float bar = 50;     ///< height of the bar below the page
  float panel = 330;  ///< width of the panel beside it
  float padding = 10;
  bool operator==(const ControlSizes&) const = default;
};
/// At a scale: 1 for a display of about 96 dots per inch.
ControlSizes control_sizes(double scale);

/// Settings of the current ImGui context, which was just made.
void begin_controls();

/// Builds the fonts of the current ImGui context: Heros, with signs and Greek from Pagella Math: all that a
/// page may have, but for characters beyond 16 bits. Superscripts and subscripts of digits, + − = ( ) are
/// small signs of Heros.
void load_control_fonts(const ControlSizes& sizes, const Fonts& fonts);

/// Of headings; after load_control_fonts.
ImFont* bold_control_font();

/// From the top of a line of the current font to its baseline, where the font is em high.
float control_baseline(float em);

/// Colours, roundings and distances of the current ImGui context.
void set_control_style(Theme theme, const ControlSizes& sizes);

}  // namespace polhode
