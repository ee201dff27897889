// SPDX-License-Identifier: MIT
#include "app/cli/progress.h"

#include "app/cli/message.h"
#include "base/printable.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>

namespace polhode {

namespace {

bool environment_has(const char* name) {
  const char* value = std::getenv(name);
  return value && *value;
}

bool dumb_terminal() {
  const char* name = std::getenv("TERM");
  return name && std::string_view(name) == "dumb";
}

int terminal_columns() {
  winsize size{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

}  // namespace

std::string progress_line(std::int64_t done, std::int64_t total, std::string_view name, int columns,
                          bool colored) {
  constexpr std::int64_t kBar = 30;
  const auto filled = static_cast<std::size_t>(total > 0 ? kBar * done / total : 0);
  const std::string full(filled, '#'), rest(static_cast<std::size_t>(kBar) - filled, ' ');
  const std::string counts = fmt::format(" {}/{} ", done, total);
  const std::size_t used = static_cast<std::size_t>(kBar) + 2 + counts.size();
  const auto room = static_cast<std::size_t>(std::max(0, columns - 1));
  const std::string shown(name.substr(0, room > used ? room - used : 0));
  return fmt::format("[{}{}{}{}]{}{}", colored ? "\x1b[32m" : "", full, colored ? "\x1b[0m" : "", rest,
                     counts, shown);
}

ProgressBar::ProgressBar(std::int64_t total)
    : total_(total),
      visible_(isatty(STDERR_FILENO) == 1 && !dumb_terminal()),
      colored_(!environment_has("NO_COLOR")) {}

ProgressBar::~ProgressBar() {
  if (visible_) steer_terminal("\r\x1b[K");
}

void ProgressBar::show(std::int64_t done, std::string_view name) const {
  if (!visible_) return;
  const std::string line = progress_line(done, total_, printable_line(name), terminal_columns(), colored_);
  steer_terminal("\r" + line + "\x1b[K");
}

}  // namespace polhode
