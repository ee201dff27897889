// SPDX-License-Identifier: MIT
// Preloaded into the program (LD_PRELOAD): one of the operations on files of a folder fails, as on a full or
// broken disk. What the standard library does on the program's behalf is among them.
//
//   POLHODE_FAULT_FOLDER  the folder, absolute; its files and folders, and those in them, are watched
//   POLHODE_FAULT_AT      which operation fails, from 1; 0: none
//   POLHODE_FAULT_COUNT   a file outside the folder: how many there were, written when the program ends
//
// Operations on names and on what was opened by them: open, read, write, fsync, close, rename, remove, link,
// mkdir, flock. A file that cannot be closed is closed all the same, as Linux does. Programs that this one
// starts are not touched.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

constexpr std::size_t kMostFiles = 4096;
// Without constructors: other libraries may open files before this one begins, and after it has ended.
std::array<char, 4096> folder{}, count_file{};
std::atomic<long> count{0};
long fail_at = 0;
std::array<std::atomic<bool>, kMostFiles> watched{};

void take(const char* name, std::array<char, 4096>& to) {
  const char* value = std::getenv(name);
  if (value) std::strncpy(to.data(), value, to.size() - 1);
}

__attribute__((constructor)) void begin() {
  const char* at = std::getenv("POLHODE_FAULT_AT");
  fail_at = at ? std::atol(at) : 0;
  take("POLHODE_FAULT_COUNT", count_file);
  take("POLHODE_FAULT_FOLDER", folder);
  unsetenv("LD_PRELOAD");
}

template <class Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

__attribute__((destructor)) void end() {
  if (count_file[0] == '\0') return;
  folder[0] = '\0';
  if (FILE* file = next<FILE*(const char*, const char*)>("fopen")(count_file.data(), "w")) {
    std::fprintf(file, "%ld", count.load());
    std::fclose(file);
  }
}

/// Whether this operation is the one.
bool fails(int error) {
  if (++count != fail_at) return false;
  errno = error;
  return true;
}

bool is_watched(const char* path) {
  const std::size_t length = std::strlen(folder.data());
  return length > 0 && path && std::strncmp(path, folder.data(), length) == 0 &&
         (path[length] == '/' || path[length] == '\0');
}

bool is_watched(int file) {
  return file >= 0 && static_cast<std::size_t>(file) < kMostFiles && watched[static_cast<std::size_t>(file)];
}

int opened(int file, bool is_ours) {
  if (file >= 0 && static_cast<std::size_t>(file) < kMostFiles)
    watched[static_cast<std::size_t>(file)] = is_ours;
  return file;
}

mode_t mode_in(int flags, va_list arguments) {
  return (flags & (O_CREAT | O_TMPFILE)) != 0 ? static_cast<mode_t>(va_arg(arguments, int)) : 0;
}

int open_as(const char* name, const char* path, int flags, mode_t mode) {
  const bool is_ours = is_watched(path);
  if (is_ours && fails((flags & O_CREAT) != 0 ? ENOSPC : EIO)) return -1;
  return opened(next<int(const char*, int, mode_t)>(name)(path, flags, mode), is_ours);
}

FILE* fopen_as(const char* name, const char* path, const char* how) {
  const bool is_ours = is_watched(path);
  if (is_ours && fails(EIO)) return nullptr;
  FILE* file = next<FILE*(const char*, const char*)>(name)(path, how);
  if (file) opened(fileno(file), is_ours);
  return file;
}

}  // namespace

extern "C" {

int open(const char* path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = mode_in(flags, arguments);
  va_end(arguments);
  return open_as("open", path, flags, mode);
}

int open64(const char* path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = mode_in(flags, arguments);
  va_end(arguments);
  return open_as("open64", path, flags, mode);
}

FILE* fopen(const char* path, const char* how) { return fopen_as("fopen", path, how); }
FILE* fopen64(const char* path, const char* how) { return fopen_as("fopen64", path, how); }

int close(int file) {
  const bool is_ours = is_watched(file);
  opened(file, false);
  const int closed = next<int(int)>("close")(file);
  return is_ours && fails(EIO) ? -1 : closed;
}

int fclose(FILE* file) {
  const bool is_ours = is_watched(fileno(file));
  opened(fileno(file), false);
  const int closed = next<int(FILE*)>("fclose")(file);
  return is_ours && fails(EIO) ? EOF : closed;
}

ssize_t read(int file, void* bytes, size_t most) {
  if (is_watched(file) && fails(EIO)) return -1;
  return next<ssize_t(int, void*, size_t)>("read")(file, bytes, most);
}

ssize_t write(int file, const void* bytes, size_t most) {
  if (is_watched(file) && fails(ENOSPC)) return -1;
  return next<ssize_t(int, const void*, size_t)>("write")(file, bytes, most);
}

ssize_t writev(int file, const iovec* parts, int most) {
  if (is_watched(file) && fails(ENOSPC)) return -1;
  return next<ssize_t(int, const iovec*, int)>("writev")(file, parts, most);
}

int fsync(int file) {
  if (is_watched(file) && fails(EIO)) return -1;
  return next<int(int)>("fsync")(file);
}

int syncfs(int file) {
  if (is_watched(file) && fails(EIO)) return -1;
  return next<int(int)>("syncfs")(file);
}

int flock(int file, int operation) {
  if (is_watched(file) && fails(EIO)) return -1;
  return next<int(int, int)>("flock")(file, operation);
}

int rename(const char* from, const char* to) {
  if (is_watched(to) && fails(ENOSPC)) return -1;
  return next<int(const char*, const char*)>("rename")(from, to);
}

int link(const char* from, const char* to) {
  if (is_watched(to) && fails(ENOSPC)) return -1;
  return next<int(const char*, const char*)>("link")(from, to);
}

int unlink(const char* path) {
  if (is_watched(path) && fails(EIO)) return -1;
  return next<int(const char*)>("unlink")(path);
}

int remove(const char* path) {
  if (is_watched(path) && fails(EIO)) return -1;
  return next<int(const char*)>("remove")(path);
}

int mkdir(const char* path, mode_t mode) {
  if (is_watched(path) && fails(ENOSPC)) return -1;
  return next<int(const char*, mode_t)>("mkdir")(path, mode);
}

}  // extern "C"
