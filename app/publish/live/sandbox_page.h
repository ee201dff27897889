// SPDX-License-Identifier: MIT
// The sandbox: one page of HTML on which a body is chosen, thrown, seen beside Poinsot's construction, and
// computed by methods of one's choice. Without script, or where a browser cannot draw it, it is a picture.
#pragma once

#include "app/publish/live/live_program.h"
#include "base/files/atomic_file.h"
#include "render/gl/renderer.h"

#include <filesystem>

namespace polhode {

/// The file appears whole or not at all. The picture depends on the driver that draws.
Done write_sandbox(const std::filesystem::path& file, const LiveProgram& program, Renderer& renderer,
                   Durability durability = Durability::rename_only);

}  // namespace polhode
