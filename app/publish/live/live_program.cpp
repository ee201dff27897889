// SPDX-License-Identifier: MIT
#include "app/publish/live/live_program.h"

#include "app/publish/html_text.h"
#include "base/files/file_bytes.h"
#include "base/sha256.h"
#include "base/words/live_words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <libdeflate.h>

#include <algorithm>
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

/// As a string of a script. Packed text has neither control characters nor any beyond ASCII.
std::string as_script_text(std::string_view packed) {
  std::string quoted = "\"";
  for (const char c : packed) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + '"';
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

LiveFile live_file(const LiveProgram& program) {
  std::string text = fmt::format("polhodeLive.hold({{\"polhode.wasm\": {}, \"polhode.js\": {}}});\n",
                                 as_script_text(program.wasm), as_script_text(program.script));
  constexpr std::size_t kDigits = 12;
  return {"polhode-" + sha256_hex(text).substr(0, kDigits) + ".js", std::move(text)};
}

std::string live_elements(const LiveParts& live, Language language) {
  const auto element = [](const char* name, std::string_view attributes, std::string_view text) {
    return fmt::format("<script type=\"text/plain\" id=\"polhode.{}\"{}>{}</script>\n", name, attributes,
                       text);
  };
  const std::string lesson =
      fmt::format("<script type=\"application/json\" id=\"polhode.words\">{}</script>\n",
                  json_of(words::kLive, language)) +
      element("lesson", "", packed_for_page(live.lesson_text));
  if (!live.program_file.empty())
    return lesson + element("file", fmt::format(" data-name=\"{}\"", html_escaped(live.program_file)), "");
  return lesson + element("wasm", "", live.program.wasm) + element("js", "", live.program.script);
}

std::string live_without_script(Language language) {
  return fmt::format("<noscript><p class=\"quiet\">{}</p></noscript>\n", words::kLiveNoScript.in(language));
}

std::string live_policy(const LiveParts& live) {
  return live.program.script_hash + " 'wasm-unsafe-eval'" +
         (live.program_file.empty() ? "" : " 'strict-dynamic'");
}

std::string live_attributes(const Stage& stage, int step) {
  const auto asks = blocks_of<Ask>(stage.steps[static_cast<std::size_t>(step - 1)]);
  const bool rests =
      std::any_of(asks.begin(), asks.end(), [](const Ask* ask) { return ask->plays.has_value(); });
  return fmt::format(" data-stage=\"{}\" data-step=\"{}\"{}", html_escaped(stage.id), step,
                     rests ? " data-rest" : "");
}

}  // namespace polhode
