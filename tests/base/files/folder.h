// SPDX-License-Identifier: MIT
// A folder to test in that goes away, whole files as bytes, and what a killed process leaves.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace polhode::test {

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

/// The name of an unfinished file (temporary_name) as a process gives it that has ended since.
std::string name_of_the_dead(int i = 0);

}  // namespace polhode::test
