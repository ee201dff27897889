// SPDX-License-Identifier: MIT
// Pictures to test with, and a folder that goes away.
#pragma once

#include "render/image/image.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace polhode::test {

/// Every pixel the same.
Image uniform(Size size, std::uint8_t r, std::uint8_t g, std::uint8_t b, std::uint8_t a = 255);

/// Gradients with the noise of a rendered scene; the same for the same arguments.
Image scenic(Size size, bool opaque);

/// A fresh empty folder, removed with all it holds.
class Folder {
 public:
  Folder();
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  /// Names of what is in it, hidden files too, sorted.
  std::vector<std::string> names() const;

 private:
  std::filesystem::path path_;
};

std::vector<std::uint8_t> bytes_of(const std::filesystem::path& file);
void put(const std::filesystem::path& file, const std::vector<std::uint8_t>& bytes);

}  // namespace polhode::test
