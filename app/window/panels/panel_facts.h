// SPDX-License-Identifier: MIT
// What the panels are called, and what opens them: the one table that the bar and the panels' heads read.
#pragma once

#include "app/session/command.h"
#include "base/words/window_words.h"

#include <array>

namespace polhode {

struct PanelFacts {
  Panel panel;
  Command command;  ///< opens and closes it
  Phrase name;      ///< on its button in the bar
  Phrase title;     ///< at its head
};

/// In the order of the bar. A panel is drawn by its own file, to which Panels::draw_contents leads.
inline constexpr std::array kPanels = {
    PanelFacts{Panel::lessons, Command::lessons, words::kLessons, words::kLessons},
    PanelFacts{Panel::outline, Command::outline, words::kOutline, words::kOutline},
    PanelFacts{Panel::body, Command::body, words::kBodyPanel, words::kBodyAndSpin},
    PanelFacts{Panel::method, Command::method, words::kMethod, words::kFastOrAccurate},
    PanelFacts{Panel::show, Command::show, words::kShow, words::kShow},
    PanelFacts{Panel::question, Command::question, words::kToAnswer, words::kToAnswer},
    PanelFacts{Panel::save, Command::save, words::kSave, words::kSave},
    PanelFacts{Panel::settings, Command::settings, words::kView, words::kView},
    PanelFacts{Panel::help, Command::help, words::kHelp, words::kKeys},
};

}  // namespace polhode
