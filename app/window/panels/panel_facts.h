// SPDX-License-Identifier: MIT
// What the panels are called, and what opens them: the one table that the bar and the panels' heads read.
#pragma once

#include "app/session/command.h"

#include <array>

namespace polhode {

struct PanelFacts {
  Panel panel;
  Command command;    ///< opens and closes it
  const char* name;   ///< on its button in the bar
  const char* title;  ///< at its head
};

/// In the order of the bar. A panel is drawn by its own file, to which Panels::draw_contents leads.
inline constexpr std::array kPanels = {
    PanelFacts{Panel::lessons, Command::lessons, "Lessons", "Lessons"},
    PanelFacts{Panel::outline, Command::outline, "Outline", "Outline"},
    PanelFacts{Panel::body, Command::body, "Body", "Body and its spin"},
    PanelFacts{Panel::method, Command::method, "Method", "Method: fast or accurate"},
    PanelFacts{Panel::show, Command::show, "Show", "Show"},
    PanelFacts{Panel::question, Command::question, "Answer", "Answer"},
    PanelFacts{Panel::save, Command::save, "Save", "Save"},
    PanelFacts{Panel::settings, Command::settings, "View", "View"},
    PanelFacts{Panel::help, Command::help, "?", "Keys"},
};

}  // namespace polhode
