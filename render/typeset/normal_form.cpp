// SPDX-License-Identifier: MIT
#include "render/typeset/normal_form.h"

#include "base/utf8.h"

#include <hb.h>

#include <algorithm>

namespace polhode {
namespace {

/// hb_unicode_decompose parts a letter from its last mark: what is left may have one more.
void take_apart(char32_t character, std::u32string& into) {
  hb_codepoint_t letter = 0, mark = 0;
  if (!hb_unicode_decompose(hb_unicode_funcs_get_default(), character, &letter, &mark) ||
      letter == character) {
    into += character;
    return;
  }
  take_apart(letter, into);
  if (mark != 0) into += static_cast<char32_t>(mark);
}

int class_of(char32_t character) {
  return static_cast<int>(hb_unicode_combining_class(hb_unicode_funcs_get_default(), character));
}

}  // namespace

std::string decomposed(std::string_view utf8) {
  std::u32string parts;
  for (const char32_t character : code_points(utf8)) take_apart(character, parts);
  for (auto begin = parts.begin(); begin != parts.end();) {
    begin = std::find_if(begin, parts.end(), [](char32_t c) { return class_of(c) != 0; });
    const auto end = std::find_if(begin, parts.end(), [](char32_t c) { return class_of(c) == 0; });
    std::stable_sort(begin, end, [](char32_t a, char32_t b) { return class_of(a) < class_of(b); });
    begin = end;
  }
  std::string text;
  for (const char32_t part : parts) append_utf8(text, part);
  return text;
}

}  // namespace polhode
