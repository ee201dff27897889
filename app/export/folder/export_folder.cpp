// SPDX-License-Identifier: MIT
#include "app/export/folder/export_folder.h"

#include "app/export/timeline.h"
#include "base/files/file_link.h"
#include "base/files/left_behind.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

namespace polhode {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

constexpr const char* kAdvice = "choose another folder, or remove it first";

Json without_frames(Json options) {
  options.erase("frames");
  return options;
}

/// Absent: all.
std::optional<FrameRange> frames_in(const Json& options) {
  if (!options.contains("frames") || !options["frames"].is_string()) return std::nullopt;
  return frame_range_from(options["frames"].get<std::string>());
}

std::string words_of_frames(const Json& options) {
  const auto frames = frames_in(options);
  return frames ? fmt::format("frames {}:{}", frames->begin, frames->end) : "all frames";
}

bool among(const Json& few, const Json& many) {
  const auto inner = frames_in(few), outer = frames_in(many);
  return !outer || (inner && outer->begin <= inner->begin && inner->end <= outer->end);
}

Failure<std::string> refuse(const fs::path& folder, const std::string& what) {
  return failure(fmt::format("{} holds {}; {}", folder.string(), what, kAdvice));
}

/// @param finished `there` is of manifest.json, not of the marker
Status may_join(const fs::path& folder, const ExportIdentity& there, const ExportIdentity& mine,
                bool finished) {
  const char* an_export = finished ? "an export" : "an unfinished export";
  const Json options_there = Json::parse(there.options), my_options = Json::parse(mine.options);
  if (options_there != my_options) {
    if (without_frames(options_there) != without_frames(my_options))
      return refuse(folder, fmt::format("{} made with other options ({})", an_export,
                                        first_difference(there.options, mine.options)));
    if (!finished)
      return refuse(folder, fmt::format("an unfinished export of {}", words_of_frames(options_there)));
  }
  if (there.lesson_sha256 != mine.lesson_sha256)
    return refuse(folder, fmt::format("{} of another lesson text", an_export));
  if (!among(options_there, my_options))
    return failure(
        fmt::format("{} holds {} of this selection; to add to them, export a range with them in it "
                    "and --skip-existing, or {}",
                    folder.string(), words_of_frames(options_there), kAdvice));
  return success();
}

Json marker_json(const Marker& marker) {
  Json json;
  json["format"] = kManifestFormat;
  json["lesson"] = {{"id", marker.of.lesson_id}, {"sha256", marker.of.lesson_sha256}};
  json["options"] = Json::parse(marker.of.options);
  json["renderer"] = marker.renderer;
  json["resume"] = marker.resume;
  json["files"] = marker.files;
  return json;
}

std::string text_of(const Marker& marker) {
  return marker_json(marker).dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
}

bool same_export(const ExportIdentity& a, const ExportIdentity& b) {
  return a.options == b.options && a.lesson_sha256 == b.lesson_sha256;
}

std::vector<fs::path> shard_manifests_in(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> found;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    if (is_shard_manifest_name(entry->path().filename().string())) found.push_back(entry->path());
  return found;
}

}  // namespace

Result<FolderState> inspect_folder(const fs::path& folder, const ExportIdentity& mine) {
  FolderState state;
  std::vector<std::string> renderers;
  for (const char* name : {kMarkerName, kManifestName}) {
    const bool finished = name == kManifestName;
    const auto there = summarize_manifest(folder / name);
    if (!there) return failure(fmt::format("{}; {}", there.error(), kAdvice));
    if (!*there) continue;
    if (const Status may = may_join(folder, (*there)->of, mine, finished); !may) return failure(may.error());
    state.ours = true;
    state.finished = state.finished || (finished && (*there)->of.options == mine.options);
    renderers.push_back((*there)->renderer);
  }
  state.renderer = join_renderers(renderers);
  return state;
}

Result<FolderState> begin_in(const fs::path& folder, const Marker& mine) {
  remove_left_behind_in(folder);
  auto state = inspect_folder(folder, mine.of);
  if (!state || state->finished) return state;
  PosixFileOps files;
  const auto made = create_file_atomically(files, folder / kMarkerName, bytes_of(text_of(mine)));
  if (!made) return failure(made.error());
  if (*made) return state;
  state = inspect_folder(folder, mine.of);  // whoever made it came first
  if (!state) return state;
  Marker both = mine;
  both.renderer = join_renderers({state->renderer, mine.renderer});
  if (both.renderer == state->renderer) return state;
  const Status added = replace_file_atomically(folder / kMarkerName, bytes_of(text_of(both)));
  if (!added) return failure(added.error());
  return state;
}

Result<Checksums> recorded_checksums(const fs::path& folder, const ExportIdentity& mine) {
  Checksums all;
  const auto add = [&](const Checksums& more) {
    const bool older =
        std::all_of(more.begin(), more.end(), [](const auto& file) { return file.second.empty(); });
    if (!older)
      for (const auto& [file, sha256] : more) all[file] = sha256;
  };
  // That of all comes last: the last shard to finish writes it, and only then removes those of shards.
  for (const fs::path& path : shard_manifests_in(folder)) {
    const auto there = summarize_manifest(path);
    if (!there || !*there || !same_export((*there)->of, mine)) continue;  // told by summarize_shards
    if (const auto of_shard = checksums_in_manifest(path)) add(*of_shard);
  }
  std::error_code error;
  if (!fs::exists(folder / kManifestName, error)) return all;
  const auto of_all = checksums_in_manifest(folder / kManifestName);
  if (!of_all) return failure(of_all.error());
  add(*of_all);
  return all;
}

Result<std::optional<ShardsSummary>> summarize_shards(const fs::path& folder, const ExportIdentity& mine,
                                                      std::int64_t shards, std::size_t pictures) {
  ShardsSummary all;
  std::vector<std::string> renderers;
  for (Shard shard{1, shards}; shard.index <= shards; ++shard.index) {
    const fs::path path = folder / shard_manifest_name(shard);
    const auto there = summarize_manifest(path);
    if (!there) return failure(there.error() + "; remove it and export that shard again");
    if (!*there) return std::optional<ShardsSummary>();
    const ManifestSummary& found = **there;
    if (!same_export(found.of, mine) || found.files != shard.size(pictures))
      return failure(
          fmt::format("{} is of another export; remove it and export that shard again", path.string()));
    renderers.push_back(found.renderer);
    auto checksums = checksums_in_manifest(path);
    if (!checksums) return failure(checksums.error());
    all.checksums.merge(*checksums);
  }
  all.renderer = join_renderers(renderers);
  return std::optional(std::move(all));
}

FolderLock::FolderLock(const fs::path& folder)
    : folder_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (folder_ < 0) return;
  while (::flock(folder_, LOCK_EX) != 0 && errno == EINTR) {
  }
}

FolderLock::~FolderLock() {
  if (folder_ >= 0) ::close(folder_);
}

void remove_traces(const fs::path& folder) {
  std::error_code ignored;
  for (const fs::path& trace : shard_manifests_in(folder)) fs::remove(trace, ignored);
  fs::remove(folder / kMarkerName, ignored);
}

}  // namespace polhode
