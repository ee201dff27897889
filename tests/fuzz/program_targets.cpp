// SPDX-License-Identifier: MIT
#include "app/cli/commands/commands.h"
#include "app/cli/commands/export_options.h"
#include "app/cli/trace/trace_times.h"
#include "app/cli/typed_problem.h"
#include "app/cli/typed_shard.h"
#include "app/export/folder/export_folder.h"
#include "app/export/folder/folder_check.h"
#include "app/session/answers/answer_report.h"
#include "app/session/saved/answer_file.h"
#include "app/session/saved/bookmark.h"
#include "app/session/saved/window_place.h"
#include "base/printable.h"
#include "base/sha256.h"
#include "tests/fuzz/targets.h"

#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <vector>

namespace polhode::fuzz {
namespace {

namespace fs = std::filesystem;

/// In memory where the system has such a place; emptied when it is asked for.
const fs::path& empty_folder() {
  static const struct Folder {
    Folder() {
      std::error_code none;
      const fs::path memory = "/dev/shm";
      path = (fs::is_directory(memory, none) ? memory : fs::temp_directory_path()) /
             ("polhode-fuzz-" + std::to_string(getpid()));
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder() {
      std::error_code none;
      fs::remove_all(path, none);
    }
    fs::path path;
  } kFolder;
  fs::remove_all(kFolder.path);
  fs::create_directory(kFolder.path);
  return kFolder.path;
}

void write(const fs::path& file, std::string_view bytes) {
  std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

/// A manifest, or behind a "m" the marker of an unfinished export.
std::string finding_in_record(std::string_view bytes) {
  const fs::path& folder = empty_folder();
  const bool is_marker = bytes.starts_with("m");
  write(folder / (is_marker ? kMarkerName : kManifestName), bytes.substr(is_marker ? 1 : 0));
  const auto check = check_folder(folder);
  if (!check) return "a folder that cannot be read: " + check.error();
  for (const auto& [name, reason] : check->reasons)
    if (reason.empty()) return "damaged without a reason";
  for (const std::string& word : check->resume)
    if (!shows_as_it_is(word)) return "a command that is not what it looks like";
  static_cast<void>(checksums_in_manifest(folder / kManifestName));
  const auto summary = summarize_manifest(folder / kManifestName);
  const ExportIdentity mine = {"tiny", "0123", R"({"what":"page","stage":[],"size":"64x36"})"};
  const auto inspected = inspect_folder(folder, mine);
  if (!inspected && inspected.error().empty()) return "a folder refused without a reason";
  if (summary && *summary) static_cast<void>(first_difference((*summary)->of.options, mine.options));
  return {};
}

/// The file behind its first byte: which one.
std::string finding_in_state(std::string_view bytes) {
  if (bytes.empty()) return {};
  const fs::path& folder = empty_folder();
  const std::string_view text = bytes.substr(1);
  switch (bytes.front()) {
    case 'a': {
      const fs::path log = answer_log_path(folder, "tiny");
      write(log, text);
      const auto changed =
          change_answer_log(log, [](AnswerLog& answers) { note_try(answers["a/b"], true, "0"); });
      if (!changed) return changed.error().text.empty() ? "refused without a reason" : "";
      const auto again = read_answer_log(log);
      if (!again || !again->warning.empty()) return "a log that was written and is damaged";
      if (!again->log.contains("a/b") || again->log.at("a/b").right != 1) return "an answer lost";
      return {};
    }
    case 'b':
      write(folder / "tiny.place.json", text);
      static_cast<void>(read_bookmark(folder, "tiny"));
      return {};
    case 'w':
      write(folder / "window.json", text);
      static_cast<void>(read_window_place(folder));
      return {};
    default: {
      write(folder / "preferences.json", text);
      const auto read = read_preferences(folder);
      if (!read) return {};
      if (!write_preferences(folder, read->preferences)) return "preferences that cannot be written again";
      const auto again = read_preferences(folder);
      return again && again->warning.empty() ? "" : "preferences that were written and are damaged";
    }
  }
}

std::string finding_in_one_report(std::string_view text) {
  const auto report = read_answer_report(text);
  if (!report) return report.error().empty() ? "refused without a reason" : "";
  for (const ReportedAnswer& answer : report->answers)
    if (answer.tries < 0 || answer.hints < 0) return "less than no tries";
  return {};
}

/// As it is, and with the checksum that it should have.
std::string finding_in_report(std::string_view bytes) {
  if (std::string finding = finding_in_one_report(bytes); !finding.empty()) return finding;
  constexpr std::string_view kChecksum = "Checksum: ";
  constexpr std::size_t kDigits = 16;
  const std::string_view checked = bytes.substr(0, bytes.find(kChecksum));
  return finding_in_one_report(std::string(checked) + std::string(kChecksum) +
                               sha256_hex(checked).substr(0, kDigits) + '\n');
}

/// What reads one value, and throws a CommandError, or of an impossible body a std::domain_error.
template <class Read>
std::string finding_in_value(const Read& read) {
  try {
    read();
  } catch (const CommandError& error) {
    if (std::string_view(error.what()).empty()) return "an error without words";
  } catch (const std::domain_error& error) {
    if (std::string_view(error.what()).empty()) return "an error without words";
  }
  return {};
}

/// A word a line: as a command line, whose command is not run, and the first six of them as values of
/// options.
std::string finding_in_command(std::string_view bytes) {
  std::vector<std::string> words(1);
  for (const char c : bytes.substr(0, bytes.find('\0')))
    if (c == '\n')
      words.emplace_back();
    else
      words.back() += c;
  const std::vector<ProgramCommand> real =
      program_commands();  // what they do keeps what the options point to
  std::vector<ProgramCommand> commands = real;
  for (ProgramCommand& command : commands) command.run = [](const CommandWords&) { return ExitCode::done; };
  std::vector<const char*> line = {"polhode"};
  for (const std::string& word : words) line.push_back(word.c_str());
  const ExitCode code = run_command_line(commands, static_cast<int>(line.size()), line.data());
  if (code != ExitCode::done && code != ExitCode::usage) return "a mistake that is not one of usage";
  words.resize(6);
  const std::array readings = {
      finding_in_value([&] {
        problem_from({words[0], words[1], words[2], {words[3], words[4]}});
      }),
      finding_in_value([&] {
        trace_times({words[0], words[1], words[2], words[3], words[4], words[5]}, 2.0, 3.0);
      }),
      finding_in_value([&] { shard_from(words[0]); }), finding_in_value([&] {
        TypedExport typed;
        typed.lessons = {"tiny"};
        typed.folder = "out";
        typed.size = words[0];
        typed.fps = words[1];
        typed.each = "frame";
        typed.seconds = words[2];
        typed.frames = words[3];
        typed.background = words[4];
        typed.text_size = words[5];
        export_options(typed);
      })};
  for (const std::string& finding : readings)
    if (!finding.empty()) return finding;
  return {};
}

constexpr std::array<Target, 4> kTargets = {{{"record", finding_in_record},
                                             {"state", finding_in_state},
                                             {"report", finding_in_report},
                                             {"command", finding_in_command}}};

}  // namespace

std::span<const Target> program_targets() { return kTargets; }

}  // namespace polhode::fuzz
