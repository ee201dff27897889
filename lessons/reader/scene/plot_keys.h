// SPDX-License-Identifier: MIT
// The key `meters` of a scene: plots with a name, and plots of the lesson's own.
#pragma once

#include "lessons/reader/scene/quantity_key.h"
#include "render/scene/description/meter.h"

#include <optional>
#include <string>
#include <vector>

namespace polhode {

/// Nothing where the key as a whole takes something else; what is wrong in a list is reported and left out.
std::optional<std::vector<PlotSpec>> read_plots(const TomlEntry& entry, const SceneWords& words,
                                                TextReader& texts);

/// What they count as of a lesson's parts (reader.h): each step that goes on with them has them again, and
/// this bounds their memory.
int parts_of(const std::vector<PlotSpec>& plots);

/// As TOML that reads back as the same.
std::string plots_text(const std::vector<PlotSpec>& plots);

}  // namespace polhode
