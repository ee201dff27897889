// SPDX-License-Identifier: MIT
// An export as it lies in its folder, against what its manifest, or the marker of an unfinished one,
// promises.
#pragma once

#include "base/result.h"

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace polhode {

struct FolderCheck {
  std::string lesson_id;
  bool finished = false;     ///< it has a manifest.json, and no process has begun to change that
  std::size_t expected = 0;  ///< files, the manifest not counted
  /// Names without folder, in the order of the plan; left_over and foreign in that of the alphabet. A file
  /// under the name of a picture that holds another one is foreign.
  std::vector<std::string> missing, damaged, foreign, left_over;
  std::map<std::string, std::string> reasons;  ///< of some of them
  std::vector<std::string> shards_finished;    ///< "2-of-4": of an unfinished export
  std::vector<std::string> resume;  ///< the command that makes it whole; empty: it is, or nobody knows

  bool ok() const {
    return finished && missing.empty() && damaged.empty() && foreign.empty() && left_over.empty();
  }
};

/// Reads every file; fails if the folder cannot be read.
Result<FolderCheck> check_folder(const std::filesystem::path& folder);

}  // namespace polhode
