// SPDX-License-Identifier: MIT
// The program for a page whose figures move: what ./web has built (app/web/live_api.h), packed so that the
// page holds it and fetches nothing.
#pragma once

#include "base/outcome.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

struct LiveProgram {
  std::string script;  ///< polhode.js as it is: runs as a script of the page, and defines createPolhode
  std::string wasm;    ///< polhode.wasm, packed_for_page
};

/// From the first of the folders that has polhode.wasm and polhode.js. Packing takes 0.3 s. Fails where none
/// has, which says how to come by them, or where they cannot be read.
Outcome<LiveProgram> read_live_program(const std::vector<std::filesystem::path>& folders);

/// RFC 1952 in base64: what a page's script unpacks by DecompressionStream("gzip"). The bytes depend on the
/// text, and on the release of libdeflate.
std::string packed_for_page(std::string_view bytes);

/// What a page needs besides its own script: its lesson and the program, `packed_for_page` as data, and the
/// program's script.
std::string live_elements(const LiveProgram& program, std::string_view lesson_text);
/// Of the sources of a page's policy those that let the program run: its script, and WebAssembly.
std::string live_policy(const LiveProgram& program);

}  // namespace polhode
