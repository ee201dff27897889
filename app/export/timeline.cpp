// SPDX-License-Identifier: MIT
#include "app/export/timeline.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

namespace polhode {

namespace {

/// Digits only: no sign, no blank.
std::optional<std::int64_t> natural(std::string_view text) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || value < 0 || text.front() == '-')
    return std::nullopt;
  return value;
}

std::optional<std::pair<std::int64_t, std::int64_t>> two_naturals(std::string_view text, char separator) {
  const auto at = text.find(separator);
  if (at == std::string_view::npos) return std::nullopt;
  const auto first = natural(text.substr(0, at));
  const auto second = natural(text.substr(at + 1));
  if (!first || !second) return std::nullopt;
  return std::pair{*first, *second};
}

}  // namespace

std::optional<FrameRate> frame_rate_from(std::string_view text) {
  auto terms = two_naturals(text, '/');
  if (!terms)
    if (const auto whole = natural(text)) terms = std::pair{*whole, std::int64_t{1}};
  if (!terms) return std::nullopt;
  const auto [frames, seconds] = *terms;
  if (std::min(frames, seconds) < 1 || std::max(frames, seconds) > kMaxFrameRateTerm) return std::nullopt;
  return FrameRate{frames, seconds};
}

std::string to_string(const FrameRate& rate) {
  return rate.seconds == 1 ? fmt::format("{}", rate.frames) : fmt::format("{}/{}", rate.frames, rate.seconds);
}

std::int64_t frame_count(const FrameRate& rate, double shown_s) {
  const auto A = static_cast<double>(rate.frames), B = static_cast<double>(rate.seconds);
  const double product = A * shown_s;
  if (!(product / B < static_cast<double>(kMaxFrames) + 0.5)) return kMaxFrames + 1;

  // product + rest = A·shown_s exactly. Where 2·product is near the whole number (2n ∓ 1)·B < 2⁵³, their
  // difference is exact; where it is not, its sign is sure.
  const double rest = std::fma(A, shown_s, -product);
  const auto at_least = [&](std::int64_t odd) {
    return (2 * product - static_cast<double>(odd) * B) + 2 * rest >= 0;
  };
  auto n = static_cast<std::int64_t>(product / B);
  if (!at_least(2 * n - 1)) --n;
  if (at_least(2 * n + 1)) ++n;
  return n;
}

double frame_time(const FrameRate& rate, std::int64_t k, double speed, double start_s) {
  const double shown_s = static_cast<double>(k * rate.seconds) / static_cast<double>(rate.frames);
  return start_s + shown_s * speed;
}

std::optional<FrameRange> frame_range_from(std::string_view text) {
  const auto ends = two_naturals(text, ':');
  if (!ends || ends->first >= ends->second) return std::nullopt;
  return FrameRange{ends->first, ends->second};
}

std::string zero_padded(std::int64_t number, std::int64_t last, int least) {
  const int digits = std::max(least, static_cast<int>(fmt::formatted_size("{}", last)));
  return fmt::format("{:0{}}", number, digits);
}

}  // namespace polhode
