// SPDX-License-Identifier: MIT
// polhode export --site, and what it has in common with other exports.
#pragma once

#include "app/cli/commands/export_options.h"
#include "app/cli/exit_codes.h"
#include "app/page/loaded_lesson.h"

namespace polhode {

/// Pictures, and the film or deck that is made of them. @throws CommandError
ExitCode export_pictures(const LoadedLesson& loaded, const ExportOptions& options, const ExportOutput& out);

/// @throws CommandError
ExitCode export_site(const TypedExport& typed);

}  // namespace polhode
