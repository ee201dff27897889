// SPDX-License-Identifier: MIT
// The pictures of an export, or a shard of them: drawn, written, and listed in a manifest.
#pragma once

#include "app/export/export_output.h"
#include "app/export/export_plan.h"
#include "app/export/folder/export_folder.h"
#include "app/page/loaded_lesson.h"
#include "base/interrupt.h"
#include "base/outcome.h"

#include <functional>

namespace polhode {

/// All outlive it.
struct PictureExport {
  const LoadedLesson& loaded;
  const ExportOptions& options;
  const ExportOutput& out;
  const ExportPlan& plan;
};

ExportIdentity identity_of(const LoadedLesson& loaded, const ExportOptions& options);

/// With the folders above it.
Status make_folder(const std::filesystem::path& folder);

/// Told before each picture: how many are there, and which comes next.
using TellProgress = std::function<void(std::size_t done, const std::string& next)>;

struct PicturesMade {
  std::size_t count = 0;     ///< that are there now, of this shard
  std::size_t kept = 0;      ///< of them those that were there before (--skip-existing)
  bool interrupted = false;  ///< then no manifest was written
  bool finished = false;     ///< manifest.json is there, hence all pictures of all shards are
  /// The driver that drew the pictures of the manifest, on other machines too; several: join_renderers.
  std::string renderer;
  Checksums checksums;  ///< of the pictures of this shard
};

/// In this process: opens OpenGL, checks everything that can be checked without drawing, and only then
/// writes. Two pictures are in the making at a time (a third waits), so memory does not depend on their
/// number.
Outcome<PicturesMade> make_pictures(const PictureExport& e, const TellProgress& tell,
                                    const InterruptWatch& watch);

}  // namespace polhode
