// SPDX-License-Identifier: MIT
#include "render/image/png_summary.h"

#include "base/files/file_bytes.h"
#include "render/image/png_text.h"

#include <cmath>
#include <optional>

namespace polhode {
namespace {

std::string_view text_of(std::span<const std::uint8_t> data) {
  return {reinterpret_cast<const char*>(data.data()), data.size()};
}

// Takes what stands before the next zero byte.
std::optional<std::string_view> take_string(std::string_view& data) {
  const std::size_t end = data.find('\0');
  if (end == data.npos) return std::nullopt;
  const std::string_view taken = data.substr(0, end);
  data.remove_prefix(end + 1);
  return taken;
}

void add_latin1_text(std::string_view data, PngMetadata& metadata) {
  if (const auto keyword = take_string(data))
    metadata.text.emplace_back(utf8_from_latin1(*keyword), utf8_from_latin1(data));
}

// Keyword, whether and how it is compressed, language, keyword in that language, text.
void add_utf8_text(std::string_view data, PngMetadata& metadata) {
  const auto keyword = take_string(data);
  if (!keyword || data.size() < 2 || data[0] != 0) return;
  data.remove_prefix(2);
  if (take_string(data) && take_string(data))
    metadata.text.emplace_back(utf8_from_latin1(*keyword), std::string(data));
}

int dpi_of(std::span<const std::uint8_t> data) {
  constexpr std::size_t kBytes = 9;
  if (data.size() != kBytes || data[8] != 1) return 0;
  double per_metre = 0;
  for (const std::uint8_t byte : data.first(4)) per_metre = 256 * per_metre + byte;
  return static_cast<int>(std::lround(per_metre * kMetresPerInch));
}

}  // namespace

Result<PngSummary> summarize_png(std::span<const std::uint8_t> bytes) {
  const Result<PngChunks> png = read_png_chunks(bytes);
  if (!png) return failure(png.error());
  return summarize_png(*png);
}

PngSummary summarize_png(const PngChunks& png) {
  PngSummary summary{png.header.size, {}};
  for (const auto& [type, data] : png.chunks) {
    if (type == "tEXt") add_latin1_text(text_of(data), summary.metadata);
    if (type == "iTXt") add_utf8_text(text_of(data), summary.metadata);
    if (type == "pHYs") summary.metadata.dpi = dpi_of(data);
  }
  return summary;
}

Result<PngSummary> summarize_png_file(const std::filesystem::path& path) {
  const auto bytes = read_file_bytes(path);
  if (!bytes) return failure(bytes.error());
  return summarize_png(*bytes);
}

}  // namespace polhode
