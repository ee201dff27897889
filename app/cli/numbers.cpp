// SPDX-License-Identifier: MIT
#include "app/cli/numbers.h"

#include "app/cli/exit_codes.h"
#include "base/numbers.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>

namespace polhode {

namespace {

std::optional<long long> whole(std::string_view text) {
  long long value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace

double finite_number(std::string_view option, std::string_view text) {
  const std::optional<double> value = parse_number(text);
  if (!value)
    throw CommandError(
        ExitCode::usage,
        fmt::format("{}: \"{}\" is not a number; write it like 0.25, 2.5e-3 or 0x1.8p+1", option, text));
  if (!std::isfinite(*value))
    throw CommandError(ExitCode::invalid, fmt::format("{}: {} is not a finite number", option, text));
  return *value;
}

std::vector<double> finite_numbers(std::string_view option, std::string_view text) {
  std::vector<double> values;
  for (std::string_view part : split(text, ',')) values.push_back(finite_number(option, part));
  return values;
}

Vec3 finite_vector(std::string_view option, std::string_view text) {
  const std::vector<double> values = finite_numbers(option, text);
  if (values.size() != 3)
    throw CommandError(ExitCode::usage,
                       fmt::format("{}: \"{}\" has {} number{}; three are needed, like 1,1.75,2.5", option,
                                   text, values.size(), values.size() == 1 ? "" : "s"));
  return {values[0], values[1], values[2]};
}

long long whole_number(std::string_view option, std::string_view text, long long smallest,
                       long long largest) {
  const std::optional<long long> value = whole(text);
  if (!value || *value < smallest || *value > largest)
    throw CommandError(ExitCode::usage, fmt::format("{}: \"{}\" is not a whole number from {} to {}", option,
                                                    text, smallest, largest));
  return *value;
}

Size picture_size(std::string_view option, std::string_view text, int largest) {
  const std::vector<std::string_view> parts = split(text, 'x');
  const auto width = parts.size() == 2 ? whole(parts[0]) : std::nullopt;
  const auto height = parts.size() == 2 ? whole(parts[1]) : std::nullopt;
  if (!width || !height)
    throw CommandError(
        ExitCode::usage,
        fmt::format("{}: \"{}\" is not a size in pixels; write it like 1920x1080, or 16:9, 4k, 4:3, a4",
                    option, text));
  if (*width < 1 || *height < 1 || *width > largest || *height > largest)
    throw CommandError(ExitCode::usage,
                       fmt::format("{}: {}x{} pixels are impossible; each side may have 1 to {}", option,
                                   *width, *height, largest));
  return {static_cast<int>(*width), static_cast<int>(*height)};
}

}  // namespace polhode
