// SPDX-License-Identifier: MIT
// A zip archive that is written from its first byte to its last, as others want their parts in it. One file
// of ours includes libarchive's headers.
#pragma once

#include "base/files/atomic_file.h"
#include "base/result.h"

#include <memory>
#include <string>
#include <string_view>

struct archive;

namespace polhode {

/// The same parts give the same bytes: no part has a time, an owner or a place of its own but the first
/// moment that a zip can name (1980-01-01) and none.
class ZipFile {
 public:
  /// `append` outlives it, and is given the bytes as they come: one part is in memory at a time.
  explicit ZipFile(const AppendBytes& append);
  /// An archive that was not finished ends in the middle.
  ~ZipFile();
  ZipFile(const ZipFile&) = delete;
  ZipFile& operator=(const ZipFile&) = delete;

  /// @param name with slashes, in ASCII; no two are alike
  Status add(const std::string& name, std::span<const std::uint8_t> bytes);
  Status add(const std::string& name, std::string_view text) { return add(name, bytes_of(text)); }
  /// The list of parts, which makes it an archive.
  Status finish();

 private:
  struct Sink;
  Status failed() const;

  std::unique_ptr<Sink> sink_;
  archive* archive_ = nullptr;  ///< null: there is no memory for it, or it is finished
};

}  // namespace polhode
