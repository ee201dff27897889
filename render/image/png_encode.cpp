// SPDX-License-Identifier: MIT
#include "render/image/packer.h"
#include "render/image/png.h"
#include "render/image/png_filter.h"
#include "render/image/png_text.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csetjmp>
#include <cstdio>
#include <new>

namespace polhode {
namespace {

constexpr std::size_t kMostIdatBytes = 8 << 20;
constexpr std::size_t kITxtBytes = 5;  // of an iTXt chunk besides keyword and text

// What libpng's callbacks need. Lives outside run(), which longjmp may leave.
struct Writer {
  std::vector<std::uint8_t> bytes;
  std::array<char, 128> error{};
};

void on_error(png_structp png, png_const_charp text) {
  auto* writer = static_cast<Writer*>(png_get_error_ptr(png));
  std::snprintf(writer->error.data(), writer->error.size(), "%s", text);
  png_longjmp(png, 1);
}

void on_warning(png_structp, png_const_charp) {}

void on_write(png_structp png, png_bytep data, std::size_t count) {
  auto* writer = static_cast<Writer*>(png_get_io_ptr(png));
  bool stored = true;
  try {
    writer->bytes.insert(writer->bytes.end(), data, data + count);
  } catch (const std::bad_alloc&) {
    stored = false;  // no exception may cross libpng, and no longjmp an exception's handler
  }
  if (!stored) png_error(png, "out of memory");
}

void on_flush(png_structp) {}

struct Handles {
  png_structp png = nullptr;
  png_infop info = nullptr;
  ~Handles() { png_destroy_write_struct(&png, &info); }
};

// Only plain data in here and below: longjmp skips destructors.
void set_header(png_structp png, png_infop info, const Image& image, bool rgb, int dpi) {
  png_set_IHDR(png, info, static_cast<png_uint_32>(image.size.width),
               static_cast<png_uint_32>(image.size.height), 8,
               rgb ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGB_ALPHA, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (dpi > 0) {
    const auto per_metre = static_cast<png_uint_32>(std::lround(dpi / kMetresPerInch));
    png_set_pHYs(png, info, per_metre, per_metre, PNG_RESOLUTION_METER);
  }
}

// libpng's own writer of pixels would compress them itself; its end would miss them.
void write_pixels_and_end(png_structp png, const std::uint8_t* packed, std::size_t count) {
  for (std::size_t at = 0; at < count; at += kMostIdatBytes)
    png_write_chunk(png, reinterpret_cast<png_const_bytep>("IDAT"), packed + at,
                    std::min(kMostIdatBytes, count - at));
  png_write_chunk(png, reinterpret_cast<png_const_bytep>("IEND"), nullptr, 0);
}

bool run(const Handles& handles, const Image& image, PngChannels channels,
         std::span<const std::uint8_t> packed, std::span<const png_text> text, int dpi) {
  if (setjmp(png_jmpbuf(handles.png))) return false;
  set_header(handles.png, handles.info, image, channels == PngChannels::rgb, dpi);
  if (!text.empty()) png_set_text(handles.png, handles.info, text.data(), static_cast<int>(text.size()));
  png_write_info(handles.png, handles.info);
  write_pixels_and_end(handles.png, packed.data(), packed.size());
  return true;
}

// The strings that libpng's text structures point to.
struct Texts {
  std::vector<std::string> strings;
  std::vector<png_text> chunks;
};

Result<Texts> encode_text(const PngMetadata& metadata) {
  Texts texts;
  texts.strings.reserve(2 * metadata.text.size());  // pointers into it stay valid
  for (const auto& [keyword, value] : metadata.text) {
    if (const auto error = keyword_error(keyword))
      return failure("The PNG keyword \"" + keyword + "\" is not possible: " + *error + ".");
    if (!is_png_utf8(value)) return failure("The PNG text of \"" + keyword + "\" is not UTF-8.");
    if (keyword.size() + value.size() + kITxtBytes > kMaxPngTextBytes)
      return failure("The PNG text of \"" + keyword +
                     "\" is longer than 1 MiB, which no reader of ours accepts.");
    const std::optional<std::string> latin1 = latin1_from_utf8(value);
    png_text chunk{};
    chunk.compression = latin1 ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
    chunk.key = texts.strings.emplace_back(keyword).data();
    chunk.text = texts.strings.emplace_back(latin1 ? *latin1 : value).data();
    texts.chunks.push_back(chunk);
  }
  return texts;
}

Status check_image(const Image& image) {
  const auto [width, height] = image.size;
  const std::string size = std::to_string(width) + " x " + std::to_string(height) + " px";
  if (width < 1 || height < 1 || width > kMaxPngSide || height > kMaxPngSide)
    return failure("A PNG of " + size + " is not possible: 1 to " + std::to_string(kMaxPngSide) +
                   " px a side.");
  if (image.rgba.size() != 4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
    return failure("An image of " + size + " has " + std::to_string(image.rgba.size()) + " bytes.");
  return success();
}

}  // namespace

struct PngEncoder::State {
  PngPacking packing;
  Packer packer;
  Buffer filtered;
  Writer writer;
};

PngEncoder::PngEncoder(PngPacking packing)
    : state_(std::unique_ptr<State>(new State{packing, Packer(packing), {}, {}})) {}
PngEncoder::~PngEncoder() = default;
PngEncoder::PngEncoder(PngEncoder&&) noexcept = default;
PngEncoder& PngEncoder::operator=(PngEncoder&&) noexcept = default;

Result<std::span<const std::uint8_t>> PngEncoder::encode(const Image& image, const PngMetadata& metadata) {
  const Status possible = check_image(image);
  if (!possible) return failure(possible.error());
  const Result<Texts> texts = encode_text(metadata);
  if (!texts) return failure(texts.error());

  std::uint8_t* filtered = state_->filtered.at_least(filtered_bytes(image.size, PngChannels::rgba));
  const PngChannels channels = state_->packing == PngPacking::fast ? filter_rows_fast(image, filtered)
                                                                   : filter_rows_well(image, filtered);
  const std::span<const std::uint8_t> packed =
      state_->packer.pack({filtered, filtered_bytes(image.size, channels)});

  Writer& writer = state_->writer;
  writer.bytes.clear();
  Handles handles;
  handles.png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &writer, on_error, on_warning);
  if (handles.png) handles.info = png_create_info_struct(handles.png);
  if (!handles.info)
    return failure("libpng cannot start: out of memory, or it is older than the one we were built with.");
  png_set_write_fn(handles.png, &writer, on_write, on_flush);
  if (run(handles, image, channels, packed, texts->chunks, metadata.dpi))
    return std::span<const std::uint8_t>(writer.bytes);
  return failure(std::string("libpng cannot write the image: ") + writer.error.data() + ".");
}

Result<std::vector<std::uint8_t>> encode_png(const Image& image, const PngMetadata& metadata,
                                             PngPacking packing) {
  PngEncoder encoder(packing);
  const auto bytes = encoder.encode(image, metadata);
  if (!bytes) return failure(bytes.error());
  return std::vector<std::uint8_t>(bytes->begin(), bytes->end());
}

Status write_png(PngEncoder& encoder, const std::filesystem::path& path, const Image& image,
                 const PngMetadata& metadata, Durability durability) {
  const auto bytes = encoder.encode(image, metadata);
  if (!bytes) return failure("Cannot write " + path.string() + ": " + bytes.error());
  return write_file_atomically(path, *bytes, durability);
}

Status write_png(const std::filesystem::path& path, const Image& image, const PngMetadata& metadata,
                 Durability durability) {
  PngEncoder encoder;
  return write_png(encoder, path, image, metadata, durability);
}

}  // namespace polhode
