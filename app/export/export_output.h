// SPDX-License-Identifier: MIT
// Where the files of an export go, and who makes them.
#pragma once

#include "app/export/folder/shard.h"
#include "base/files/atomic_file.h"
#include "render/gl/context/context.h"

#include <filesystem>
#include <string>
#include <vector>

namespace polhode {

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

}  // namespace polhode
