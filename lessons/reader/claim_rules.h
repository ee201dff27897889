// SPDX-License-Identifier: MIT
// What the lines of a claim may say, whatever is true: before anything is proved.
#pragma once

#include "lessons/claims/claim.h"
#include "lessons/claims/expressions/dimension.h"
#include "lessons/diagnostics/report.h"

#include <map>

namespace polhode {

/// False, and a report, where what is given at an instant is to say something of rates, where what holds to
/// an order is printed otherwise, or where units disagree. `constants`: those of the lesson that have one.
bool keeps_claim_rules(const Claim& claim, const std::map<int, Dimension>& constants, Report& report);

}  // namespace polhode
