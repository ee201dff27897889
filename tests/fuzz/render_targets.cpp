// SPDX-License-Identifier: MIT
#include "render/image/png.h"
#include "render/image/png_chunks.h"
#include "render/image/png_pixels.h"
#include "render/image/png_summary.h"
#include "render/typeset/math/math.h"
#include "render/typeset/math/mathml.h"
#include "tests/fuzz/targets.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>

namespace polhode::fuzz {
namespace {

const Fonts& fonts() {
  static const Fonts kFonts = [] {
    auto opened = Fonts::open();
    if (!opened) throw std::runtime_error(opened.error());
    return std::move(*opened);
  }();
  return kFonts;
}

std::string finding_in_errors(const std::vector<TypeError>& errors, std::size_t size) {
  if (errors.empty()) return "refused without a reason";
  for (const TypeError& error : errors)
    if (error.offset > size || error.message.empty()) return "an error outside the formula, or without words";
  return {};
}

bool is_set(const DisplayList& list) {
  return std::isfinite(list.width) && std::isfinite(list.ascent) && std::isfinite(list.depth) &&
         std::all_of(list.glyphs.begin(), list.glyphs.end(),
                     [](const Glyph& g) { return std::isfinite(g.x) && std::isfinite(g.y) && g.size > 0.0; });
}

/// In display, in line, and broken into lines; and said. (What the formula states: the target formula.)
std::string finding_in_tex(std::string_view bytes) {
  const auto math = parse_math(bytes);
  if (!math.ok()) return finding_in_errors(math.error(), bytes.size());
  for (int i = 0; i < 3; ++i) {
    MathStyle style;
    style.size = 30.0;
    style.display = i > 0;
    style.line_width = i == 2 ? 300.0 : 0.0;
    const auto list = set_math(*math, style, fonts());
    if (!list.ok()) {
      if (std::string finding = finding_in_errors(list.error(), bytes.size()); !finding.empty())
        return finding;
    } else if (!is_set(*list)) {
      return "a place that is no number";
    }
  }
  static_cast<void>(mathml(*math, MathMlStyle{}));
  return {};
}

std::span<const std::uint8_t> bytes_in(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

/// The same chunks with check sums that are right: otherwise nothing behind them would ever be reached.
std::string with_check_sums(std::string_view png) {
  constexpr std::size_t kSignature = 8, kLength = 4, kType = 4, kSum = 4;
  std::string mended(png);
  const auto number_at = [&](std::size_t at) {
    std::size_t number = 0;
    for (std::size_t i = at; i < at + kLength; ++i)
      number = number << 8 | static_cast<unsigned char>(mended[i]);
    return number;
  };
  for (std::size_t at = kSignature; at + kLength + kType + kSum <= mended.size();) {
    const std::size_t length = number_at(at), room = mended.size() - at - kLength - kType - kSum;
    if (length > room) break;
    const auto checked = bytes_in(mended).subspan(at + kLength, kType + length);
    const auto sum = crc32(0, checked.data(), static_cast<uInt>(checked.size()));
    for (std::size_t i = 0; i < kSum; ++i)
      mended[at + kLength + kType + length + i] = static_cast<char>(sum >> (24 - 8 * i));
    at += kLength + kType + length + kSum;
  }
  return mended;
}

std::string finding_in_whole_png(std::string_view png) {
  const auto chunks = read_png_chunks(bytes_in(png));
  const bool is_complete = chunks && check_png_pixels(*chunks).ok();
  const auto decoded = decode_png(bytes_in(png));
  if (decoded) {
    const Size size = decoded->image.size;
    if (decoded->image.rgba.size() !=
        4 * static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height))
      return "an image of another size than it says";
  } else if (decoded.error().empty()) {
    return "refused without a reason";
  }
  if (is_complete && summarize_png(*chunks).size != chunks->header.size) return "two sizes";
  return {};
}

std::string finding_in_png(std::string_view bytes) {
  if (std::string finding = finding_in_whole_png(bytes); !finding.empty()) return finding;
  return finding_in_whole_png(with_check_sums(bytes));
}

constexpr std::array<Target, 2> kTargets = {{{"png", finding_in_png}, {"tex", finding_in_tex}}};

}  // namespace

std::span<const Target> render_targets() { return kTargets; }

}  // namespace polhode::fuzz
