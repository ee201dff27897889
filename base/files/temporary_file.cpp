// SPDX-License-Identifier: MIT
#include "base/files/temporary_file.h"

#include "base/files/left_behind.h"

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <optional>

namespace polhode {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kSuffix = ".part";
constexpr std::size_t kHostDigits = 8;

// FNV-1a: short, and good enough to tell the machines of a cluster apart.
std::uint32_t hash(std::string_view text) {
  std::uint32_t sum = 2166136261u;
  for (const char c : text) sum = (sum ^ static_cast<unsigned char>(c)) * 16777619u;
  return sum;
}

// A process number means something only where it was given out: in one boot of one kernel, in one namespace.
std::string place_of_processes() {
  std::string boot;
  std::ifstream("/proc/sys/kernel/random/boot_id") >> boot;
  std::error_code none;
  const std::string space = fs::read_symlink("/proc/self/ns/pid", none).string();
  std::array<char, 256> host{};
  if (boot.empty() && ::gethostname(host.data(), host.size() - 1) == 0) boot = host.data();
  std::array<char, kHostDigits + 1> digits{};
  std::snprintf(digits.data(), digits.size(), "%08x", hash(boot + ' ' + space));
  return digits.data();
}

const std::string& here() {
  static const std::string kHere = place_of_processes();
  return kHere;
}

// The process, if the name is one that temporary_name gives here.
std::optional<pid_t> process_here(std::string_view name) {
  const std::string start = kTemporaryPrefix + here() + '-';
  if (!name.starts_with(start)) return std::nullopt;
  name.remove_prefix(start.size());
  pid_t pid = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), pid);
  const bool read = error == std::errc() && end != name.data() + name.size() && *end == '-';
  return read && pid > 0 ? std::optional(pid) : std::nullopt;
}

bool is_gone(pid_t process) { return ::kill(process, 0) != 0 && errno == ESRCH; }

bool is_older(const fs::path& file, std::chrono::hours age) {
  std::error_code error;
  const auto written = fs::last_write_time(file, error);
  return !error && fs::file_time_type::clock::now() - written > age;
}

}  // namespace

std::string temporary_name(int i) {
  return kTemporaryPrefix + here() + '-' + std::to_string(::getpid()) + '-' + std::to_string(i) +
         std::string(kSuffix);
}

bool is_temporary_name(std::string_view name) {
  return name.starts_with(kTemporaryPrefix) && name.ends_with(kSuffix);
}

std::vector<fs::path> left_behind_in(const fs::path& folder) {
  using namespace std::chrono_literals;
  std::vector<fs::path> found;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (!is_temporary_name(name)) continue;
    const auto process = process_here(name);
    const bool is_left =
        process ? is_gone(*process) || is_older(entry->path(), 24h) : is_older(entry->path(), 1h);
    if (is_left) found.push_back(entry->path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

void remove_left_behind_in(const fs::path& folder) {
  std::error_code ignored;
  for (const fs::path& file : left_behind_in(folder)) fs::remove(file, ignored);
}

}  // namespace polhode
