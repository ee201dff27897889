// SPDX-License-Identifier: MIT
// Files that appear whole under their final name, or not at all.
#pragma once

#include "base/files/temporary_file.h"
#include "base/result.h"

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string_view>

namespace polhode {

/// What is certain when write_file_atomically returns. A killed process leaves no partial file either way.
enum class Durability {
  rename_only,  ///< a power cut may lose the file or leave it empty, until sync_folder
  sync,         ///< file and name are on disk: about 6 times fewer files a second
};

/// The operations of the file system, as POSIX has them: -1 and errno on failure. Tests make each of them
/// fail.
class FileOps {
 public:
  virtual ~FileOps() = default;
  virtual int open(const char* path, int flags, mode_t mode) = 0;
  virtual ssize_t write(int file, const void* bytes, std::size_t count) = 0;
  virtual int fsync(int file) = 0;
  virtual int syncfs(int file) = 0;
  virtual int close(int file) = 0;
  virtual int rename(const char* from, const char* to) = 0;
  virtual int unlink(const char* path) = 0;
  /// Here that of a file system without second names for a file: ENOSYS.
  virtual int link(const char* from, const char* to);
};

/// The real file system.
class PosixFileOps final : public FileOps {
 public:
  int open(const char* path, int flags, mode_t mode) override;
  ssize_t write(int file, const void* bytes, std::size_t count) override;
  int fsync(int file) override;
  int syncfs(int file) override;
  int close(int file) override;
  int rename(const char* from, const char* to) override;
  int unlink(const char* path) override;
  int link(const char* from, const char* to) override;
};

/// Writes to a temporary file in the same folder, then renames it over `path`. On failure the temporary file
/// is gone, `path` is as it was, and the error names path and reason. (One exception: Durability::sync
/// reports a folder that cannot be flushed although the file, whole, has its name by then.) Survives EINTR
/// and short writes. A symbolic link stays, what it points to is replaced; a device or pipe (/dev/null,
/// /dev/stdout) is written in place; a pipe that nobody reads is an error. What killed processes left
/// unfinished in the folder goes (left_behind.h).
Status write_file_atomically(const std::filesystem::path& path, std::span<const std::uint8_t> bytes,
                             Durability durability = Durability::rename_only);
Status write_file_atomically(FileOps& files, const std::filesystem::path& path,
                             std::span<const std::uint8_t> bytes, Durability durability);

/// The same for files of our own in a folder that others may write too: whatever stands under the name makes
/// way. A symbolic link is not followed, and neither device nor pipe is opened; a folder is an error. Such a
/// folder is cleared once, before its many files are written, by who writes them.
Status replace_file_atomically(const std::filesystem::path& path, std::span<const std::uint8_t> bytes,
                               Durability durability = Durability::rename_only);

/// A text as the bytes of the file that holds it; of a text that outlives them.
inline std::span<const std::uint8_t> bytes_of(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

/// Takes the next bytes of a file; a failure (a full disk) is to be passed on.
using AppendBytes = std::function<Status(std::span<const std::uint8_t>)>;

using FillFile = std::function<Status(const AppendBytes&)>;

/// The same for what is too large to hold in memory: `fill` gives the bytes piece by piece, and throws
/// nothing. If it fails, the error ends with its words, and `path` is as it was.
Status write_file_in_pieces(const std::filesystem::path& path, const FillFile& fill,
                            Durability durability = Durability::rename_only);
Status write_file_in_pieces(FileOps& files, const std::filesystem::path& path, const FillFile& fill,
                            Durability durability);

Status replace_file_in_pieces(const std::filesystem::path& path, const FillFile& fill,
                              Durability durability = Durability::rename_only);
Status replace_file_in_pieces(FileOps& files, const std::filesystem::path& path, const FillFile& fill,
                              Durability durability);

/// Flushes the file system that holds `folder` to disk (syncfs): call once after the last file of an export.
Status sync_folder(const std::filesystem::path& folder);
Status sync_folder(FileOps& files, const std::filesystem::path& folder);

}  // namespace polhode
