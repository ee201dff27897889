// SPDX-License-Identifier: MIT
// png_bench FILE.png TURNS: that picture encoded anew, by `--png fast`, by `--png small`, and by libpng as
// it is by default, in turns. One line of JSON with the median CPU ms and the bytes of each.
#include "render/image/png.h"
#include "tests/bench/timing.h"

#include <fmt/format.h>
#include <png.h>

#include <charconv>
#include <cstdio>
#include <cstring>
#include <stdexcept>

namespace polhode::bench {
namespace {

struct Cost {
  std::vector<double> ms;
  std::size_t bytes = 0;
};

void append(png_structp png, png_bytep from, std::size_t size) {
  auto* file = static_cast<std::vector<std::uint8_t>*>(png_get_io_ptr(png));
  file->insert(file->end(), from, from + size);
}

/// What a program gets that sets nothing but the header: RGB, as our own writer gives of an opaque picture.
std::size_t encode_by_default(const Image& image) {
  std::vector<std::uint8_t> file, row(3 * static_cast<std::size_t>(image.size.width));
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(png, &file, append, nullptr);
  png_set_IHDR(png, info, static_cast<png_uint_32>(image.size.width),
               static_cast<png_uint_32>(image.size.height), 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  for (int y = 0; y < image.size.height; ++y) {
    const std::uint8_t* from = image.pixel(0, y);
    for (std::size_t x = 0; x < row.size(); x += 3, from += 4) std::memcpy(&row[x], from, 3);
    png_write_row(png, row.data());
  }
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return file.size();
}

template <class Encode>
void add(Cost& cost, const Encode& encode) {
  cost.ms.push_back(1e3 * cpu_s([&] { cost.bytes = encode(); }));
}

void run(const char* path, int turns) {
  const auto file = read_png(path);
  if (!file) throw std::runtime_error(file.error());
  const Image& image = file.value().image;
  PngEncoder fast(PngPacking::fast), small(PngPacking::small);
  Cost of_fast, of_small, of_default;
  fast.encode(image, {}).value();  // its buffers
  for (int turn = 0; turn < turns; ++turn) {
    add(of_fast, [&] { return fast.encode(image, {}).value().size(); });
    add(of_default, [&] { return encode_by_default(image); });
    add(of_small, [&] { return small.encode(image, {}).value().size(); });
  }
  const auto json = [](const Cost& cost) {
    return fmt::format(R"({{"ms": {:.2f}, "bytes": {}}})", spread_of(cost.ms).median, cost.bytes);
  };
  fmt::print(R"({{"fast": {}, "small": {}, "default": {}}})"
             "\n",
             json(of_fast), json(of_small), json(of_default));
}

}  // namespace
}  // namespace polhode::bench

int main(int argc, char** argv) {
  int turns = 0;
  if (argc == 3) std::from_chars(argv[2], argv[2] + std::strlen(argv[2]), turns);
  if (turns < 1) {
    std::fputs("usage: png_bench FILE.png TURNS\n", stderr);
    return 2;
  }
  try {
    polhode::bench::run(argv[1], turns);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "png_bench: %s\n", error.what());
    return 1;
  }
}
