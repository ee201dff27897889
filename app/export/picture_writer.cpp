// SPDX-License-Identifier: MIT
#include "app/export/picture_writer.h"

#include "base/files/file_link.h"
#include "base/sha256.h"

#include <cassert>
#include <exception>
#include <utility>

namespace polhode {

PictureWriter::PictureWriter(std::filesystem::path folder, PngPacking packing, Durability durability)
    : folder_(std::move(folder)), durability_(durability), encoder_(packing), thread_([this] { work(); }) {}

PictureWriter::~PictureWriter() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

Status PictureWriter::put(PictureFile&& picture) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return waiting_.size() < kWaiting || !status_; });
  if (status_) waiting_.push_back(std::move(picture));
  changed_.notify_all();
  return status_;
}

Status PictureWriter::finish() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return (waiting_.empty() && !writing_) || !status_; });
  return status_;
}

void PictureWriter::work() {
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [&] { return !waiting_.empty() || stop_; });
    if (stop_) return;
    PictureFile picture = std::move(waiting_.front());
    waiting_.pop_front();
    writing_ = true;
    changed_.notify_all();
    lock.unlock();
    Status status = write(std::move(picture));
    lock.lock();
    writing_ = false;
    if (!status) {
      status_ = std::move(status);
      waiting_.clear();
    }
    changed_.notify_all();
    if (!status_) return;
  }
}

Status PictureWriter::write(PictureFile&& picture) try {
  const std::filesystem::path path = folder_ / picture.name;
  const bool is_new = picture.image || !picture.outlines.empty();
  if (!picture.outlines.empty()) {
    outlines_ = std::move(picture.outlines);
    bytes_ = bytes_of(outlines_);
  } else if (picture.image) {
    const auto bytes = encoder_.encode(*picture.image, picture.metadata);
    if (!bytes) return failure("Cannot write " + path.string() + ": " + bytes.error());
    bytes_ = *bytes;
  }
  assert(!bytes_.empty());
  checksums_[picture.name] = is_new ? sha256_hex(bytes_) : checksums_.at(last_);
  // A second name of the file before it. Where there can be none, or it is to be flushed: bytes of its own.
  const std::filesystem::path before = folder_ / std::exchange(last_, picture.name);
  if (!is_new && durability_ == Durability::rename_only) {
    PosixFileOps files;
    if (link_file_atomically(files, before, path)) return success();
  }
  return replace_file_atomically(path, bytes_, durability_);
} catch (const std::exception& error) {  // out of memory: it may not leave the thread
  return failure("Cannot write " + picture.name + ": " + error.what());
}

}  // namespace polhode
