// SPDX-License-Identifier: MIT
#include "app/cli/man_page.h"

#include "app/export/picture_metadata.h"
#include "base/utf8.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <string_view>

namespace polhode {

namespace {

/// A character as troff shows it. A hyphen is the minus sign, which can be copied and searched for; what is
/// not ASCII is named, so that no encoding has to be guessed.
std::string roff(char32_t character) {
  switch (character) {
    case U'\\':
      return "\\e";
    case U'-':
      return "\\-";
    case U'\'':
      return "\\(aq";
    case U'`':
      return "\\(ga";
    case U'^':
      return "\\(ha";
    case U'~':
      return "\\(ti";
    case U'"':
      return "\\(dq";
    default:
      break;
  }
  constexpr char32_t kEndOfAscii = 0x80;
  if (character >= kEndOfAscii) return fmt::format("\\[u{:04X}]", static_cast<std::uint32_t>(character));
  return std::string(1, static_cast<char>(character));
}

/// The text, of which no line is a request; its line feeds are those of the source.
std::string roff(std::string_view text) {
  std::string result;
  bool begins_line = true;
  for (const char32_t character : code_points(text)) {
    if (begins_line && character == U'.') result += "\\&";
    result += roff(character);
    begins_line = character == U'\n';
  }
  return result;
}

std::string bold(std::string_view text) { return "\\fB" + roff(text) + "\\fR"; }
std::string italic(std::string_view text) { return "\\fI" + roff(text) + "\\fR"; }

/// Paragraphs of a text whose lines were broken by hand: one ends with a line that ends a sentence.
std::string paragraphs(std::string_view text) {
  std::string result;
  bool begins = true;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(text.size(), line.size() + 1));
    if (line.empty()) continue;
    if (begins) result += ".PP\n";
    result += roff(line) + "\n";
    begins = line.ends_with('.');
  }
  return result;
}

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

std::string page_name(const ProgramCommand& command) { return "polhode-" + command.name; }

std::string head(const std::string& page, std::string_view about) {
  return fmt::format(".\\\" Made by: polhode help --man\n.TH {} 1 \"\" {} {}\n.SH NAME\n{} \\- {}\n",
                     roff(upper(page)), fmt::format("\"{}\"", roff(program_name_and_version())), "polhode",
                     roff(page), roff(about));
}

/// Without the full stop at its end and the capital at its beginning, as a line of NAME has it.
std::string as_name(std::string about) {
  if (about.ends_with('.') && !about.ends_with("...")) about.pop_back();
  if (about.size() > 1 && std::islower(static_cast<unsigned char>(about[1])))
    about[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(about[0])));
  return about;
}

std::string as_sentence(const std::string& about) { return about.ends_with('.') ? about : about + "."; }

/// The value of an option as help and page write it; none of a flag.
std::string value_form(const CommandOption& option) {
  return option.is_flag() || option.is_argument() ? "" : option.form.empty() ? "TEXT" : option.form;
}

std::string in_synopsis(const CommandOption& argument) {
  const bool is_free_form = !argument.form.empty() && argument.form != " " && argument.form != "...";
  std::string text = italic(is_free_form ? argument.form : argument.names);
  if (argument.may_be_repeated() && !is_free_form) text += "...";
  return argument.required ? text : "[" + text + "]";
}

std::string spelled(const std::vector<std::string>& spellings, const std::string& value) {
  std::string text;
  for (const std::string& spelling : spellings) text += (text.empty() ? "" : ", ") + bold(spelling);
  return value.empty() ? text : text + " " + italic(value);
}

std::string entry(const std::string& what, std::string_view about) {
  return fmt::format(".TP\n{}\n{}\n", what, roff(about));
}

std::string exit_status() {
  std::string text = ".SH EXIT STATUS\n";
  for (const auto& [code, meaning] : exit_meanings())
    text += entry(bold(std::to_string(static_cast<int>(code))), meaning);
  return text;
}

std::string see_also(const std::vector<std::string>& pages) {
  std::string text = ".SH SEE ALSO\n";
  for (const std::string& page : pages)
    text += fmt::format(".BR {} (1){}\n", roff(page), page == pages.back() ? "" : ",");
  return text;
}

struct Example {
  const char *line, *about;
};
constexpr Example kExamples[] = {
    {"polhode list", "The lessons there are."},
    {"polhode play euler-equations --stage poinsot", "The lesson in a window, from that stage on."},
    {"polhode export euler-equations -o slides --stage poinsot",
     "A slide of each step of the stage, and manifest.json, in the folder slides."},
    {"polhode export euler-equations --deck lecture.pdf",
     "All slides in one file; or lecture.html, lecture.pptx."},
    {"polhode export euler-equations --film poinsot.mp4 --what figure --stage poinsot --seconds 8",
     "A film of the figure, by ffmpeg."},
    {"polhode export --site public", "All lessons as pages for the web, with an index and a search."},
    {"polhode trace --inertia 1,1.75,2.5 --omega 0.2,0.1,3 --periods 2 --samples 9", "A motion as numbers."},
    {"polhode lint my-lesson.md", "Whether every claim of a lesson is proved; what is wrong, and where."}};

}  // namespace

std::string man_page(const std::vector<ProgramCommand>& commands) {
  std::string text = head("polhode", as_name(kProgramAbout));
  text += ".SH SYNOPSIS\n" + bold("polhode") + " " + italic("COMMAND") + " [" + italic("OPTION") + "]...\n";
  text += ".SH DESCRIPTION\n" + paragraphs(kLessonAndNumbers);
  text += ".PP\nResults go to stdout, messages to stderr.\n";
  text += ".SH COMMANDS\n.PP\nEach has a page of its own.\n";
  for (const ProgramCommand& command : commands)
    text += fmt::format(".TP\n.BR {} (1)\n{}\n", roff(page_name(command)), roff(as_sentence(command.about)));
  text += ".SH OPTIONS\n";
  for (const CommonFlag& flag : {kHelpFlag, kVersionFlag})
    text += entry(spelled(spellings_of(flag.names), ""), flag.about);
  text += exit_status();
  text += ".SH ENVIRONMENT\n";
  text += entry(bold("POLHODE_LESSONS"), "A folder of lessons that is looked in first.");
  text += entry(bold("POLHODE_FONTS"), "A folder of font files that is looked in first.");
  text += entry(
      bold("XDG_STATE_HOME"),
      "Where place, answers and preferences are kept, in a folder polhode; otherwise in ~/.local/state.");
  text += ".SH FILES\n";
  text += entry(italic("PROGRAM/../share/polhode/lessons"), "The lessons that came with the program.");
  text += entry(italic("PROGRAM/../share/polhode/fonts"),
                "Font files, for a machine that has none of them; nothing is installed there.");
  text += entry(italic("PROGRAM/../share/polhode/jobs"), "Scripts for a Slurm array and for GNU parallel.");
  text += ".SH EXAMPLES\n";
  for (const Example& example : kExamples) text += entry(bold(example.line), example.about);
  std::vector<std::string> pages;
  for (const ProgramCommand& command : commands) pages.push_back(page_name(command));
  pages.insert(pages.end(), {"ffmpeg", "parallel", "sbatch"});
  return text + see_also(pages);
}

std::string man_page(const ProgramCommand& command, const std::vector<ProgramCommand>& commands) {
  std::string text = head(page_name(command), as_name(command.about));
  text += ".SH SYNOPSIS\n" + bold("polhode " + command.name) + " [" + italic("OPTION") + "]...";
  for (const CommandOption& option : command.options)
    if (option.is_argument()) text += " " + in_synopsis(option);
  text += "\n.SH DESCRIPTION\n.PP\n" + roff(as_sentence(command.about)) + "\n" + paragraphs(command.footer);
  const bool has_arguments = std::any_of(command.options.begin(), command.options.end(),
                                         [](const CommandOption& option) { return option.is_argument(); });
  if (has_arguments) text += ".SH ARGUMENTS\n";
  for (const CommandOption& option : command.options)
    if (option.is_argument()) text += entry(italic(option.names), option.about);
  text += ".SH OPTIONS\n" + entry(spelled(spellings_of(kHelpFlag.names), ""), kHelpFlag.about);
  for (const CommandOption& option : command.options)
    if (!option.is_argument()) text += entry(spelled(option.spellings(), value_form(option)), option.about);
  text += exit_status();
  std::vector<std::string> pages = {"polhode"};
  for (const ProgramCommand& other : commands)
    if (command.footer.find("polhode " + other.name + " ") != command.footer.npos &&
        other.name != command.name)
      pages.push_back(page_name(other));
  return text + see_also(pages);
}

}  // namespace polhode
