// SPDX-License-Identifier: MIT
// polhode verify: is an export whole, and what is missing, damaged or foreign?
#include "app/cli/commands/commands.h"
#include "app/cli/or_fail.h"
#include "app/export/folder/export_folder.h"
#include "app/export/folder/folder_check.h"
#include "base/printable.h"
#include "base/shell_line.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace polhode {

namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::string folder;
  bool json = false;
};

void print_json(const FolderCheck& found, const std::string& folder) {
  Json json;
  json["folder"] = folder;
  json["lesson"] = found.lesson_id.empty() ? Json(nullptr) : Json(found.lesson_id);
  json["ok"] = found.ok();
  json["finished"] = found.finished;
  json["files"] = found.expected;
  json["missing"] = found.missing;
  json["damaged"] = found.damaged;
  json["foreign"] = found.foreign;
  json["left_over"] = found.left_over;
  json["reasons"] = Json::object();
  for (const auto& [file, reason] : found.reasons) json["reasons"][file] = reason;
  json["shards_finished"] = found.shards_finished;
  json["resume"] = found.resume.empty() ? Json(nullptr) : Json(shell_line(found.resume));
  fmt::print("{}\n", printable(json.dump(2, ' ', false, Json::error_handler_t::replace)));
}

void print_files(const char* what, const std::vector<std::string>& files, const FolderCheck& found) {
  for (const std::string& file : files) {
    const auto reason = found.reasons.find(file);
    fmt::print("{}: {}{}{}\n", what, printable_line(file), reason == found.reasons.end() ? "" : ": ",
               reason == found.reasons.end() ? "" : printable_line(reason->second));
  }
}

void print_words(const FolderCheck& found, const std::string& folder_name) {
  const std::string folder = printable_line(folder_name);
  print_files("missing", found.missing, found);
  print_files("damaged", found.damaged, found);
  print_files("foreign", found.foreign, found);
  print_files("left over", found.left_over, found);
  if (!found.shards_finished.empty())
    fmt::print("shards that are finished, with a manifest of their own: {}\n", found.shards_finished.size());
  const std::string counts = fmt::format("{} missing, {} damaged, {} foreign", found.missing.size(),
                                         found.damaged.size(), found.foreign.size());
  const char* s = found.expected == 1 ? "" : "s";
  if (found.lesson_id.empty())
    fmt::print("{}: neither the manifest nor the marker of an export can be read\n", folder);
  else if (found.ok())
    fmt::print("{}: {} file{} of {}, all there and whole\n", folder, found.expected, s,
               printable_line(found.lesson_id));
  else
    fmt::print("{}: {} export of {} file{}: {}\n", folder, found.finished ? "finished" : "unfinished",
               found.expected, s, counts);
  if (!found.resume.empty()) fmt::print("to make it whole:\n  {}\n", shell_line(found.resume));
}

ExitCode verify(const Options& options) {
  const FolderCheck found = or_fail(check_folder(options.folder));
  if (options.json)
    print_json(found, options.folder);
  else
    print_words(found, options.folder);
  return found.ok() ? ExitCode::done : ExitCode::different;
}

}  // namespace

ProgramCommand verify_command() {
  const auto options = std::make_shared<Options>();
  return {
      "verify",
      "Find what is missing, damaged or foreign in an export",
      {{"DIR", &options->folder, "folder of an export", " ", true, offer_folders()},
       {"--json", &options->json, "the same as JSON: ok, files, missing, damaged, foreign, resume, ..."}},
      "Every file is read: its bytes have to be those that were written (sha256 in manifest.json), or in an\n"
      "unfinished export those of a whole picture of the plan. manifest.json itself is taken as it is. Then\n"
      "the command that makes the pictures whole is told. Films and decks beside them are passed over;\n"
      "nothing is drawn again to compare it. Left over is what killed processes left.\n"
      "Exit code 0 if all is there and whole and nothing else, 4 if not, 1 if DIR cannot be read.",
      [options](const CommandWords&) { return verify(*options); }};
}

}  // namespace polhode
