// SPDX-License-Identifier: MIT
// The keys `trails`, `arrows`, `angles`, `areas`, `lines`, `planes` and `notes` of a scene: what a lesson
// draws of vectors of its own.
#pragma once

#include "lessons/reader/scene/quantity_key.h"
#include "render/scene/description/mark.h"

#include <string>

namespace polhode {

/// Of names in figures, whose size is that of their first picture.
inline constexpr std::string_view kNoNumbersHere =
    "computed numbers stand in texts, formulas and captions, not in marks and plots";

inline constexpr int kMaxNoteCharacters = 60;

/// Each puts its list into `marks`; what is wrong in it is reported and left out. Nothing is changed where
/// the key takes something else. @return what is written in the figure, ready to be set.
RichText read_trails(const TomlEntry& entry, const SceneWords& words, Marks& marks, TextReader& texts);
RichText read_arrows(const TomlEntry& entry, const SceneWords& words, Marks& marks, TextReader& texts);
RichText read_angles(const TomlEntry& entry, const SceneWords& words, Marks& marks, TextReader& texts);
RichText read_areas(const TomlEntry& entry, const SceneWords& words, Marks& marks, TextReader& texts);
RichText read_lines(const TomlEntry& entry, const SceneWords& words, Marks& marks, TextReader& texts);
RichText read_planes(const TomlEntry& entry, const SceneWords& words, Marks& marks, TextReader& texts);
RichText read_notes(const TomlEntry& entry, const SceneWords& words, Marks& marks, TextReader& texts);

/// As TOML that reads back as the same.
std::string text_of(const std::vector<TrailMark>& trails);
std::string text_of(const std::vector<ArrowMark>& arrows);
std::string text_of(const std::vector<AngleMark>& angles);
std::string text_of(const std::vector<AreaMark>& areas);
std::string text_of(const std::vector<LineMark>& lines);
std::string text_of(const std::vector<PlaneMark>& planes);
std::string text_of(const std::vector<NoteMark>& notes);

}  // namespace polhode
