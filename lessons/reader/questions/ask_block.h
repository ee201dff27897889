// SPDX-License-Identifier: MIT
// Keys of an ```ask fence.
#pragma once

#include "lessons/reader/front_matter/front_matter.h"
#include "lessons/reader/front_matter/toml_tree.h"
#include "lessons/reader/lesson.h"
#include "lessons/reader/markdown/inline_text.h"
#include "lessons/reader/questions/choice_list.h"

#include <optional>
#include <string>

namespace polhode {

inline constexpr std::size_t kMaxChoices = 16;
inline constexpr std::size_t kMaxHints = 16, kMaxLetters = 16;
/// Of a derivation.
inline constexpr std::size_t kMaxFacts = 8, kMaxWorkedLines = 16;

/// The question its keys state, in the words of the lesson; `place` is that of the fence, `list` has the
/// choices below the keys, if there are some, and `stage_id` is of the stage it belongs to: with its id and
/// that of the lesson it fixes the order in which choices are shown. Nothing, and reports, if a key is wrong
/// or missing.
std::optional<Ask> read_ask(const TomlTable& table, std::string id, SourcePlace place,
                            const FrontMatter& front, TextReader& texts, const ChoiceList* list = nullptr,
                            std::string_view stage_id = {});

}  // namespace polhode
