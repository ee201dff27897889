// SPDX-License-Identifier: MIT
// The program for a page whose figures move: what ./web has built (app/web/live_api.h), packed so that the
// page holds it and fetches nothing, or that pages of one folder have it in a file beside them.
#pragma once

#include "base/outcome.h"
#include "base/words/language.h"
#include "lessons/reader/lesson.h"

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

/// What makes the figures of a page move, once they are pressed.
struct LiveParts {
  LiveProgram program;
  std::string lesson_text;     ///< that the page's lesson was read from
  std::string program_file{};  ///< name of the live_file() beside the page; empty: the page has the program
};

/// The program as a script for pages that lie beside it: it is there once for all of them, a browser keeps
/// it, and from a disk a page may run a file but not read one. Its name tells its text, so that no page
/// meets the program of another release.
struct LiveFile {
  std::string name, text;
};
LiveFile live_file(const LiveProgram& program);

/// What a page needs besides its own script: its lesson, and the program with its script or where they are;
/// texts are `packed_for_page`, as data. And what its script says, in the page's language.
std::string live_elements(const LiveParts& live, Language language);
/// Of the sources of a page's policy those that let the program run: its script, once it is unpacked, and
/// WebAssembly; and where it lies beside the page, what the page's own script adds to it.
std::string live_policy(const LiveParts& live);
/// What assets/web/figures.js has to know of the figure of a step (from 1), as attributes: of which step it
/// is, and whether it rests until it is played, for its motion would give a prediction away.
std::string live_attributes(const Stage& stage, int step);
/// For a page with figures that move: what they are without script.
std::string live_without_script(Language language);

}  // namespace polhode
