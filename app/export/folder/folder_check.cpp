// SPDX-License-Identifier: MIT
#include "app/export/folder/folder_check.h"

#include "app/export/folder/export_folder.h"
#include "app/export/folder/picture_check.h"
#include "app/export/json_values.h"
#include "base/files/file_bytes.h"
#include "base/files/temporary_file.h"
#include "base/numbers.h"
#include "base/printable.h"
#include "base/sha256.h"
#include "base/shell_line.h"
#include "render/image/png_summary.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <set>
#include <utility>

namespace polhode {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

std::string text_in(const Json& json, const char* name) {
  return json.is_object() && json.contains(name) && json[name].is_string() ? json[name].get<std::string>()
                                                                           : "";
}

/// 0 where there is none, or none that fits.
int number_in(const Json& json, const char* name) {
  if (!json.is_object() || !json.contains(name) || !json[name].is_number_integer()) return 0;
  const auto number = json[name].get<std::int64_t>();
  return std::in_range<int>(number) ? static_cast<int>(number) : 0;
}

/// Manifest or marker.
Json record_in(const fs::path& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return nullptr;
  std::ifstream file(path, std::ios::binary);
  Json json = shallow_json(file);
  const bool whole = json.is_object() && number_in(json, "format") == kManifestFormat &&
                     json.contains("files") && json["files"].is_array() && json.contains("lesson") &&
                     json["lesson"].is_object() && json.contains("options") && json["options"].is_object();
  return whole ? json : Json(nullptr);
}

/// The files of a folder, with what is expected of each.
class Check {
 public:
  explicit Check(const fs::path& folder) : folder_(folder) {}

  Result<FolderCheck> run() {
    if (const Status listed = list(); !listed) return Failure{listed.error()};
    const bool marked = names_.count(kMarkerName) > 0, has_manifest = names_.count(kManifestName) > 0;
    const Json manifest = has_manifest ? record_in(folder_ / kManifestName) : Json(nullptr);
    const Json marker = marked ? record_in(folder_ / kMarkerName) : Json(nullptr);
    found_.finished = !manifest.is_null() && !marked;
    if (!has_manifest) found_.missing.emplace_back(kManifestName);
    if (has_manifest && manifest.is_null()) damaged(kManifestName, "it is not a manifest of polhode");
    if (marked && marker.is_null()) damaged(kMarkerName, "it is not of polhode");
    const Json& record = marker.is_null() ? manifest : marker;
    record_name_ = marker.is_null() ? kManifestName : kMarkerName;
    if (!record.is_null()) {
      found_.lesson_id = text_in(record["lesson"], "id");
      found_.expected = record["files"].size();
      has_checksums_ = std::any_of(record["files"].begin(), record["files"].end(),
                                   [](const Json& file) { return file.contains("sha256"); });
      for (const Json& file : record["files"]) check_file(file, record);
    }
    sort_others();
    if (!found_.ok() && !record.is_null()) found_.resume = resume(record);
    return std::move(found_);
  }

 private:
  Status list() {
    std::error_code error;
    for (fs::directory_iterator entry(folder_, error), end; !error && entry != end; entry.increment(error))
      names_.insert(entry->path().filename().string());
    if (error) return failure(fmt::format("cannot read folder {}: {}", folder_.string(), error.message()));
    return success();
  }

  /// Of several reasons the first is told.
  void damaged(const std::string& name, const std::string& reason) {
    if (found_.reasons.emplace(name, reason).second) found_.damaged.push_back(name);
  }

  void foreign(const std::string& name, const std::string& reason) {
    found_.foreign.push_back(name);
    found_.reasons[name] = reason;
  }

  /// @param file an entry of a manifest; of a marker the name alone
  void check_file(const Json& file, const Json& record) {
    const std::string name = file.is_string() ? file.get<std::string>() : text_in(file, "file");
    if (!expected_.insert(name).second) {
      damaged(record_name_, fmt::format("it lists {} twice", name));
      return;
    }
    const std::string sha256 = text_in(file, "sha256");
    if (has_checksums_ && sha256.empty()) damaged(record_name_, fmt::format("it has no sha256 of {}", name));
    if (names_.count(name) == 0) {
      found_.missing.push_back(name);
      return;
    }
    if (!name.ends_with(".png"))
      check_text(name, sha256);
    else
      judge(name, check_picture(folder_ / name, size_of(name, file), metadata_of(file, record), sha256));
  }

  void judge(const std::string& name, const PictureCheck& check) {
    switch (check.state) {
      case PictureCheck::State::whole:
        return;
      case PictureCheck::State::missing:
        found_.missing.push_back(name);
        return;
      case PictureCheck::State::damaged:
        damaged(name, check.reason);
        return;
      case PictureCheck::State::another:
        foreign(name, check.reason);
        return;
    }
  }

  /// @param sha256 empty in manifests of before 0.1.0: then only an empty file is known to be wrong
  void check_text(const std::string& name, const std::string& sha256) {
    // Far more than the text of a lesson of 1 MiB takes, or its outlines.
    constexpr std::uintmax_t kMostBytes = std::uintmax_t{64} << 20;
    const auto bytes = read_file_bytes(folder_ / name, kMostBytes);
    if (!bytes)
      damaged(name, bytes.error());
    else if (bytes->empty())
      damaged(name, "it is empty");
    else if (!sha256.empty() && sha256_hex(*bytes) != sha256)
      damaged(name, kOtherBytes);
  }

  /// As the manifest has it; a marker does not know it, and takes any.
  Size size_of(const std::string& name, const Json& file) const {
    if (!file.is_string()) return {number_in(file, "width"), number_in(file, "height")};
    const auto png = summarize_png_file(folder_ / name);
    return png ? png->size : Size{};
  }

  static PngMetadata metadata_of(const Json& file, const Json& record) {
    PngMetadata metadata{{{"polhode:lesson", text_in(record["lesson"], "id")}},
                         number_in(record["options"], "dpi")};
    if (file.is_string()) return metadata;
    metadata.text.emplace_back("Description", text_in(file, "alt"));
    metadata.text.emplace_back("polhode:stage", text_in(file, "stage"));
    if (file.contains("t") && file["t"].is_number())
      metadata.text.emplace_back("polhode:t", digits17(file["t"].get<double>()));
    return metadata;
  }

  /// Films and decks may lie beside the pictures they are made of.
  static bool is_made_of_pictures(const fs::path& name) {
    constexpr std::array kEndings = {".mp4", ".webm", ".gif", ".apng", ".html", ".htm", ".pdf", ".pptx"};
    std::string ending = name.extension().string();
    for (char& c : ending)
      if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end();
  }

  void sort_others() {
    const std::vector<fs::path> left = left_behind_in(folder_);
    for (const std::string& name : names_) {
      if (expected_.count(name) > 0 || name == kManifestName || name == kMarkerName) continue;
      if (is_shard_manifest_name(name))
        found_.finished ? found_.left_over.push_back(name) : add_shard(name);
      else if (!is_temporary_name(name) && !is_made_of_pictures(name))
        found_.foreign.push_back(name);
      else if (std::find(left.begin(), left.end(), folder_ / name) != left.end())
        found_.left_over.push_back(name);
    }
  }

  void add_shard(const std::string& name) {
    constexpr std::string_view kStart = "manifest.", kEnd = ".json";
    found_.shards_finished.push_back(name.substr(kStart.size(), name.size() - kStart.size() - kEnd.size()));
  }

  /// The export of the same pictures: a film or deck made of them is not what was judged here. Whoever may
  /// write into the folder may have written all of the record: nothing is offered for copying but an export
  /// by this program into this folder, of words that show as they are.
  std::vector<std::string> resume(const Json& record) const {
    std::vector<std::string> words = {program_invocation_name, "export", lesson_in(record), "--output",
                                      folder_.string()};
    for (const auto& [name, value] : record["options"].items())
      for (const Json& one : value.is_array() ? value : Json::array({value}))
        if (!one.is_null()) {
          std::string option = "--" + name;
          std::replace(option.begin(), option.end(), '_', '-');
          words.push_back(option);
          words.push_back(one.is_string() ? one.get<std::string>() : one.dump());
        }
    words.emplace_back("--skip-existing");
    return may_be_offered(words) ? words : std::vector<std::string>();
  }

  /// As the command in the marker names it, by a file perhaps; otherwise its id.
  std::string lesson_in(const Json& record) const {
    const auto word = [&](std::size_t i) {
      const bool is_there =
          record.contains("resume") && record["resume"].is_array() && i < record["resume"].size();
      return is_there && record["resume"][i].is_string() ? record["resume"][i].get<std::string>() : "";
    };
    constexpr std::size_t kCommand = 1, kLesson = 2;
    return word(kCommand) == "export" && is_argument(word(kLesson)) ? word(kLesson) : found_.lesson_id;
  }

  static bool is_argument(const std::string& word) {
    return !word.empty() && word.front() != '-' && shows_as_it_is(word);
  }

  /// @param words PROGRAM export LESSON --output FOLDER [--option VALUE]… --skip-existing
  static bool may_be_offered(const std::vector<std::string>& words) {
    static const std::set<std::string> kOptions = {
        "--stage",      "--what", "--each", "--size",    "--fps",       "--seconds", "--at",      "--theme",
        "--background", "--dpi",  "--png",  "--quality", "--text-size", "--frames",  "--profile", "--format"};
    if (!shows_as_it_is(words) || !is_argument(words[2])) return false;
    for (std::size_t i = 5; i + 1 < words.size(); i += 2)  // no other folder than this one
      if (!kOptions.contains(words[i]) || words[i + 1].starts_with("--")) return false;
    return true;
  }

  fs::path folder_;
  std::set<std::string> names_, expected_;
  const char* record_name_ = kManifestName;  ///< of what says which files are expected
  bool has_checksums_ = false;               ///< it has: a manifest of before 0.1.0, or a marker, has none
  FolderCheck found_;
};

}  // namespace

Result<FolderCheck> check_folder(const fs::path& folder) { return Check(folder).run(); }

}  // namespace polhode
