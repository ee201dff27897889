// SPDX-License-Identifier: MIT
// The folder of an export, from before its first picture until its manifest is there.
//
// A hidden marker file is made before the first picture and goes away when manifest.json is there. Marker and
// manifest say of which lesson text and options the folder is: others are refused, at whatever moment they
// come, and whatever was killed before. Shards leave manifest.I-of-N.json; whoever finds that all of them are
// there writes manifest.json and removes them. Two may find it at the same moment: they write the same bytes.
#pragma once

#include "app/export/folder/manifest.h"
#include "app/export/folder/shard.h"

#include <filesystem>
#include <string>
#include <vector>

namespace polhode {

inline constexpr const char* kMarkerName = ".polhode-unfinished.json";

/// What lies in a folder that an export may go into.
struct FolderState {
  /// Marker or manifest say that pictures there are of this lesson text and these options (other frames of
  /// them, perhaps): those that are whole may be kept.
  bool ours = false;
  /// manifest.json of exactly this export is there.
  bool finished = false;
  std::string renderer;  ///< what drew the pictures that are there, as far as known
};

/// An error if the folder holds, or is about to hold, an export of other options or of another lesson text;
/// it says what differs. A finished export of the same selection is no error if its frames are all among
/// those of the new one.
Result<FolderState> inspect_folder(const std::filesystem::path& folder, const ExportIdentity& mine);

/// What the marker says to `polhode verify`.
struct Marker {
  ExportIdentity of;
  std::string renderer;
  std::vector<std::string> resume;  ///< the command that finishes it, word by word
  std::vector<std::string> files;   ///< all names, in the order of the plan
};

/// Removes what killed processes left unfinished, and puts the marker, if the folder has neither marker nor
/// manifest of this export. `mine.renderer` is added to a marker that has others. Call after inspect_folder:
/// an exporter that came in between is noticed here, with the same errors.
Result<FolderState> begin_in(const std::filesystem::path& folder, const Marker& mine);

/// The checksums of the files, as far as manifest.json and the manifests of shards in the folder have them.
/// There is none for a file that no manifest lists, nor from manifests that are older than checksums. If only
/// some files of a manifest lack theirs, it is empty, and no file answers to it. Call this when
/// inspect_folder has taken the folder for ours, and before anything is made there.
Result<Checksums> recorded_checksums(const std::filesystem::path& folder, const ExportIdentity& mine);

/// What the manifests of all shards say together.
struct ShardsSummary {
  std::string renderer;  ///< join_renderers
  Checksums checksums;
};

/// What the manifests of all shards say, if each of them is there; nothing if one is missing. An error if one
/// belongs to another export.
/// @param pictures of the whole plan
Result<std::optional<ShardsSummary>> summarize_shards(const std::filesystem::path& folder,
                                                      const ExportIdentity& mine, std::int64_t shards,
                                                      std::size_t pictures);

/// Held by one process at a time while it reads manifest.json, changes what it read and writes it again: an
/// advisory lock (flock) on the folder itself, which leaves no file and ends with its process. Where a file
/// system has no such locks, nothing is held: of two that do this in the same instant one is then forgotten.
class FolderLock {
 public:
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int folder_ = -1;
};

/// When manifest.json is there: marker and manifests of shards go. What cannot be removed stays.
void remove_traces(const std::filesystem::path& folder);

}  // namespace polhode
