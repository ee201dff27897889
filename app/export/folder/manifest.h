// SPDX-License-Identifier: MIT
// manifest.json: what an export made, from which lesson and options. It is written last, so a folder that has
// one is complete. Processes that make a part each write one of the same form for their part.
#pragma once

#include "app/export/export_plan.h"
#include "base/result.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace polhode {

inline constexpr const char* kManifestName = "manifest.json";
/// Of manifests and markers; those of another are not read.
inline constexpr int kManifestFormat = 1;

/// What a file does not have is empty and null in the manifest.
struct ManifestFile {
  std::string file;
  std::string stage;
  int step = 0;  ///< from 1; 0: none
  std::optional<std::int64_t> frame;
  std::optional<double> t_s;
  Size size;
  std::vector<std::string> tex;  ///< the display mathematics on screen
  std::string alt;
  std::string method;  ///< of the motion
  std::string sha256;  ///< of the file's bytes
};

/// What an export is of: the same for all processes that make it.
struct ExportIdentity {
  std::string lesson_id;
  std::string lesson_sha256;
  std::string options;  ///< as options_json writes them
};

/// Format 1 of manifests, in pieces, so that a long one is never held whole: the head, a comma between two
/// files, the end, which closes with a newline.
std::string manifest_head(const ExportIdentity& of, const std::string& renderer);
std::string manifest_entry(const ManifestFile& file);
inline constexpr const char* kManifestComma = ",";
/// @param empty there was no entry
std::string manifest_end(bool empty);

/// What a manifest says before its files, and how many these are.
struct ManifestSummary {
  ExportIdentity of;
  std::string renderer;
  std::size_t files = 0;
};
/// Nothing if there is no such file; an error if it is none of polhode's. Takes no memory for the files.
Result<std::optional<ManifestSummary>> summarize_manifest(const std::filesystem::path& path);

/// SHA-256 of files by their names, in hexadecimal digits.
using Checksums = std::map<std::string, std::string>;
/// Of all files that a manifest lists; empty where it has none (an older one). An error if there is no such
/// manifest.
Result<Checksums> checksums_in_manifest(const std::filesystem::path& path);

/// "size is 640x360 there and 1280x720 here", of the first option that differs.
std::string first_difference(const std::string& options_there, const std::string& options_here);

inline constexpr std::string_view kBetweenRenderers = " | ";
/// The drivers that drew parts of an export, each once, in the order of the alphabet.
std::string join_renderers(const std::vector<std::string>& renderers);

/// The options as a manifest keeps them, a JSON object in one line; those without effect on this kind of
/// export are null.
std::string options_json(const ExportOptions& options);

/// TeX of the equations a stage shows at a step (1-based): those of the steps up to it.
std::vector<std::string> tex_shown(const Stage& stage, int step);

}  // namespace polhode
