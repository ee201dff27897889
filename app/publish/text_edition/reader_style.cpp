// SPDX-License-Identifier: MIT
#include "app/publish/text_edition/reader_style.h"

#include "app/page/page_theme.h"
#include "app/publish/html_frame.h"
#include "app/publish/text_edition/lesson_html.h"
#include "app/publish/text_edition/reader_assets.h"

#include <fmt/format.h>

#include <set>

namespace polhode {

namespace {

std::string colors_in(const Lesson& lesson, Theme theme) {
  const PageColors& colors = colors_of(theme);
  std::string css = fmt::format(
      "--paper: {}; --ink: {}; --quiet: {}; --accent: {}; --panel: {}; --line: {}; --said: {}; --meant: {}; "
      "--question: {};",
      hex(colors.paper), hex(colors.ink), hex(colors.quiet), hex(colors.accent), hex(colors.panel),
      hex(colors.line), hex(colors.said), hex(colors.meant), hex(colors.question));
  std::set<std::string> roles;
  for (const auto& [name, symbol] : lesson.symbols) roles.insert(symbol.role);
  for (const std::string& role : roles)
    if (const std::string name = class_of_role(role); !name.empty())
      css += fmt::format(" --{}: {};", name, hex(on_paper(role_from(role)->ink, theme)));
  return css;
}

}  // namespace

std::string reader_style(const Lesson& lesson) {
  std::string css =
      fmt::format("\n:root {{ color-scheme: light dark; {} }}\n", colors_in(lesson, Theme::paper)) +
      fmt::format("@media screen and (prefers-color-scheme: dark) {{ :root {{ {} }} }}\n",
                  colors_in(lesson, Theme::dark));
  std::set<std::string> names;
  for (const auto& [name, symbol] : lesson.symbols) names.insert(class_of_role(symbol.role));
  for (const std::string& name : names)
    if (!name.empty()) css += fmt::format(".{0} {{ color: var(--{0}); }}\n", name);
  return css + reader_assets::kReaderCss;
}

}  // namespace polhode
