// SPDX-License-Identifier: MIT
// The languages that lessons are written in: what the program says on their pages it says in theirs. The
// language travels with the lesson (About::language), its formulas (Math::language) and its scenes
// (Scene::language); there is no other state of it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace polhode {

enum class Language : std::uint8_t { en, de };
inline constexpr std::array<Language, 2> kLanguages = {Language::en, Language::de};

/// As BCP 47 has it: "en", "de".
constexpr std::string_view tag_of(Language language) { return language == Language::de ? "de" : "en"; }
constexpr std::optional<Language> language_from(std::string_view tag) {
  for (const Language language : kLanguages)
    if (tag_of(language) == tag) return language;
  return std::nullopt;
}

/// Before the decimals: 0.5 in English, 0,5 in German. No language here sets thousands apart.
constexpr char decimal_mark(Language language) { return language == Language::de ? ',' : '.'; }

/// A line of text, with formulas between dollars, whose numbers have points: those between two digits as the
/// language has them, "0,5" and "$0{,}5$", where TeX makes no space behind the comma; and numbers of a list
/// with decimals then stand between semicolons, "(0,5; 1; 2)".
std::string with_decimals(std::string line, Language language);
/// The same of its formulas alone: of an author's line, whose other words are in the language already.
std::string with_decimals_in_formulas(std::string line, Language language);

}  // namespace polhode
