// SPDX-License-Identifier: MIT
// A text of the program in every language that lessons can be written in, side by side. All of them stand in
// the headers of base/words/, by where they are said: in formulas, of verdicts, in figures, on pages.
#pragma once

#include "base/words/language.h"

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

namespace polhode {

class Phrase {
 public:
  /// In both texts stand the same parts to be filled in, {0}, {1}, …, in any order: what lacks one does not
  /// compile.
  consteval Phrase(std::string_view english, std::string_view german) : texts_{english, german} {
    if (parts_of(english) != parts_of(german)) throw "the languages do not have the same parts";
  }

  constexpr std::string_view in(Language language) const {
    return texts_[static_cast<std::size_t>(language)];
  }
  /// With these in the place of {0}, {1}, …
  std::string with(Language language, std::initializer_list<std::string_view> parts) const;

 private:
  /// A bit for each part.
  static consteval unsigned parts_of(std::string_view text) {
    unsigned found = 0;
    for (std::size_t i = 0; i + 2 < text.size(); ++i)
      if (text[i] == '{' && text[i + 1] >= '0' && text[i + 1] <= '9' && text[i + 2] == '}')
        found |= 1U << static_cast<unsigned>(text[i + 1] - '0');
    return found;
  }

  std::string_view texts_[kLanguages.size()];
};

/// One that a page or its script asks for by a name.
struct NamedPhrase {
  std::string_view name;
  Phrase words;
};

/// `{"decimal":"MARK","NAME":"TEXT",…}`: where a page's script finds its words, and how numbers are written.
/// No text of the program holds what JSON escapes.
std::string json_of(std::span<const NamedPhrase> phrases, Language language);

}  // namespace polhode
