// SPDX-License-Identifier: MIT
// A bar on stderr for people who wait; nothing where stderr is not a terminal.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace polhode {

/// One line of text: `[######          ] 12/29 energy`, at most `columns` wide. `colored` adds terminal
/// colours.
std::string progress_line(std::int64_t done, std::int64_t total, std::string_view name, int columns,
                          bool colored);

/// Redraws itself in place and removes itself at the end. Colours obey NO_COLOR (https://no-color.org).
class ProgressBar {
 public:
  explicit ProgressBar(std::int64_t total);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(std::int64_t done, std::string_view name) const;

 private:
  std::int64_t total_;
  bool visible_;
  bool colored_;
};

}  // namespace polhode
