// SPDX-License-Identifier: MIT
// What is written in figures and plots. What alternative texts say of an overlay stands in its row,
// render/scene/description/overlay.h.
#pragma once

#include "base/words/phrase.h"

namespace polhode::words {

// Figures in space.
inline constexpr Phrase kPathOfL{"path of $\\vec L$", "Bahn von $\\vec L$"};
inline constexpr Phrase kPolhode{"polhode", "Polhodie"};
inline constexpr Phrase kHerpolhode{"herpolhode", "Herpolhodie"};
inline constexpr Phrase kSeparatrix{"separatrix", "Separatrix"};
inline constexpr Phrase kInvariablePlane{"invariable plane", "invariable Ebene"};
inline constexpr Phrase kBodyCone{"body cone", "Gangpolkegel"};
inline constexpr Phrase kSpaceCone{"space cone", "Rastpolkegel"};
inline constexpr Phrase kExactL{"$\\vec L$ exact", "$\\vec L$ exakt"};
inline constexpr Phrase kExactOmega{"$\\vec\\omega$ exact", "$\\vec\\omega$ exakt"};
inline constexpr Phrase kExactMotion{"exact motion", "exakte Bewegung"};
inline constexpr Phrase kWeight{"weight", "Gewicht"};
inline constexpr Phrase kSpaceFrame{"space frame $S$", "Raumsystem $S$"};
inline constexpr Phrase kBodyFrame{"body frame $S^*$", "Körpersystem $S^*$"};
inline constexpr Phrase kFirstXThenY{"first about $x$, then about $y$", "erst um $x$, dann um $y$"};
inline constexpr Phrase kFirstYThenX{"first about $y$, then about $x$", "erst um $y$, dann um $x$"};

// Plots.
inline constexpr Phrase kAngularVelocityInTheBody{"Angular velocity in the body",
                                                  "Winkelgeschwindigkeit im Körper"};
inline constexpr Phrase kKineticEnergy{"Kinetic energy", "Kinetische Energie"};
inline constexpr Phrase kAngularMomentum{"Angular momentum", "Drehimpuls"};
inline constexpr Phrase kDrift{"Drift from the start", "Abweichung vom Anfangswert"};
inline constexpr Phrase kRelativeAngleInRad{"relative; $\\angle$ in rad", "relativ; $\\angle$ in rad"};
inline constexpr Phrase kAgainst{"{0} against {1}", "{0} über {1}"};

}  // namespace polhode::words
