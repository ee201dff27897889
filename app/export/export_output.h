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
  bool keep_folder = true;     ///< false: the pictures, in FILE.parts, go when film and deck are made of them
  std::string film, deck;      ///< files to make of the pictures; empty: none
  bool live = false;           ///< slides of the deck can be played
  std::string live_file{};     ///< name of the program beside the deck; empty: the deck has it
  bool skip_existing = false;  ///< files that are already there, undamaged and right, are kept
  Shard shard;                 ///< the part of the pictures to make
  int jobs = 1;                ///< processes
  /// The commands that finish an interrupted export: this part of it, and all of it.
  std::vector<std::string> resume, resume_all;
  Durability durability = Durability::rename_only;
  ContextKind context = ContextKind::any;
};

}  // namespace polhode
