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
  return base64(std::span(packed).first(size));
}

Outcome<LiveProgram> read_live_program(const std::vector<fs::path>& folders) {
  for (const fs::path& folder : folders) {
    if (!has_both(folder)) continue;
    const Outcome<std::string> wasm = read(folder / kWasm);
    if (!wasm) return passed_on(wasm);
    Outcome<std::string> script = read(folder / kScript);
    if (!script) return passed_on(script);
    // It would end the element that it stands in; no build of ours has it.
    if (script->find("</script") != std::string::npos)
      return failure_of(Fault::failed, fmt::format("{} cannot stand in a page: it holds \"</script\"",
                                                   (folder / kScript).string()));
    return LiveProgram{std::move(script).value(), packed_for_page(*wasm)};
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
      "<script>{}</script>\n",
      packed_for_page(lesson_text), program.wasm, program.script);
}

std::string live_policy(const LiveProgram& program) {
  return policy_hash(program.script) + " 'wasm-unsafe-eval'";
}

}  // namespace polhode
