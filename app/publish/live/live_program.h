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
  std::string script;  ///< polhode.js, packed_for_page: a page runs it as it was, and has createPolhode then
  std::string script_hash;  ///< policy_hash of polhode.js as it was
  std::string wasm;         ///< polhode.wasm, packed_for_page
};

/// From the first of the folders that has polhode.wasm and polhode.js. Packing takes 0.3 s. Fails where none
/// has, which says how to come by them, or where they cannot be read.
Outcome<LiveProgram> read_live_program(const std::vector<std::filesystem::path>& folders);

/// RFC 1952 as text for an element, 1.23 characters to a byte, none of them "<": what a page's script unpacks
/// by DecompressionStream("gzip") (assets/web/live.js). Of each two characters the first counts 93 times, and
/// both together are the next 13 bits, most significant first; a last one alone is 6. Characters count from
/// "!" = 0 on, but "~" is what "<" would be. The packed bytes depend on the text, and on the release of
/// libdeflate.
std::string packed_for_page(std::string_view bytes);

/// What a page needs besides its own script: its lesson, the program and the program's script, all of them
/// `packed_for_page` as data.
std::string live_elements(const LiveProgram& program, std::string_view lesson_text);
/// Of the sources of a page's policy those that let the program run: its script, once it is unpacked, and
/// WebAssembly.
std::string live_policy(const LiveProgram& program);

}  // namespace polhode
