// SPDX-License-Identifier: MIT
#include "app/window/desktop_watch.h"

#include <cstdlib>
#include <filesystem>
#include <utility>

namespace polhode {

namespace {

/// Where there is none dbus-send would start one.
bool has_session_bus() {
  if (const char* address = std::getenv("DBUS_SESSION_BUS_ADDRESS"); address != nullptr && *address != '\0')
    return true;
  const char* folder = std::getenv("XDG_RUNTIME_DIR");
  std::error_code unknown;
  return folder != nullptr && std::filesystem::exists(std::filesystem::path(folder) / "bus", unknown);
}

}  // namespace

void DesktopWatch::ask() {
  if (question_) return;
  if (has_session_bus())
    if (auto asked = BackgroundProgram::start(question_to_desktop(), true))
      question_ = std::move(asked).value();
  if (!question_ && !wishes_) wishes_ = DesktopWishes{};
}

const std::optional<DesktopWishes>& DesktopWatch::wishes() {
  const auto code = question_ ? question_->code() : std::nullopt;
  if (code == 0)
    wishes_ = wishes_in(question_->answer());
  else if (code && !wishes_)
    wishes_ = DesktopWishes{};
  if (code) question_.reset();
  return wishes_;
}

}  // namespace polhode
