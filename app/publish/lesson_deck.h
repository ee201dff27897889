// SPDX-License-Identifier: MIT
// The deck of an export: its pictures with titles, notes and alternative texts.
#pragma once

#include "app/export/export_plan.h"
#include "app/publish/deck.h"

namespace polhode {

/// The pictures lie under their names in `folder`; their files have the alternative texts. The notes of a
/// stage's slides are together what the stage says: a slide has what its step adds, and before that what was
/// added by steps without a slide; the last slide also has what such steps add after it.
/// Fails if a picture cannot be read. Not for an export of frames.
Result<Deck> deck_of(const Lesson& lesson, const ExportOptions& options, const ExportPlan& plan,
                     const std::filesystem::path& folder);

}  // namespace polhode
