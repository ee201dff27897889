// SPDX-License-Identifier: MIT
// A program that runs beside a test, and is gone when the test is.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace polhode::window_test {

/// How long anything may take before a test gives up: a machine that is busy with other tests takes its time.
inline constexpr std::chrono::seconds kPatience{40};

/// Asks until it holds; false once patience is spent.
template <class F>
bool eventually(F&& holds, std::chrono::milliseconds patience = kPatience) {
  const auto end = std::chrono::steady_clock::now() + patience;
  while (!holds()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return true;
}

/// Added to the test's own; without a value: taken away.
using Environment = std::map<std::string, std::optional<std::string>>;

struct Start {
  std::vector<std::string> words;  ///< program, looked up in PATH, and arguments
  Environment environment{};
  std::filesystem::path folder = ".";                          ///< to run in
  std::filesystem::path out = "/dev/null", err = "/dev/null";  ///< files
  int kept_open = -1;  ///< a descriptor that it inherits, under the same number
};

class Child {
 public:
  explicit Child(const Start& start);
  /// Kills its process group.
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  pid_t id() const { return id_; }
  /// Exit code, 128 + n if signal n ended it; nothing while it runs.
  std::optional<int> code();
  /// Waits for the end; nothing if it does not come.
  std::optional<int> wait(std::chrono::milliseconds patience = kPatience);
  /// CPU time of all its threads so far, s (to 1/100).
  double cpu_s() const;

 private:
  pid_t id_ = -1;
  std::optional<int> code_;
};

/// Runs to its end. @throws std::runtime_error with what it said if it fails
std::string output_of(const std::vector<std::string>& words, const Environment& environment = {});

/// Whether PATH has such a program.
bool is_installed(const std::string& program);

}  // namespace polhode::window_test
