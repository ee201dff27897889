// SPDX-License-Identifier: MIT
#include "base/markup.h"

#include <cmath>

namespace polhode {

std::string escaped(std::string_view utf8) {
  std::string text;
  text.reserve(utf8.size());
  for (std::size_t i = 0; i < utf8.size(); ++i) {
    const char c = utf8[i];
    switch (c) {
      case '&':
        text += "&amp;";
        break;
      case '<':
        text += "&lt;";
        break;
      case '>':
        text += "&gt;";
        break;
      case '"':
        text += "&quot;";
        break;
      case '\'':
        text += "&#39;";
        break;
      default:
        if (utf8.substr(i, 3) == "\xEF\xBF\xBE" || utf8.substr(i, 3) == "\xEF\xBF\xBF") {
          text += "\xEF\xBF\xBD";
          i += 2;
        } else {
          text += static_cast<unsigned char>(c) < 0x20 && c != '\n' ? ' ' : c;
        }
    }
  }
  return text;
}

std::string hex(const Color& color) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text = "#";
  for (const float part : {color.r, color.g, color.b}) {
    const auto level = static_cast<std::size_t>(std::lround(part * 255));
    text += kDigits[level >> 4 & 15];
    text += kDigits[level & 15];
  }
  return text;
}

}  // namespace polhode
