// SPDX-License-Identifier: MIT
#include "app/publish/live/live_program.h"

#include "app/publish/html_text.h"
#include "base/files/file_bytes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <libdeflate.h>

#include <memory>
#include <new>
#include <span>
#include <utility>

namespace polhode {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t kMostBytes = std::uintmax_t{64} << 20;
constexpr const char* kWasm = "polhode.wasm";
constexpr const char* kScript = "polhode.js";

bool has_both(const fs::path& folder) {
  std::error_code error;
  return fs::is_regular_file(folder / kWasm, error) && fs::is_regular_file(folder / kScript, error);
}

Outcome<std::string> read(const fs::path& file) {
  const auto bytes = read_file_bytes(file, kMostBytes);
  if (!bytes)
    return failure_of(Fault::failed, fmt::format("cannot read {}: {}", file.string(), bytes.error()));
  return std::string(bytes->begin(), bytes->end());
}

/// Any byte but "<" may stand in an element's text, so more bits fit into a character than base64 has: 13
/// into two, each one of 93 from "!" to "}", with "~" in the place of "<"; 6 into one, if no more are left.
class TextOfBits {
 public:
  explicit TextOfBits(std::span<const std::uint8_t> bytes) {
    constexpr int kPair = 13, kSingle = 6;
    text_.reserve(bytes.size() * 16 / kPair + 2);
    std::uint32_t bits = 0;
    int count = 0;
    for (const std::uint8_t byte : bytes) {
      bits = bits << 8 | byte;
      count += 8;
      if (count < kPair) continue;
      count -= kPair;
      add_pair(bits >> count);
      bits &= (1U << count) - 1;
    }
    if (count > kSingle)
      add_pair(bits << (kPair - count));
    else if (count > 0)
      add(bits << (kSingle - count));
  }

  std::string take() && { return std::move(text_); }

 private:
  static constexpr std::uint32_t kDigits = 93;

  void add_pair(std::uint32_t value) {
    add(value / kDigits);
    add(value % kDigits);
  }
  void add(std::uint32_t digit) {
    const char c = static_cast<char>('!' + digit);
    text_ += c == '<' ? '~' : c;
  }

  std::string text_;
};

}  // namespace

std::string packed_for_page(std::string_view bytes) {
  constexpr int kLevel = 12;  // the smallest: a page is written once and opened often
  const auto free = [](libdeflate_compressor* one) { libdeflate_free_compressor(one); };
  const std::unique_ptr<libdeflate_compressor, decltype(free)> packer(libdeflate_alloc_compressor(kLevel),
                                                                      free);
  if (!packer) throw std::bad_alloc();
  std::vector<std::uint8_t> packed(libdeflate_gzip_compress_bound(packer.get(), bytes.size()));
  const std::size_t size =
      libdeflate_gzip_compress(packer.get(), bytes.data(), bytes.size(), packed.data(), packed.size());
  return TextOfBits(std::span(packed).first(size)).take();
}

Outcome<LiveProgram> read_live_program(const std::vector<fs::path>& folders) {
  for (const fs::path& folder : folders) {
    if (!has_both(folder)) continue;
    const Outcome<std::string> wasm = read(folder / kWasm);
    if (!wasm) return passed_on(wasm);
    const Outcome<std::string> script = read(folder / kScript);
    if (!script) return passed_on(script);
    return LiveProgram{packed_for_page(*script), policy_hash(*script), packed_for_page(*wasm)};
  }
  std::vector<std::string> places;
  for (const fs::path& folder : folders) places.push_back(folder.string());
  return failure_of(Fault::failed,
                    fmt::format("figures that move need {} and {}, which are not there (looked in {}); build "
                                "them once with ./web in the source folder",
                                kWasm, kScript, fmt::join(places, ", ")));
}

std::string live_elements(const LiveProgram& program, std::string_view lesson_text) {
  return fmt::format(
      "<script type=\"text/plain\" id=\"polhode.lesson\">{}</script>\n"
      "<script type=\"text/plain\" id=\"polhode.wasm\">{}</script>\n"
      "<script type=\"text/plain\" id=\"polhode.js\">{}</script>\n",
      packed_for_page(lesson_text), program.wasm, program.script);
}

std::string live_policy(const LiveProgram& program) { return program.script_hash + " 'wasm-unsafe-eval'"; }

}  // namespace polhode
