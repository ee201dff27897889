// SPDX-License-Identifier: MIT
// What a site is known to hold, and of what each file was made: site.json, beside the pages. By it a page
// that would come out the same is not drawn again, and files of lessons that are gone are found.
#pragma once

#include "base/files/atomic_file.h"
#include "base/result.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace polhode {

inline constexpr const char* kSiteRecordName = "site.json";

struct SiteFile {
  std::string made_of;  ///< SHA-256 of all that decides its bytes
  std::string sha256;   ///< of its bytes
  bool operator==(const SiteFile&) const = default;
};
/// By their names, without folder.
using SiteRecord = std::map<std::string, SiteFile>;

/// Of a folder; nothing where there is none. An error if there is one that is not ours, or damaged.
Result<std::optional<SiteRecord>> read_site_record(const std::filesystem::path& folder);
Status write_site_record(const std::filesystem::path& folder, const SiteRecord& record,
                         Durability durability);

/// Whether the file is recorded as made of this, and lies there as it was written.
bool is_there(const std::filesystem::path& folder, const SiteRecord& record, const std::string& file,
              const std::string& made_of);

}  // namespace polhode
