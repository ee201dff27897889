// SPDX-License-Identifier: MIT
// The options of `polhode export`, from what was typed.
#pragma once

#include "app/export/export_plan.h"
#include "app/export/shard.h"
#include "base/files/atomic_file.h"
#include "render/gl/renderer.h"

#include <filesystem>
#include <string>
#include <vector>

namespace polhode {

/// As typed; empty where not given.
struct TypedExport {
  std::string lesson, folder;
  std::vector<std::string> stages;
  std::string each, what, size, fps, seconds, at, frames, background, theme, quality, text_size, dpi, png,
      sync, context;
  std::string film, deck, shard, jobs;
  bool skip_existing = false;
  std::vector<std::string> words;  ///< the command line, program and options, without --skip-existing
};

/// Of equations: 12 pt type has so many dots per inch where nothing else is said.
inline constexpr int kDefaultEquationDpi = 300;
/// Fewer give no legible formula.
inline constexpr int kFewestEquationDpi = 24;

/// @throws CommandError usage: what is malformed, out of range, or does not go with the kind of export.
ExportOptions export_options(const TypedExport& typed);

/// How and where files are written: what does not decide their bytes.
struct ExportOutput {
  std::filesystem::path folder;  ///< of the pictures
  bool keep_folder = true;       ///< false: pictures are there for film and deck alone, in FILE.parts
  std::string film, deck;        ///< files to make of the pictures; empty: none
  bool skip_existing = false;    ///< keep files that are, whole, the pictures they should be
  Shard shard;                   ///< the part of the pictures to make
  int jobs = 1;                  ///< processes
  /// The commands that finish an interrupted export: this part of it, and all of it.
  std::vector<std::string> resume, resume_all;
  Durability durability = Durability::rename_only;
  ContextKind context = ContextKind::any;
};
/// @throws CommandError usage
ExportOutput export_output(const TypedExport& typed);

/// Behind the pictures of an export.
Background background_of(const ExportOptions& options);

}  // namespace polhode
