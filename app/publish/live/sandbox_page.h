// SPDX-License-Identifier: MIT
// The sandbox: one page of HTML on which a body is chosen, thrown, seen beside Poinsot's construction, and
// computed by methods of one's choice. Without script, or where a browser cannot draw it, it is a picture.
#pragma once

#include "app/publish/live/live_program.h"
#include "base/files/atomic_file.h"
#include "render/gl/renderer.h"

#include <filesystem>
#include <string>
#include <vector>

namespace polhode {

/// The file appears whole or not at all. The picture depends on the driver that draws.
/// @param program_file as in LiveParts
Done write_sandbox(const std::filesystem::path& file, const LiveProgram& program, Renderer& renderer,
                   Durability durability = Durability::rename_only, const std::string& program_file = "");
/// All that decides its bytes, but for program and driver.
std::vector<std::string> sandbox_sources();

}  // namespace polhode
