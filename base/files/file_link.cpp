// SPDX-License-Identifier: MIT
#include "base/files/file_link.h"

#include "base/files/reason_of.h"
#include "base/files/temporary_file.h"

#include <cerrno>
#include <system_error>

namespace polhode {
namespace {

namespace fs = std::filesystem;

bool has_no_links(int error) {
  return error == EPERM || error == EOPNOTSUPP || error == ENOSYS || error == EMLINK;
}

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

// A second name that no other writer uses; empty, and errno, if there can be none.
fs::path temporary_link(FileOps& files, const fs::path& same, const fs::path& folder) {
  for (int i = 0; i < kMaxTemporaryNames; ++i) {
    fs::path temporary = folder / temporary_name(i);
    if (files.link(same.c_str(), temporary.c_str()) == 0) return temporary;
    if (errno != EEXIST) break;
  }
  return {};
}

}  // namespace

Status link_file_atomically(FileOps& files, const fs::path& same, const fs::path& path) {
  const auto cannot_link = [&](int error) {
    return failure("Cannot write " + path.string() + ": " + reason_of(error) + ".");
  };
  const fs::path temporary = temporary_link(files, same, folder_of(path));
  if (temporary.empty()) return cannot_link(errno);
  const int error = files.rename(temporary.c_str(), path.c_str()) == 0 ? 0 : errno;
  // POSIX: a rename between two names of one file does nothing, and leaves both.
  const bool removed = files.unlink(temporary.c_str()) == 0 || errno == ENOENT;
  if (error != 0) return cannot_link(error);
  if (!removed) return cannot_link(errno);
  return success();
}

Result<bool> create_file_atomically(FileOps& files, const fs::path& path,
                                    std::span<const std::uint8_t> bytes) {
  std::error_code error;
  if (fs::exists(fs::symlink_status(path, error))) return false;
  // Of the names of one process the one that no other function asks for.
  const fs::path whole = folder_of(path) / temporary_name(kMaxTemporaryNames);
  const FillFile fill = [&](const AppendBytes& append) { return append(bytes); };
  const Status written = replace_file_in_pieces(files, whole, fill, Durability::sync);
  if (!written) return failure(written.error());
  const int link_error = files.link(whole.c_str(), path.c_str()) == 0 ? 0 : errno;
  if (has_no_links(link_error)) {
    if (files.rename(whole.c_str(), path.c_str()) == 0) return true;
    const std::string reason = reason_of(errno);
    files.unlink(whole.c_str());
    return failure("Cannot write " + path.string() + ": " + reason + ".");
  }
  files.unlink(whole.c_str());
  if (link_error == EEXIST) return false;
  if (link_error != 0) return failure("Cannot write " + path.string() + ": " + reason_of(link_error) + ".");
  return true;
}

}  // namespace polhode
