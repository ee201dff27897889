// SPDX-License-Identifier: MIT
// Help, manual pages and completion know the same commands and options: each is read as its user reads it.
#include "app/cli/shell_completion.h"

#include "app/cli/commands/commands.h"
#include "tests/app/run_program.h"
#include "tests/support/paths.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdio>
#include <memory>
#include <regex>
#include <set>
#include <sstream>

namespace polhode {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::IsSupersetOf;
using testing::Not;
using Words = std::vector<std::string>;
using WordSet = std::set<std::string>;

Words lines_of(const std::string& text) {
  Words lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string program() { return test::program().string(); }

WordSet set_of(const Words& words) { return {words.begin(), words.end()}; }

Words names_of_commands() {
  Words names;
  for (const ProgramCommand& command : program_commands()) names.push_back(command.name);
  return names;
}

/// Of `polhode --help`, or of `polhode COMMAND --help`: what stands first in the lines of its options.
WordSet options_in_help(const std::string& command) {
  const ProgramRun run = command.empty() ? polhode({"--help"}) : polhode({command, "--help"});
  EXPECT_EQ(run.code, 0) << command;
  WordSet options;
  const std::regex option_line("^  (-[^ ]*).*");
  std::smatch match;
  for (const std::string& line : lines_of(run.out))
    if (std::regex_match(line, match, option_line))
      for (const std::string& spelling : spellings_of(match[1].str())) options.insert(spelling);
  return options;
}

/// Of the manual page: what is bold and begins with a dash in the first line of each entry.
WordSet options_in_man_page(const std::string& command) {
  const ProgramRun run = command.empty() ? polhode({"help", "--man"}) : polhode({"help", command, "--man"});
  EXPECT_EQ(run.code, 0) << command;
  WordSet options;
  const Words lines = lines_of(run.out);
  const std::regex bold(R"(\\fB((?:\\-|[a-z0-9])+)\\fR)");
  for (std::size_t i = 1; i < lines.size(); ++i) {
    if (lines[i - 1] != ".TP" || !lines[i].starts_with("\\fB\\-")) continue;
    for (std::sregex_iterator found(lines[i].begin(), lines[i].end(), bold), end; found != end; ++found)
      options.insert(std::regex_replace((*found)[1].str(), std::regex(R"(\\-)"), "-"));
  }
  return options;
}

std::string output_of(const std::string& shell_line, const std::string& shell = "bash") {
  const std::string line =
      shell + " -c '" + std::regex_replace(shell_line, std::regex("'"), "'\\''") + "' 2>&1";
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(popen(line.c_str(), "r"), &pclose);
  std::string text;
  char part[4096];
  for (std::size_t n; (n = std::fread(part, 1, sizeof part, pipe.get())) > 0;) text.append(part, n);
  return text;
}

bool is_installed(const std::string& shell) {
  const int status = std::system(("command -v " + shell + " >/dev/null").c_str());
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/// What bash offers for the last of these words. Their breaking at = and : is bash's, so `words` are as it
/// breaks them.
Words bash_offers(const Words& words) {
  std::string line =
      "source <(" + program() + " completion bash); compopt() { :; }; COMP_WORDS=(" + program();
  for (const std::string& word : words) line += " \"" + word + "\"";
  line += "); COMP_CWORD=" + std::to_string(words.size()) +
          "; _polhode \"${COMP_WORDS[0]}\"; if ((${#COMPREPLY[@]})); then printf \"%s\\n\" "
          "\"${COMPREPLY[@]}\"; fi";
  return lines_of(output_of("export POLHODE_LESSONS=" + test::source_dir().string() + "/lessons; " + line));
}

TEST(Completion, BashOffersWhatHelpTells) {
  EXPECT_EQ(set_of(bash_offers({"-"})), options_in_help(""));
  EXPECT_EQ(bash_offers({""}).size(), names_of_commands().size() + options_in_help("").size());
  EXPECT_THAT(bash_offers({""}), IsSupersetOf(names_of_commands()));
  for (const std::string& command : names_of_commands())
    EXPECT_EQ(set_of(bash_offers({command, "-"})), options_in_help(command)) << command;
}

TEST(ManPage, NamesTheOptionsOfHelp) {
  EXPECT_EQ(options_in_man_page(""), options_in_help(""));
  for (const std::string& command : names_of_commands())
    EXPECT_EQ(options_in_man_page(command), options_in_help(command)) << command;
}

TEST(ManPage, OfTheProgramNamesEveryCommand) {
  const std::string page = polhode({"help", "--man"}).out;
  for (const std::string& command : names_of_commands())
    EXPECT_THAT(page, HasSubstr(".BR polhode\\-" + command + " (1)\n"));
  for (const ExitMeaning& meaning : exit_meanings()) EXPECT_THAT(page, HasSubstr(meaning.meaning));
}

/// The lines of its examples are ones that the program reads.
TEST(ManPage, HasExamplesOfOptionsThatThereAre) {
  const std::string page = polhode({"help", "--man"}).out;
  const std::regex example(R"(\\fBpolhode ([a-z]+)( [^\n]*)?\\fR)");
  int seen = 0;
  for (std::sregex_iterator found(page.begin(), page.end(), example), end; found != end; ++found) {
    const WordSet options = options_in_help((*found)[1].str());
    EXPECT_THAT(names_of_commands(), Contains((*found)[1].str()));
    std::istringstream words(std::regex_replace((*found)[2].str(), std::regex(R"(\\-)"), "-"));
    for (std::string word; words >> word;)
      if (word.starts_with('-')) {
        EXPECT_THAT(options, Contains(word)) << (*found)[0];
      }
    ++seen;
  }
  EXPECT_GE(seen, 5);
}

/// groff says on stderr what it does not know; and no letter of the source has become a request.
TEST(ManPage, IsSetWithoutAWarning) {
  if (!is_installed("groff")) GTEST_SKIP() << "groff is not installed";
  Words pages = {""};
  for (const std::string& command : names_of_commands()) pages.push_back(command);
  for (const std::string& command : pages) {
    const std::string page = program() + " help " + command + " --man | groff -man -ww -Tutf8 -P-cbou";
    EXPECT_THAT(output_of(page + " >/dev/null"), IsEmpty()) << command;
    const std::string text = output_of(page);
    for (const char* heading : {"\nNAME\n", "\nSYNOPSIS\n", "\nOPTIONS\n", "\nEXIT STATUS\n"})
      EXPECT_THAT(text, HasSubstr(heading)) << command;
  }
  EXPECT_THAT(output_of(program() + " help derive --man | groff -man -Tutf8 -P-cbou"),
              HasSubstr("d/dt (\u2026)"));
}

TEST(Completion, BashOffersTheWordsOfAnOption) {
  EXPECT_EQ(set_of(bash_offers({"export", "tops", "--what", ""})),
            (WordSet{"page", "equation", "figure", "transcript"}));
  EXPECT_EQ(bash_offers({"export", "--what", "fi"}), Words{"figure"});
  EXPECT_EQ(bash_offers({"export", "--what", "=", "fi"}), Words{"figure"}) << "--what=fi";
  EXPECT_EQ(set_of(bash_offers({"export", "--what", "="})),
            (WordSet{"page", "equation", "figure", "transcript"}));
  EXPECT_EQ(bash_offers({"export", "--size", "16", ":", ""}), Words{"9"}) << "bash keeps 16:";
  EXPECT_THAT(bash_offers({"trace", "--method", "dor"}),
              testing::UnorderedElementsAre("dormand-prince-5", "dormand-prince-8"));
  EXPECT_THAT(bash_offers({"export", "--fps", ""}), IsEmpty());
  EXPECT_EQ(set_of(bash_offers({"completion", ""})), (WordSet{"bash", "zsh", "fish"}));
  EXPECT_THAT(bash_offers({"completion", "bash", ""}), IsEmpty()) << "there is one shell";
  EXPECT_EQ(bash_offers({"help", "exp"}), Words{"export"});
  EXPECT_THAT(bash_offers({"no-such-command", ""}), IsEmpty());
}

TEST(Completion, BashOffersLessonsAtTheirPlace) {
  EXPECT_EQ(bash_offers({"export", "euler-eq"}), Words{"euler-equations"});
  EXPECT_EQ(bash_offers({"export", "--what", "page", "euler-eq"}), Words{"euler-equations"});
  EXPECT_THAT(bash_offers({"answer", "euler-equations", "euler-eq"}), IsEmpty()) << "a stage";
  EXPECT_EQ(bash_offers({"lint", "euler-equations", "euler-eq"}), Words{"euler-equations"})
      << "there may be several";
  EXPECT_THAT(bash_offers({"info", "euler-equations", ""}), IsEmpty());
  EXPECT_EQ(bash_offers({"answers", "coll"}), Words{"collect"});
}

TEST(Completion, BashOffersFilesAndFolders) {
  const ScratchFolder scratch;
  std::filesystem::create_directory(scratch / "a folder");
  write_text(scratch / "a file.png", "");
  const std::string begin = (scratch / "a f").string();
  EXPECT_EQ(bash_offers({"verify", begin}), Words{scratch / "a folder"});
  EXPECT_EQ(bash_offers({"export", "-o", begin}), Words{scratch / "a folder"});
  EXPECT_EQ(set_of(bash_offers({"compare", begin})), (WordSet{scratch / "a folder", scratch / "a file.png"}));
  EXPECT_EQ(bash_offers({"compare", "x.png", (scratch / "a fi").string()}), Words{scratch / "a file.png"});
}

/// What fish offers for the last word of a line.
Words fish_offers(const std::string& line) {
  const std::string script = program() + " completion fish | source; function polhode; " + program() +
                             " $argv; end; complete -C \"polhode " + line +
                             "\" | string replace -r \"\\t.*\" \"\"";
  return lines_of(output_of("export POLHODE_LESSONS=" + test::source_dir().string() +
                            "/lessons HOME=/proc/none; exec fish --no-config -c '" + script + "'"));
}

TEST(Completion, FishOffersWhatHelpTells) {
  if (!is_installed("fish")) GTEST_SKIP() << "fish is not installed";
  EXPECT_EQ(set_of(fish_offers("")), set_of(names_of_commands()));
  for (const std::string& command : names_of_commands()) {
    WordSet wanted = options_in_help(command);
    wanted.erase("-h");
    wanted.erase("-o");
    WordSet long_ones;
    for (const std::string& option : fish_offers(command + " --")) long_ones.insert(option);
    EXPECT_EQ(long_ones, wanted) << command;
  }
  EXPECT_EQ(set_of(fish_offers("export --what ")), (WordSet{"page", "equation", "figure", "transcript"}));
  EXPECT_THAT(fish_offers("export euler-eq"), Contains("euler-equations"));
  EXPECT_THAT(fish_offers("export --what page euler-eq"), Contains("euler-equations"));
  EXPECT_THAT(fish_offers("answer euler-equations euler-eq"), Not(Contains("euler-equations")));
}

/// zsh completes in a terminal only, so that it is asked for its specifications instead: _arguments, in its
/// place, prints them.
TEST(Completion, ZshSpecifiesWhatHelpTells) {
  if (!is_installed("zsh")) GTEST_SKIP() << "zsh is not installed";
  const ScratchFolder scratch;
  write_text(scratch / "_polhode", polhode({"completion", "zsh"}).out);
  for (const std::string& command : names_of_commands()) {
    const std::string told = output_of(
        "_arguments() { if [[ $1 == -C ]]; then state=argument; else print -rl -- \"$@\"; fi }; words=(" +
            command + "); source " + (scratch / "_polhode").string(),
        "zsh -f");
    WordSet options;
    const std::regex specification(R"(^(?:\*|\([^)]*\))(-[-a-z]+)[+=]?\[.*)");
    std::smatch match;
    for (const std::string& line : lines_of(told))
      if (std::regex_match(line, match, specification)) options.insert(match[1]);
    EXPECT_EQ(options, options_in_help(command)) << told;
  }
}

/// And a real zsh in a terminal takes them.
TEST(Completion, ZshCompletesInATerminal) {
  if (!is_installed("zsh")) GTEST_SKIP() << "zsh is not installed";
  const ScratchFolder scratch;
  write_text(scratch / "_polhode", polhode({"completion", "zsh"}).out);
  write_text(scratch / "ask.zsh", R"zsh(zmodload zsh/zpty
zpty z zsh -f -i
zpty -w z "fpath=($1 \$fpath); autoload -Uz compinit; compinit -D -u; bindkey '^I' complete-word"
zpty -w z 'polhode() { print -r -- "it is given:$*" }; print rea"dy"'
zpty -r -m z text '*ready*'
zpty -n -w z $'polhode export --wh\tfig\t\n'
zpty -r -m z text '*it is given:*figure*'
print -r -- $text
)zsh");
  EXPECT_THAT(
      output_of("timeout 60 zsh -f " + (scratch / "ask.zsh").string() + " " + scratch.path().string()),
      HasSubstr("it is given:export --what=figure"));
}

TEST(Usage, CompletionAndHelpRefuseWhatTheyDoNotKnow) {
  const ProgramRun shell = polhode({"completion", "bsh"});
  EXPECT_EQ(shell.code, 2);
  EXPECT_THAT(shell.err, HasSubstr("\"bsh\" is none of bash, zsh, fish; did you mean \"bash\"?"));
  const ProgramRun command = polhode({"help", "exprot"});
  EXPECT_EQ(command.code, 2);
  EXPECT_THAT(command.err, HasSubstr("unknown command \"exprot\"; did you mean \"export\"?"));
}

TEST(Help, OfTheCommandHelpIsTheSame) {
  EXPECT_EQ(polhode({"help"}).out, polhode({"--help"}).out);
  EXPECT_EQ(polhode({"help", "export"}).out, polhode({"export", "--help"}).out);
}

}  // namespace
}  // namespace polhode
