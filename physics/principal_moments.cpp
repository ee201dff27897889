// SPDX-License-Identifier: MIT
#include "physics/principal_moments.h"

namespace polhode {

std::optional<std::string> why_impossible(double, double, double) { return std::nullopt; }
PrincipalMoments::PrincipalMoments(double I1, double I2, double I3) : I_(I1, I2, I3) {}

}  // namespace polhode
