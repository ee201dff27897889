// SPDX-License-Identifier: MIT
// docs/tex.md lists what formulas may be written with. To write it anew:
//   POLHODE_REMAKE=tex build/dev/tests/render/typeset/typeset_tests --gtest_filter='CommandList.*'
#include "base/utf8.h"
#include "render/typeset/math/commands.h"
#include "tests/support/paths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <sstream>

namespace polhode {
namespace {

using Action = MathCommand::Action;

bool is_one_of(const MathCommand& command, std::initializer_list<Action> actions) {
  return std::find(actions.begin(), actions.end(), command.action) != actions.end();
}

bool is_symbol(const MathCommand& command, std::initializer_list<MathClass> classes) {
  return command.action == Action::symbol &&
         std::find(classes.begin(), classes.end(), command.atom) != classes.end();
}

struct Group {
  const char* title;
  std::function<bool(const MathCommand&)> holds;
};

/// Each command is listed in the first group that holds it.
const std::vector<Group>& groups() {
  using C = MathCommand;
  static const std::vector<Group> kGroups = {
      {"letters and signs", [](const C& c) { return is_symbol(c, {MathClass::ordinary}); }},
      {"operators between two terms", [](const C& c) { return is_symbol(c, {MathClass::binary}); }},
      {"relations and arrows", [](const C& c) { return is_symbol(c, {MathClass::relation}); }},
      {"delimiters",
       [](const C& c) {
         return is_symbol(c, {MathClass::opening, MathClass::closing});
       }},
      {"dots and punctuation", [](const C& c) { return c.action == Action::symbol; }},
      {"large operators", [](const C& c) { return c.action == Action::large_operator; }},
      {"functions",
       [](const C& c) {
         return is_one_of(c, {Action::named_operator, Action::operator_name});
       }},
      {"accents, bars, braces",
       [](const C& c) {
         return is_one_of(c, {Action::accent, Action::bar, Action::brace});
       }},
      {"fractions and roots",
       [](const C& c) {
         return is_one_of(c, {Action::fraction, Action::binomial, Action::infix_over, Action::infix_choose,
                              Action::infix_atop, Action::radical});
       }},
      {"above, below, through",
       [](const C& c) {
         return is_one_of(c, {Action::overset, Action::underset, Action::stackrel, Action::arrow,
                              Action::negate, Action::cancel, Action::substack, Action::limits});
       }},
      {"alphabets and text",
       [](const C& c) {
         return is_one_of(c, {Action::alphabet, Action::text});
       }},
      {"size of delimiters",
       [](const C& c) {
         return is_one_of(c, {Action::left, Action::middle, Action::right, Action::big});
       }},
      {"spaces",
       [](const C& c) {
         return is_one_of(c, {Action::space, Action::hspace, Action::phantom});
       }},
      {"colours and boxes",
       [](const C& c) {
         return is_one_of(c, {Action::color, Action::text_color, Action::box});
       }},
      {"size of formulas", [](const C& c) { return c.action == Action::style; }},
      {"kind of a part", [](const C& c) { return c.action == Action::atom; }},
      {"rows",
       [](const C& c) {
         return is_one_of(c, {Action::begin, Action::end, Action::row_end, Action::line});
       }},
      {"of lessons",
       [](const C& c) {
         return is_one_of(
             c, {Action::term, Action::proved, Action::live, Action::value, Action::tag, Action::reference});
       }},
      {"short forms", [](const C& c) { return c.action == Action::macro; }},
      {"without effect", [](const C& c) { return c.action == Action::nothing; }}};
  return kGroups;
}

/// As it is written, and the character that it is.
std::string entry_of(const MathCommand& command) {
  // A bar would end the cell of the table.
  const std::string name = command.name == "|" ? "\\|" : std::string(command.name);
  std::string entry = name == " " ? "`\\` and a blank" : "`\\" + name + "`";
  const bool shows = is_one_of(command, {Action::symbol, Action::large_operator}) && command.character > 0x7F;
  if (!shows) return entry;
  entry += ' ';
  append_utf8(entry, command.character);
  return entry;
}

std::string list_of(const std::vector<std::string_view>& names) {
  std::string list;
  for (const std::string_view name : names) list += (list.empty() ? "`" : ", `") + std::string(name) + '`';
  return list;
}

std::string all_commands_as_markdown() {
  const std::vector<Group>& all = groups();
  std::vector<std::string> lists(all.size());
  for (const std::string_view name : math_command_names()) {
    const MathCommand& command = *math_command(name);
    const auto group = std::find_if(all.begin(), all.end(), [&](const Group& g) { return g.holds(command); });
    if (group == all.end()) throw std::runtime_error("in no group: " + std::string(name));
    std::string& list = lists[static_cast<std::size_t>(group - all.begin())];
    list += (list.empty() ? "" : ", ") + entry_of(command);
  }
  std::string text =
      "# TeX that formulas are written with\n\n"
      "All commands, environments and colours; the program's own tables, which a test holds this page "
      "against. A macro of\n"
      "`[macros]` makes others of them. Letters and signs may also be typed as they are: `ω` is "
      "`\\omega`.\n\n"
      "| | commands |\n|---|---|\n";
  for (std::size_t i = 0; i < all.size(); ++i)
    text += "| " + std::string(all[i].title) + " | " + lists[i] + " |\n";
  text += "| environments | " + list_of(math_environment_names()) + " |\n";
  text += "| colours | " + list_of(color_names()) + " |\n";
  return text;
}

TEST(CommandList, IsInTheDocumentation) {
  const auto path = test::source_dir() / "docs/tex.md";
  const std::string text = all_commands_as_markdown();
  const char* remake = std::getenv("POLHODE_REMAKE");
  if (remake != nullptr && std::string_view(remake) == "tex") std::ofstream(path) << text;
  std::ostringstream written;
  written << std::ifstream(path).rdbuf();
  EXPECT_EQ(written.str(), text);
}

}  // namespace
}  // namespace polhode
