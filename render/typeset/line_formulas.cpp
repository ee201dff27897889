// SPDX-License-Identifier: MIT
#include "render/typeset/line_formulas.h"

namespace polhode {
namespace {

/// The next `$` that no backslash stands before.
std::size_t next_dollar(std::string_view text, std::size_t at) {
  while (at < text.size() && text[at] != '$') at += text[at] == '\\' ? 2 : 1;
  return at < text.size() ? at : std::string_view::npos;
}

}  // namespace

std::vector<SourceSpan> formulas_of_line(std::string_view text) {
  std::vector<SourceSpan> formulas;
  std::size_t open = next_dollar(text, 0);
  while (open != std::string_view::npos) {
    const std::size_t close = next_dollar(text, open + 1);
    if (close == std::string_view::npos) break;
    const std::string_view tex = text.substr(open + 1, close - open - 1);
    if (tex.empty() || tex.front() == ' ' || tex.back() == ' ') {
      open = close;  // it may open the next one
      continue;
    }
    formulas.push_back({static_cast<std::uint32_t>(open + 1), static_cast<std::uint32_t>(close)});
    open = next_dollar(text, close + 1);
  }
  return formulas;
}

}  // namespace polhode
