// SPDX-License-Identifier: MIT
#include "base/files/atomic_file.h"

#include "base/files/left_behind.h"
#include "base/files/reason_of.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>

namespace polhode {
namespace {

namespace fs = std::filesystem;

constexpr mode_t kMode = 0666;  // less the user's umask

Failure<std::string> cannot_write(const fs::path& path, const std::string& reason) {
  const char* end = reason.ends_with('.') ? "" : ".";
  return failure("Cannot write " + path.string() + ": " + reason + end);
}

// Repeats a call that a signal interrupted.
template <class Call>
auto retry(Call call) {
  for (;;) {
    const auto result = call();
    if (result != -1 || errno != EINTR) return result;
  }
}

// 0, or the errno of the write that failed.
int write_all(FileOps& files, int file, std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = retry([&] { return files.write(file, bytes.data(), bytes.size()); });
    if (written < 0) return errno;
    if (written == 0) return EIO;  // a disk that takes nothing would keep us here for ever
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return 0;
}

// Linux has closed the file even if a signal interrupted close.
int close_file(FileOps& files, int file) {
  const bool closed = files.close(file) == 0 || errno == EINTR;
  return closed ? 0 : errno;
}

// Writes and closes an open file; the first error is the reason alone.
Status fill_and_close(FileOps& files, int file, const FillFile& fill, bool sync) {
  int error = 0;
  const AppendBytes append = [&](std::span<const std::uint8_t> bytes) -> Status {
    if (error == 0) error = write_all(files, file, bytes);
    if (error != 0) return failure(reason_of(error));
    return success();
  };
  Status filled = success();
  try {
    filled = fill(append);
  } catch (...) {
    close_file(files, file);
    throw;
  }
  if (filled && error == 0 && sync && retry([&] { return files.fsync(file); }) != 0) error = errno;
  const int close_error = close_file(files, file);
  if (error == 0 && filled) error = close_error;
  if (error != 0) return failure(reason_of(error));
  return filled;
}

FillFile all_at_once(std::span<const std::uint8_t> bytes) {
  return [bytes](const AppendBytes& append) { return append(bytes); };
}

struct Temporary {
  fs::path path;
  int file = -1;
  int error = 0;
};

// A short name of its own: the final name may already be as long as names can be.
Temporary create_temporary(FileOps& files, const fs::path& folder) {
  Temporary made;
  for (int i = 0; i < kMaxTemporaryNames; ++i) {
    made.path = folder / temporary_name(i);
    made.file =
        retry([&] { return files.open(made.path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kMode); });
    made.error = made.file < 0 ? errno : 0;
    if (made.error != EEXIST) break;
  }
  return made;
}

Status give_up(FileOps& files, const fs::path& path, const fs::path& temporary, std::string reason) {
  if (retry([&] { return files.unlink(temporary.c_str()); }) != 0)
    reason += "; the unfinished " + temporary.string() + " cannot be removed either: " + reason_of(errno);
  return cannot_write(path, reason);
}

// 0, or the errno of flushing the folder's list of names.
int flush_names(FileOps& files, const fs::path& folder) {
  const int file = retry([&] { return files.open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC, 0); });
  if (file < 0) return errno;
  // EINVAL: a file system that keeps names safe by itself has no fsync for folders.
  const bool flushed = retry([&] { return files.fsync(file); }) == 0 || errno == EINVAL;
  const int error = flushed ? 0 : errno;
  const int close_error = close_file(files, file);
  return error != 0 ? error : close_error;
}

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

Status replace(FileOps& files, const fs::path& path, const FillFile& fill, Durability durability) {
  const bool sync = durability == Durability::sync;
  const Temporary temporary = create_temporary(files, folder_of(path));
  if (temporary.file < 0) return cannot_write(path, reason_of(temporary.error));
  Status filled = success();
  try {
    filled = fill_and_close(files, temporary.file, fill, sync);
  } catch (...) {
    files.unlink(temporary.path.c_str());
    throw;
  }
  if (!filled) return give_up(files, path, temporary.path, filled.error());
  if (retry([&] { return files.rename(temporary.path.c_str(), path.c_str()); }) != 0)
    return give_up(files, path, temporary.path, reason_of(errno));
  const int names_error = sync ? flush_names(files, folder_of(path)) : 0;
  if (names_error != 0)
    return failure("Cannot flush the folder of " + path.string() + ": " + reason_of(names_error) + ".");
  return success();
}

// Opening a pipe that nobody reads would wait for ever, even after a signal; writing waits for the reader.
Status write_in_place(FileOps& files, const fs::path& path, bool is_pipe, const FillFile& fill) {
  const int flags = O_WRONLY | O_CLOEXEC | (is_pipe ? O_NONBLOCK : 0);
  const int file = retry([&] { return files.open(path.c_str(), flags, 0); });
  if (file < 0 && is_pipe && errno == ENXIO)
    return cannot_write(path, "nobody reads from this pipe; start its reader first");
  if (file < 0) return cannot_write(path, reason_of(errno));
  if (is_pipe && ::fcntl(file, F_SETFL, O_WRONLY) != 0) {
    const int error = errno;
    close_file(files, file);
    return cannot_write(path, reason_of(error));
  }
  const Status filled = fill_and_close(files, file, fill, false);
  if (!filled) return cannot_write(path, filled.error());
  return success();
}

}  // namespace

int PosixFileOps::open(const char* path, int flags, mode_t mode) { return ::open(path, flags, mode); }
ssize_t PosixFileOps::write(int file, const void* bytes, std::size_t count) {
  return ::write(file, bytes, count);
}
int PosixFileOps::fsync(int file) { return ::fsync(file); }
int PosixFileOps::syncfs(int file) { return ::syncfs(file); }
int PosixFileOps::close(int file) { return ::close(file); }
int PosixFileOps::rename(const char* from, const char* to) { return std::rename(from, to); }
int PosixFileOps::unlink(const char* path) { return ::unlink(path); }
int PosixFileOps::link(const char* from, const char* to) { return ::link(from, to); }

int FileOps::link(const char*, const char*) {
  errno = ENOSYS;
  return -1;
}

Status write_file_atomically(const fs::path& path, std::span<const std::uint8_t> bytes,
                             Durability durability) {
  PosixFileOps files;
  return write_file_atomically(files, path, bytes, durability);
}

Status write_file_atomically(FileOps& files, const fs::path& path, std::span<const std::uint8_t> bytes,
                             Durability durability) {
  return write_file_in_pieces(files, path, all_at_once(bytes), durability);
}

Status replace_file_atomically(const fs::path& path, std::span<const std::uint8_t> bytes,
                               Durability durability) {
  return replace_file_in_pieces(path, all_at_once(bytes), durability);
}

Status replace_file_in_pieces(const fs::path& path, const FillFile& fill, Durability durability) {
  PosixFileOps files;
  return replace_file_in_pieces(files, path, fill, durability);
}

Status replace_file_in_pieces(FileOps& files, const fs::path& path, const FillFile& fill,
                              Durability durability) {
  if (!path.has_filename()) return cannot_write(path, "it names no file");
  return replace(files, path, fill, durability);
}

Status write_file_in_pieces(const fs::path& path, const FillFile& fill, Durability durability) {
  PosixFileOps files;
  return write_file_in_pieces(files, path, fill, durability);
}

Status write_file_in_pieces(FileOps& files, const fs::path& path, const FillFile& fill,
                            Durability durability) {
  if (!path.has_filename()) return cannot_write(path, "it names no file");
  std::error_code error;
  const fs::file_status found = fs::status(path, error);
  if (fs::is_directory(found)) return cannot_write(path, reason_of(EISDIR));
  if (fs::exists(found) && !fs::is_regular_file(found))
    return write_in_place(files, path, fs::is_fifo(found), fill);
  // /dev/stdout may lead to a file: replace what a link points to, never the link.
  const fs::path target = fs::is_symlink(path, error) ? fs::weakly_canonical(path, error) : path;
  if (error && target.empty()) return cannot_write(path, error.message());
  remove_left_behind_in(folder_of(target));
  return replace(files, target, fill, durability);
}

Status sync_folder(const fs::path& folder) {
  PosixFileOps files;
  return sync_folder(files, folder);
}

Status sync_folder(FileOps& files, const fs::path& folder) {
  const auto cannot_sync = [&](int error) {
    return failure("Cannot flush " + folder.string() + " to disk: " + reason_of(error) + ".");
  };
  const int file = retry([&] { return files.open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC, 0); });
  if (file < 0) return cannot_sync(errno);
  const int error = retry([&] { return files.syncfs(file); }) != 0 ? errno : 0;
  const int close_error = close_file(files, file);
  if (error != 0 || close_error != 0) return cannot_sync(error != 0 ? error : close_error);
  return success();
}

}  // namespace polhode
