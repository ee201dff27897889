// SPDX-License-Identifier: MIT
#include "app/cli/shell_completion.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace polhode {

namespace {

std::string replaced(std::string text, std::string_view what, std::string_view by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != text.npos; at += by.size())
    text.replace(at, what.size(), by);
  return text;
}

/// With a backslash before each of `characters`.
std::string escaped(std::string_view text, std::string_view characters) {
  std::string result;
  for (const char c : text) {
    if (characters.find(c) != characters.npos) result += '\\';
    result += c;
  }
  return result;
}

/// A string of bash and zsh that holds the text as it is.
std::string quoted(const std::string& text) { return "'" + replaced(text, "'", R"('\'')") + "'"; }

std::string fish_quoted(const std::string& text) { return "'" + escaped(text, R"(\')") + "'"; }

std::vector<std::string> names_of(const std::vector<ProgramCommand>& commands) {
  std::vector<std::string> names;
  for (const ProgramCommand& command : commands) names.push_back(command.name);
  return names;
}

std::vector<const CommandOption*> arguments_of(const ProgramCommand& command) {
  std::vector<const CommandOption*> arguments;
  for (const CommandOption& option : command.options)
    if (option.is_argument()) arguments.push_back(&option);
  return arguments;
}

std::vector<std::string> all_spellings(const ProgramCommand& command, bool only_valued) {
  std::vector<std::string> all = only_valued ? std::vector<std::string>{} : spellings_of(kHelpFlag.names);
  for (const CommandOption& option : command.options) {
    if (option.is_argument() || (only_valued && option.is_flag())) continue;
    for (std::string& spelling : option.spellings()) all.push_back(std::move(spelling));
  }
  return all;
}

constexpr const char* kKindsOfNames[] = {"nothing", "files", "folders", "lessons"};

// bash

/// A call of _polhode_offer: the kind of names and the words.
std::string bash_offer(const Offered& offered) {
  return fmt::format("{} {}", kKindsOfNames[offered.names],
                     quoted(fmt::format("{}", fmt::join(offered.words, " "))));
}

constexpr const char* kBashHead = R"(# Completion of polhode in bash. Made by: polhode completion bash

# _polhode_offer PROGRAM CURRENT KIND WORDS: what begins as CURRENT does, of WORDS and of the names of that kind.
_polhode_offer() {
  local ids=$4 id
  if [[ $3 == lessons ]]; then
    while read -r id _; do ids+=" $id"; done < <("$1" list 2>/dev/null)
  fi
  mapfile -t COMPREPLY < <(compgen -W "$ids" -- "$2")
  case $3 in
    files | lessons) compopt -o filenames; mapfile -O ${#COMPREPLY[@]} -t COMPREPLY < <(compgen -f -- "$2") ;;
    folders) compopt -o filenames; mapfile -O ${#COMPREPLY[@]} -t COMPREPLY < <(compgen -d -- "$2") ;;
  esac
  # What stands before a colon is a word of its own to bash, and stays.
  if [[ $2 == *:* && $COMP_WORDBREAKS == *:* ]]; then COMPREPLY=("${COMPREPLY[@]#"${2%"${2##*:}"}"}"); fi
}

_polhode() {
  # The words up to the cursor as the program gets them: bash also breaks them at "=" and ":".
  local words=() word
  for word in "${COMP_WORDS[@]:1:COMP_CWORD}"; do
    if [[ ${#words[@]} -gt 0 && ( $word == : || ${words[-1]} == *: ) ]]; then words[-1]+=$word
    elif [[ $word != = ]]; then words+=("$word")
    fi
  done
  if [[ ${COMP_WORDS[COMP_CWORD]} == = ]]; then words+=(""); fi
  local current=${words[-1]} before='' options='' valued='' arguments=() place=0 i
  if [[ ${#words[@]} -gt 1 ]]; then before=${words[-2]}; fi
  COMPREPLY=()
  if [[ ${#words[@]} -le 1 ]]; then
)";

constexpr const char* kBashTail = R"(    *) return ;;
  esac
  if [[ $current == -* ]]; then
    _polhode_offer "$1" "$current" nothing "$options"
    return
  fi
  for ((i = 1; i < ${#words[@]} - 1; i++)); do
    if [[ $valued == *" ${words[i]} "* ]]; then ((i++)); elif [[ ${words[i]} != -* ]]; then ((place++)); fi
  done
  if [[ ${#arguments[@]} -eq 0 ]]; then return; fi
  if [[ $place -ge ${#arguments[@]} ]]; then
    if [[ $repeated != yes ]]; then return; fi
    place=$((${#arguments[@]} - 1))
  fi
  local offered=${arguments[place]}
  _polhode_offer "$1" "$current" "${offered%% *}" "${offered#* }"
}

complete -F _polhode polhode
)";

std::string bash_case_of(const ProgramCommand& command) {
  const auto arguments = arguments_of(command);
  const std::vector<std::string> valued = all_spellings(command, true);
  std::string text = fmt::format("    {})\n      options={}\n      valued={}\n", command.name,
                                 quoted(fmt::format("{}", fmt::join(all_spellings(command, false), " "))),
                                 quoted(fmt::format(" {} ", fmt::join(valued, " "))));
  if (!valued.empty()) {
    text += "      case $before in\n";
    for (const CommandOption& option : command.options)
      if (!option.is_argument() && !option.is_flag())
        text += fmt::format("        {}) _polhode_offer \"$1\" \"$current\" {}; return ;;\n",
                            fmt::join(option.spellings(), " | "), bash_offer(option.offered));
    text += "      esac\n";
  }
  text += "      arguments=(";
  for (const CommandOption* argument : arguments)
    text += fmt::format("{}{}", argument == arguments.front() ? "" : " ",
                        quoted(fmt::format("{} {}", kKindsOfNames[argument->offered.names],
                                           fmt::join(argument->offered.words, " "))));
  text += fmt::format(") repeated={}\n      ;;\n",
                      !arguments.empty() && arguments.back()->may_be_repeated() ? "yes" : "no");
  return text;
}

std::string bash_script(const std::vector<ProgramCommand>& commands) {
  std::vector<std::string> first = names_of(commands);
  for (const CommonFlag& flag : {kHelpFlag, kVersionFlag})
    for (std::string& spelling : spellings_of(flag.names)) first.push_back(std::move(spelling));
  std::string text = kBashHead;
  text += fmt::format(
      "    _polhode_offer \"$1\" \"$current\" nothing {}\n    return\n  fi\n  local repeated=no\n",
      quoted(fmt::format("{}", fmt::join(first, " "))));
  text += "  case ${words[0]} in\n";
  for (const ProgramCommand& command : commands) text += bash_case_of(command);
  return text + kBashTail;
}

// zsh

/// A text between brackets, or a message between colons, of a specification of _arguments.
std::string zsh_text(const std::string& text) { return escaped(text, R"(\[]:)"); }

std::string zsh_action(const Offered& offered) {
  const std::string words = fmt::format("{}", fmt::join(offered.words, " "));
  switch (offered.names) {
    case Offered::nothing:
      break;
    case Offered::files:
      return "_files";
    case Offered::folders:
      return "_files -/";
    case Offered::lessons:
      return words.empty() ? "_polhode_lessons" : "_polhode_lessons " + words;
  }
  return words.empty() ? " " : fmt::format("({})", escaped(words, ":"));
}

std::string zsh_flag(const CommonFlag& flag) {
  const auto spellings = spellings_of(flag.names);
  const std::string about = quoted(fmt::format("[{}]", zsh_text(flag.about)));
  std::string text;
  for (const std::string& spelling : spellings)
    text += fmt::format(" {}", quoted("(- : *)" + spelling) + about);
  return text;
}

std::string zsh_option(const CommandOption& option) {
  const auto spellings = option.spellings();
  std::string text;
  for (const std::string& spelling : spellings) {
    const std::string others =
        option.may_be_repeated() ? "*" : fmt::format("({})", fmt::join(spellings, " "));
    const char* joint = option.is_flag() ? "" : spelling.starts_with("--") ? "=" : "+";
    const std::string value =
        option.is_flag() ? ""
                         : fmt::format(":{}:{}", zsh_text(option.form.empty() ? "TEXT" : option.form),
                                       zsh_action(option.offered));
    text += fmt::format(" \\\n        {}", quoted(fmt::format("{}{}{}[{}]{}", others, spelling, joint,
                                                              zsh_text(option.about), value)));
  }
  return text;
}

std::string zsh_argument(const CommandOption& argument) {
  return fmt::format(" \\\n        {}",
                     quoted(fmt::format("{}:{}:{}", argument.may_be_repeated() ? "*" : "",
                                        zsh_text(argument.names), zsh_action(argument.offered))));
}

std::string zsh_script(const std::vector<ProgramCommand>& commands) {
  std::string text = R"zsh(#compdef polhode
# Completion of polhode in zsh. Made by: polhode completion zsh

# _polhode_lessons WORD...: ids of lessons and those words, and files.
_polhode_lessons() {
  local -a ids
  ids=(${(f)"$(_call_program lessons polhode list 2>/dev/null)"})
  ids=(${ids%% *} "$@")
  compadd -a ids
  _files -g '*.md'
}

_polhode() {
  local curcontext=$curcontext state line
  local -a commands
  typeset -A opt_args
  commands=(
)zsh";
  for (const ProgramCommand& command : commands)
    text +=
        fmt::format("    {}\n", quoted(fmt::format("{}:{}", command.name, escaped(command.about, R"(\:)"))));
  text += fmt::format("  )\n  _arguments -C{}{} '1:command:->command' '*::argument:->argument'\n",
                      zsh_flag(kHelpFlag), zsh_flag(kVersionFlag));
  text +=
      "  case $state in\n    command) _describe command commands; return ;;\n    argument) ;;\n"
      "    *) return ;;\n  esac\n  case $words[1] in\n";
  for (const ProgramCommand& command : commands) {
    text += fmt::format("    {})\n      _arguments{}", command.name, zsh_flag(kHelpFlag));
    for (const CommandOption& option : command.options)
      text += option.is_argument() ? zsh_argument(option) : zsh_option(option);
    text += " ;;\n";
  }
  return text + "  esac\n}\n\n_polhode \"$@\"\n";
}

// fish

std::string fish_offer(const Offered& offered) {
  std::vector<std::string> parts = offered.words;
  if (offered.names == Offered::folders) parts.emplace_back("(__fish_complete_directories)");
  if (offered.names == Offered::lessons) parts.emplace_back("(__polhode_lessons)");
  const bool takes_files = offered.names == Offered::files || offered.names == Offered::lessons;
  return fmt::format("{}{}", takes_files ? "-F" : "-f",
                     parts.empty() ? "" : " -a " + fish_quoted(fmt::format("{}", fmt::join(parts, " "))));
}

std::string fish_names(const std::vector<std::string>& spellings) {
  std::string names;
  for (const std::string& spelling : spellings)
    names += spelling.starts_with("--") ? " -l " + spelling.substr(2) : " -s " + spelling.substr(1);
  return names;
}

std::string fish_lines_of(const ProgramCommand& command) {
  const std::string seen = "__polhode_is_for " + command.name;
  std::string text = fmt::format("\ncomplete -c polhode -n {} -a {} -d {}\n", "__fish_use_subcommand",
                                 command.name, fish_quoted(command.about));
  text += fmt::format("complete -c polhode -n {}{} -d {}\n", fish_quoted(seen),
                      fish_names(spellings_of(kHelpFlag.names)), fish_quoted(kHelpFlag.about));
  for (const CommandOption& option : command.options)
    if (!option.is_argument())
      text += fmt::format(
          "complete -c polhode -n {}{}{} -d {}\n", fish_quoted(seen), fish_names(option.spellings()),
          option.is_flag() ? "" : " -r " + fish_offer(option.offered), fish_quoted(option.about));
  const auto arguments = arguments_of(command);
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const CommandOption& argument = *arguments[i];
    if (argument.offered.names == Offered::nothing && argument.offered.words.empty()) continue;
    const std::string place =
        argument.may_be_repeated() ? "" : fmt::format("; and __polhode_is_at {}", i + 1);
    text += fmt::format("complete -c polhode -n {} {}\n", fish_quoted(seen + place),
                        fish_offer(argument.offered));
  }
  return text;
}

std::string fish_script(const std::vector<ProgramCommand>& commands) {
  std::string valued;
  for (const ProgramCommand& command : commands)
    for (const std::string& spelling : all_spellings(command, true))
      if ((valued + " ").find(" " + spelling + " ") == valued.npos) valued += " " + spelling;
  std::string text = fmt::format(R"(# Completion of polhode in fish. Made by: polhode completion fish

function __polhode_lessons
    polhode list 2>/dev/null | string replace -r ' .*' ''
end

# Is the line for this command? (What fish 4.0 has for it takes the beginning of a command for the command.)
function __polhode_is_for -a command
    set -l words (commandline -opc)
    test (count $words) -gt 1; and test $words[2] = $command
end

# Is the word at the cursor the n-th argument of its command? Options and their values are none.
function __polhode_is_at -a n
    set -l place 0
    set -l is_value no
    for word in (commandline -opc)[3..-1]
        if test $is_value = yes
            set is_value no
        else if contains -- $word{}
            set is_value yes
        else if not string match -q -- '-*' $word
            set place (math $place + 1)
        end
    end
    test (math $place + 1) -eq $n
end

complete -c polhode -f
)",
                                 valued);
  for (const CommonFlag& flag : {kHelpFlag, kVersionFlag})
    text += fmt::format("complete -c polhode -n __fish_use_subcommand{} -d {}\n",
                        fish_names(spellings_of(flag.names)), fish_quoted(flag.about));
  for (const ProgramCommand& command : commands) text += fish_lines_of(command);
  return text;
}

}  // namespace

const std::vector<std::string>& shell_names() {
  static const std::vector<std::string> names = {"bash", "zsh", "fish"};
  return names;
}

std::string completion_script(Shell shell, const std::vector<ProgramCommand>& commands) {
  switch (shell) {
    case Shell::bash:
      return bash_script(commands);
    case Shell::zsh:
      return zsh_script(commands);
    case Shell::fish:
      break;
  }
  return fish_script(commands);
}

}  // namespace polhode
