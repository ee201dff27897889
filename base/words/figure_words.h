// SPDX-License-Identifier: MIT
// What is written in figures and plots, and why an overlay is not seen there. What alternative texts say of
// an overlay stands in its row, render/scene/description/overlay.h.
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

// Why there is nothing to see of an overlay.
inline constexpr Phrase kShowsNothing{"shows nothing: {0}", "zeigt nichts: {0}"};
inline constexpr Phrase kIsTurnedByHand{
    "shows nothing beside turn-orders: that body is turned by hand, and has no motion",
    "zeigt nichts neben turn-orders: dort dreht eine Hand den Körper, und er hat keine Bewegung"};
inline constexpr Phrase kATorqueActs{"it belongs to motion without torque, and a torque acts",
                                     "es gehört zur Bewegung ohne Drehmoment, und ein Drehmoment wirkt"};
inline constexpr Phrase kNoTorqueActs{"no torque acts", "kein Drehmoment wirkt"};
inline constexpr Phrase kBodyIsAtRest{"the body is at rest", "der Körper ruht"};
inline constexpr Phrase kSeenFromSpaceOnly{"it is seen from space only",
                                           "es ist nur vom Raumsystem aus zu sehen"};
inline constexpr Phrase kLevelWithLDown{
    "only where L points down is it level: attitude = \"L-down\"",
    "waagerecht liegt es nur, wo L nach unten zeigt: attitude = \"L-down\""};
inline constexpr Phrase kCentreIsAtRest{"the centre of mass is at rest: there is no velocity or force",
                                        "der Massenmittelpunkt ruht: ohne Geschwindigkeit und Kraft"};
inline constexpr Phrase kNoForceActs{"there is no force", "keine Kraft wirkt"};
inline constexpr Phrase kNoHeavyTop{"the torque is not that of one heavy top",
                                    "das Drehmoment ist nicht das eines schweren Kreisels"};

}  // namespace polhode::words
