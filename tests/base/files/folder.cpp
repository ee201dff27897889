// SPDX-License-Identifier: MIT
#include "tests/base/files/folder.h"

#include "base/files/temporary_file.h"

#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace polhode::test {

Folder::Folder() {
  std::string name = (std::filesystem::temp_directory_path() / "polhode-test-XXXXXX").string();
  if (!mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
  path_ = name;
}

Folder::~Folder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::vector<std::string> Folder::names() const {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(path_))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<std::uint8_t> bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void put(const std::filesystem::path& file, const std::vector<std::uint8_t>& bytes) {
  std::ofstream out(file, std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

std::string name_of_the_dead(int i) {
  int ends[2];
  if (pipe(ends) != 0) std::abort();
  const pid_t child = fork();
  if (child == 0) {
    const std::string name = temporary_name(i);
    _exit(write(ends[1], name.data(), name.size()) > 0 ? 0 : 1);
  }
  close(ends[1]);
  char name[256] = {};
  const ssize_t count = read(ends[0], name, sizeof name);
  close(ends[0]);
  waitpid(child, nullptr, 0);
  return {name, static_cast<std::size_t>(count)};
}

}  // namespace polhode::test
