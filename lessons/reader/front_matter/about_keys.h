// SPDX-License-Identifier: MIT
// Keys of the front matter that speak of the lesson itself, and of what it refers to.
#pragma once

#include "lessons/reader/front_matter/keys.h"
#include "lessons/reader/lesson.h"

#include <vector>

namespace polhode {

inline constexpr std::size_t kMaxAboutLines = 20;   ///< authors, outcomes, prerequisites: of each
inline constexpr std::size_t kMaxReferences = 100;  ///< sources that can be cited
inline constexpr int kMaxLabelCharacters = 24;      ///< of a call-out

struct AboutKeys {
  About about;
  std::vector<Reference> references;         ///< by their keys
  std::vector<OutsideReference> next;        ///< the lesson named by `next`, if one is
  std::vector<PlacedText> reference_places;  ///< where each key of `references` stands
};

/// The key `language`, which all others are read by.
void read_language(const TomlEntry& entry, About& about, Report& report);

/// A handler for each of the keys author, licence, outcomes, prerequisites, next, labels,
/// references. Both arguments outlive them.
std::vector<KeyHandler> about_key_handlers(AboutKeys& keys, Report& report);

}  // namespace polhode
