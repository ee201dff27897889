// SPDX-License-Identifier: MIT
// Frames of a film: how many, at which time, under which number. Nothing is accumulated, so any frame can be
// made alone and is the same as in the whole film.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace polhode {

/// A/B frames per shown second, so that 30000/1001 is exact.
struct FrameRate {
  std::int64_t frames = 30;
  std::int64_t seconds = 1;
  bool operator==(const FrameRate&) const = default;
};
inline constexpr std::int64_t kMaxFrameRateTerm = 1'000'000;
inline constexpr std::int64_t kMaxFrames = 1'000'000;

/// "N" or "A/B", each 1…10⁶; nothing otherwise.
std::optional<FrameRate> frame_rate_from(std::string_view text);
/// "24" or "30000/1001".
std::string to_string(const FrameRate& rate);

/// round(fps · seconds), halves up, decided without rounding error. More than kMaxFrames gives kMaxFrames
/// + 1.
/// @param shown_s finite, ≥ 0
std::int64_t frame_count(const FrameRate& rate, double shown_s);

/// Simulated time of frame k: start + k·(B/A)·speed, s. k·B is exact; each of the three operations after it
/// rounds once.
/// @param speed simulated seconds per shown second
double frame_time(const FrameRate& rate, std::int64_t k, double speed, double start_s);

/// [begin, end) of 0-based numbers.
struct FrameRange {
  std::int64_t begin = 0;
  std::int64_t end = 0;
  bool operator==(const FrameRange&) const = default;
};
/// "A:B" with 0 ≤ A < B; nothing otherwise.
std::optional<FrameRange> frame_range_from(std::string_view text);

/// `number` in as many digits as the last number needs, at least `least`.
std::string zero_padded(std::int64_t number, std::int64_t last, int least = 1);

}  // namespace polhode
