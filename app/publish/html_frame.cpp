// SPDX-License-Identifier: MIT
#include "app/publish/html_frame.h"

#include <fmt/format.h>

#include <cmath>

namespace polhode {

std::string hex(const Color& color) {
  const auto level = [](float part) { return static_cast<int>(std::lround(part * 255)); };
  return fmt::format("#{:02x}{:02x}{:02x}", level(color.r), level(color.g), level(color.b));
}

Status append_frame(std::string_view frame, const AppendBytes& append,
                    const std::function<Status(const std::string& name)>& put) {
  for (std::size_t open = frame.find("{{"); open != std::string_view::npos; open = frame.find("{{")) {
    const std::size_t close = frame.find("}}", open);
    Status status = append(bytes_of(frame.substr(0, open)));
    if (status) status = put(std::string(frame.substr(open + 2, close - open - 2)));
    if (!status) return status;
    frame.remove_prefix(close + 2);
  }
  return append(bytes_of(frame));
}

}  // namespace polhode
