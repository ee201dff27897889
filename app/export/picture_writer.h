// SPDX-License-Identifier: MIT
// Pictures become files in a second thread, while the next one is drawn.
#pragma once

#include "app/export/folder/manifest.h"
#include "base/files/atomic_file.h"
#include "base/result.h"
#include "render/image/png.h"

#include <condition_variable>
#include <deque>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace polhode {

/// A picture on its way to disk: pixels, or a file of outlines. One with neither is the same as the picture
/// put before it, and becomes a hard link to that one's file, where there can be one. A link or device that
/// already has its name is replaced, not followed.
struct PictureFile {
  std::string name;
  std::optional<Image> image{};
  PngMetadata metadata{};
  std::string outlines{};  ///< the bytes of the file; empty: it is made of the image
};

/// Encodes and writes in the order of put(). Holds kWaiting pictures at most besides the one it encodes, so
/// that memory does not grow with the number of pictures. The thread touches PNG and files, nothing else: no
/// OpenGL, no fonts.
class PictureWriter {
 public:
  static constexpr std::size_t kWaiting = 1;

  PictureWriter(std::filesystem::path folder, PngPacking packing, Durability durability);
  /// Drops what still waits.
  ~PictureWriter();
  PictureWriter(const PictureWriter&) = delete;
  PictureWriter& operator=(const PictureWriter&) = delete;

  /// Takes a picture as soon as there is room. After a failure nothing more is written: its error, which is
  /// the first one, comes back from every later call.
  Status put(PictureFile&& picture);
  /// Waits until everything that was put has its final name.
  Status finish();
  /// Of what was written, after finish().
  const Checksums& checksums() const { return checksums_; }

 private:
  void work();
  Status write(PictureFile&& picture);

  const std::filesystem::path folder_;
  const Durability durability_;
  // These the thread alone uses, until finish() has waited for it.
  PngEncoder encoder_;
  std::string outlines_;
  std::span<const std::uint8_t> bytes_{};  ///< of the file written last; in encoder_, or in outlines_
  std::string last_;                       ///< name of that file
  Checksums checksums_;                    ///< of all files written

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<PictureFile> waiting_;
  bool writing_ = false;
  bool stop_ = false;
  Status status_ = success();
  std::thread thread_;  // last: it uses the others from its first moment
};

}  // namespace polhode
