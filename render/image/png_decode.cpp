// SPDX-License-Identifier: MIT
#include "base/files/file_bytes.h"
#include "render/image/png.h"
#include "render/image/png_rows.h"
#include "render/image/png_text.h"

#include <png.h>

#include <array>
#include <cmath>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <optional>
#include <string_view>

namespace polhode {
namespace {

constexpr std::size_t kSignatureBytes = 8;
constexpr std::size_t kChunkHeadBytes = 8;    // length and type
constexpr std::size_t kChunkFrameBytes = 12;  // and checksum
constexpr png_uint_32 kMaxAncillaryChunks = 1000;
// Deflate cannot do better: 258 bytes from two bits (zlib's "Maximum Expansion Factor").
constexpr std::uint64_t kMaxExpansion = 1032;

// What libpng's callbacks need. Lives outside the functions that longjmp may leave.
struct Reader {
  std::span<const std::uint8_t> rest;
  std::array<char, 128> error{};
};

void on_error(png_structp png, png_const_charp text) {
  auto* reader = static_cast<Reader*>(png_get_error_ptr(png));
  std::snprintf(reader->error.data(), reader->error.size(), "%s", text);
  png_longjmp(png, 1);
}

// libpng warns of optional chunks that it leaves out, which cannot change the pixels.
void on_warning(png_structp, png_const_charp) {}

void on_read(png_structp png, png_bytep data, std::size_t count) {
  auto* reader = static_cast<Reader*>(png_get_io_ptr(png));
  if (count > reader->rest.size()) png_error(png, "the file ends too early");
  std::memcpy(data, reader->rest.data(), count);
  reader->rest = reader->rest.subspan(count);
}

std::size_t read32(std::span<const std::uint8_t> bytes) {
  return std::size_t{bytes[0]} << 24 | std::size_t{bytes[1]} << 16 | std::size_t{bytes[2]} << 8 | bytes[3];
}

// libpng's own limit is for what it expands; a long plain chunk only earns a warning.
bool has_long_chunk(std::span<const std::uint8_t> bytes) {
  bytes = bytes.subspan(kSignatureBytes);
  while (bytes.size() >= kChunkHeadBytes) {
    const std::size_t length = read32(bytes);
    const bool pixels = std::memcmp(&bytes[4], "IDAT", 4) == 0;
    if (length > kMaxPngTextBytes && !pixels) return true;
    if (length + kChunkFrameBytes > bytes.size()) return false;  // cut off: libpng says so
    bytes = bytes.subspan(kChunkFrameBytes + length);
  }
  return false;
}

struct Handles {
  png_structp png = nullptr;
  png_infop info = nullptr;
  ~Handles() { png_destroy_read_struct(&png, &info, nullptr); }
};

// Whatever the file holds becomes 8-bit RGBA, values as stored: no gamma, no colour profile.
void expand_to_rgba8(png_structp png, png_infop info) {
  png_set_expand(png);  // palette, fewer than 8 bits, transparent colour
  png_set_scale_16(png);
  png_set_gray_to_rgb(png);
  png_set_add_alpha(png, 255, PNG_FILLER_AFTER);
  png_set_interlace_handling(png);
  png_read_update_info(png, info);
}

// Only plain data in the three functions that call setjmp: longjmp skips destructors.
bool read_header(const Handles& handles) {
  if (setjmp(png_jmpbuf(handles.png))) return false;
  png_set_user_limits(handles.png, kMaxPngSide, kMaxPngSide);
  // One more for the 0 that libpng puts behind a text: from 1.6.47 on it counts.
  png_set_chunk_malloc_max(handles.png, kMaxPngTextBytes + 1);
  png_set_chunk_cache_max(handles.png, kMaxAncillaryChunks);
  png_read_info(handles.png, handles.info);
  return true;
}

// A tiny file may claim to be enormous: asked before memory is taken for it.
bool plausible(const Handles& handles, std::size_t file_bytes) {
  const std::uint64_t row = png_get_rowbytes(handles.png, handles.info);
  return row * png_get_image_height(handles.png, handles.info) <= kMaxExpansion * file_bytes;
}

bool prepare_pixels(const Handles& handles) {
  if (setjmp(png_jmpbuf(handles.png))) return false;
  expand_to_rgba8(handles.png, handles.info);
  return true;
}

bool read_pixels(const Handles& handles, std::span<png_bytep> rows) {
  if (setjmp(png_jmpbuf(handles.png))) return false;
  png_read_image(handles.png, rows.data());
  png_read_end(handles.png, handles.info);
  return true;
}

bool read_row(const Handles& handles, png_bytep row, bool is_last) {
  if (setjmp(png_jmpbuf(handles.png))) return false;
  png_read_row(handles.png, row, nullptr);
  if (is_last) png_read_end(handles.png, handles.info);
  return true;
}

std::vector<png_bytep> rows_of(Image& image) {
  std::vector<png_bytep> rows;
  const std::size_t row_bytes = 4 * static_cast<std::size_t>(image.size.width);
  for (std::size_t at = 0; at < image.rgba.size(); at += row_bytes) rows.push_back(&image.rgba[at]);
  return rows;
}

PngMetadata metadata_of(const Handles& handles) {
  PngMetadata metadata;
  png_textp text = nullptr;
  int count = 0;
  png_get_text(handles.png, handles.info, &text, &count);
  for (const png_text& chunk : std::span(text, static_cast<std::size_t>(count))) {
    const bool utf8 =
        chunk.compression == PNG_ITXT_COMPRESSION_NONE || chunk.compression == PNG_ITXT_COMPRESSION_zTXt;
    const std::string_view value(chunk.text, utf8 ? chunk.itxt_length : chunk.text_length);
    if (utf8 && !is_png_utf8(value)) continue;  // ill-formed: left out like any other bad optional chunk
    metadata.text.emplace_back(utf8_from_latin1(chunk.key),
                               utf8 ? std::string(value) : utf8_from_latin1(value));
  }
  const double per_metre = png_get_pixels_per_meter(handles.png, handles.info);  // 0 unless equal in x and y
  metadata.dpi = static_cast<int>(std::lround(per_metre * kMetresPerInch));
  return metadata;
}

/// A file whose pixels are what is read next.
struct OpenPng {
  Reader reader;
  Handles handles;

  Failure<std::string> broken() const {
    return failure(std::string("damaged or refused PNG: ") + reader.error.data());
  }
  Size size() const {
    return {static_cast<int>(png_get_image_width(handles.png, handles.info)),
            static_cast<int>(png_get_image_height(handles.png, handles.info))};
  }
  bool interlaced() const { return png_get_interlace_type(handles.png, handles.info) != PNG_INTERLACE_NONE; }

  /// The bytes have to outlive what is read of them.
  Status begin(std::span<const std::uint8_t> bytes) {
    if (bytes.size() < kSignatureBytes || png_sig_cmp(bytes.data(), 0, kSignatureBytes) != 0)
      return failure("not a PNG file");
    if (has_long_chunk(bytes)) return failure("refused PNG: a chunk other than pixels is longer than 1 MiB");
    reader.rest = bytes;
    handles.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &reader, on_error, on_warning);
    if (handles.png) handles.info = png_create_info_struct(handles.png);
    if (!handles.info)
      return failure("libpng cannot start: out of memory, or older than the one we were built with");
    png_set_read_fn(handles.png, &reader, on_read);
    if (!read_header(handles)) return broken();
    if (!plausible(handles, bytes.size()))
      return failure("damaged or refused PNG: far too short for its size in pixels");
    if (!prepare_pixels(handles)) return broken();
    return success();
  }

  Result<Image> read_image() {
    Image image = Image::blank(size());
    std::vector<png_bytep> rows = rows_of(image);
    if (!read_pixels(handles, rows)) return broken();
    return image;
  }
};

}  // namespace

Result<PngFile> decode_png(std::span<const std::uint8_t> bytes) {
  OpenPng png;
  if (const Status begun = png.begin(bytes); !begun) return failure(begun.error());
  Result<Image> image = png.read_image();
  if (!image) return failure(image.error());
  return PngFile{std::move(*image), metadata_of(png.handles)};
}

Result<PngFile> read_png(const std::filesystem::path& path) {
  const auto cannot_read = [&](const std::string& reason) {
    return failure("Cannot read " + path.string() + ": " + reason + ".");
  };
  const Result<std::vector<std::uint8_t>> bytes = read_file_bytes(path);
  if (!bytes) return cannot_read(bytes.error());
  Result<PngFile> file = decode_png(*bytes);
  if (!file) return cannot_read(file.error());
  return file;
}

struct PngRows::State {
  std::vector<std::uint8_t> bytes, row;
  OpenPng png;
  std::optional<Image> all;  ///< where rows do not come one after the other
  int next = 0;
};

PngRows::PngRows(std::unique_ptr<State> state) : state_(std::move(state)) {}
PngRows::~PngRows() = default;
PngRows::PngRows(PngRows&&) noexcept = default;
PngRows& PngRows::operator=(PngRows&&) noexcept = default;

Result<PngRows> PngRows::open(std::vector<std::uint8_t> bytes) {
  auto state = std::make_unique<State>();
  state->bytes = std::move(bytes);
  if (const Status begun = state->png.begin(state->bytes); !begun) return failure(begun.error());
  if (state->png.interlaced()) {
    auto image = state->png.read_image();
    if (!image) return failure(image.error());
    state->all = std::move(*image);
  }
  state->row.resize(4 * static_cast<std::size_t>(state->png.size().width));
  return PngRows(std::move(state));
}

Size PngRows::size() const { return state_->png.size(); }

Result<std::span<const std::uint8_t>> PngRows::next() {
  State& s = *state_;
  const int y = s.next++;
  if (s.all) return std::span<const std::uint8_t>(s.all->pixel(0, y), s.row.size());
  if (!read_row(s.png.handles, s.row.data(), s.next == size().height)) return s.png.broken();
  return std::span<const std::uint8_t>(s.row);
}

}  // namespace polhode
