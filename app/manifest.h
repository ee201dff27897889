// SPDX-License-Identifier: MIT
// manifest.json: what an export made, from which lesson and options. It is written last, so a folder that has
// one is complete.
#pragma once

#include "app/export_plan.h"
#include "render/result.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace polhode {

inline constexpr const char* kManifestName = "manifest.json";

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
};

struct Manifest {
  std::string lesson_id;
  std::string lesson_sha256;
  nlohmann::ordered_json options;
  std::string renderer;
  std::vector<ManifestFile> files;
};

/// The options as a manifest keeps them; those without effect on this kind of export are null.
nlohmann::ordered_json to_json(const ExportOptions& options);

/// Format 1 of INTERFACE; ends with a newline.
std::string to_text(const Manifest& manifest);

/// TeX of the equations a stage shows at a step (1-based): those of the steps up to it.
std::vector<std::string> tex_shown(const Stage& stage, int step);

/// Success if `folder` has no manifest, or one made from the same lesson text and options; otherwise the
/// error says what differs.
Status may_export_into(const std::filesystem::path& folder, const std::string& lesson_sha256,
                       const nlohmann::ordered_json& options);

}  // namespace polhode
