// SPDX-License-Identifier: MIT
// Whether a claim is of the kind that its author gave it.
#pragma once

#include "lessons/claims/claim.h"
#include "lessons/claims/proof/proof.h"
#include "lessons/diagnostics/report.h"
#include "physics/effort.h"
#include "render/scene/model/model.h"

namespace polhode {

/// What a definition defines stands alone on a side; a law, and what is measured, could be otherwise. Warns
/// of a formula that is what one of its symbols means, and where a law, or what is given, is not needed.
void check_kind(const Claim& claim, const Prover& prover, Report& report, const Effort& effort);

/// A line that is measured holds on the motion, within what decides anything.
void check_measured(const Claim& claim, const ClaimLine& line, const SceneModel& model, Report& report);

}  // namespace polhode
