// SPDX-License-Identifier: MIT
// Runs the built program as a user does and keeps what it said.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace polhode {

struct ProgramRun {
  int code = -1;  ///< exit code; 128 + n if signal n ended it
  std::string out, err;
};

struct RunOptions {
  std::map<std::string, std::string> environment;  ///< added to the test's own
  std::filesystem::path folder = ".";              ///< to run in
  std::string stdout_to;                           ///< a file instead of ProgramRun::out
  std::vector<std::string> wrapper;          ///< e.g. {"unshare", "-m", "sh", "-c", "… exec \"$@\"", "sh"}
  std::function<void(pid_t)> while_running;  ///< called once after the start
};

/// polhode with these arguments. A program that takes longer than two minutes is killed.
ProgramRun polhode(const std::vector<std::string>& arguments, const RunOptions& options = {});

/// A fresh folder that is removed at the end of its life.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

std::string text_of(const std::filesystem::path& path);
void write_text(const std::filesystem::path& path, const std::string& text);
/// Names of the entries of a folder, sorted; hidden ones too.
std::vector<std::string> names_in(const std::filesystem::path& folder);
/// tests/data/app/<name>
std::string test_lesson(const std::string& name);

}  // namespace polhode
