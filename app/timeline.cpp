// SPDX-License-Identifier: MIT
#include "app/timeline.h"

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

  // product + rest = A·shown_s exactly; n·B is a whole number below 2⁵³, and its difference from the product
  // is exact because the two are near.
  const double rest = std::fma(A, shown_s, -product);
  auto n = static_cast<std::int64_t>(std::floor(product / B + 0.5));
  const auto beyond = [&](std::int64_t m, double half) {
    return (product - static_cast<double>(m) * B - half * B) + rest;
  };
  if (n > 0 && beyond(n, -0.5) < 0) --n;
  if (beyond(n, 0.5) >= 0) ++n;
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
