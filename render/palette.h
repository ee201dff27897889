// SPDX-License-Identifier: MIT
// Colours by role: a quantity has the same colour in text, formula, scene and plot.
// `ink` is for text and labels (at least 5.2:1 on paper); `paint` is its brighter relative for thick things,
// after Okabe & Ito, "Color Universal Design" (2008), told apart by colour-blind readers.
#pragma once

#include "base/color.h"

#include <array>
#include <optional>
#include <string_view>

namespace polhode {

struct Role {
  Color ink;
  Color paint;
};

inline constexpr Role kOmegaRole{color_from_hex(0xB04A00), color_from_hex(0xD55E00)};
inline constexpr Role kLRole{color_from_hex(0x005F99), color_from_hex(0x0072B2)};
/// Of torques and forces, weight among them; their arrows are dotted.
inline constexpr Role kNRole{color_from_hex(0x9C4A7C), color_from_hex(0xC0609C)};
inline constexpr Role kPolhodeRole{color_from_hex(0x00734F), color_from_hex(0x009E73)};
inline constexpr Role kHerpolhodeRole{color_from_hex(0x6B5B00), color_from_hex(0xAA8F00)};
inline constexpr Role kTRole{color_from_hex(0x23262B),
                             color_from_hex(0x4A4F57)};  ///< scalars: the ink of text
inline constexpr Role kAxesRole{color_from_hex(0x4A4F57), color_from_hex(0x8A9099)};
/// Of the body axes 1, 2, 3: the hues of the polhodes round the first and the last (family_color), where the
/// moments are in order; none goes round the second, whose hue is its own.
inline constexpr std::array<Role, 3> kBodyAxisRoles{Role{color_from_hex(0x4C3A9E), color_from_hex(0x7166C0)},
                                                    Role{color_from_hex(0x48611C), color_from_hex(0x5E7D2A)},
                                                    Role{color_from_hex(0x0A6473), color_from_hex(0x1F8C9C)}};
/// Of what a lesson draws besides, in this order; told apart by dashes where there is more.
inline constexpr std::array<Role, 4> kMarkRoles{Role{color_from_hex(0x5B3FA0), color_from_hex(0x7B5FC7)},
                                                Role{color_from_hex(0x6E3B10), color_from_hex(0x9A5B22)},
                                                Role{color_from_hex(0x8E1B3A), color_from_hex(0xB3244C)},
                                                kTRole};
/// omega | L | N | polhode | herpolhode | axes | axis-1 | axis-2 | axis-3, and violet | brown | crimson |
/// black of kMarkRoles, as lessons name them; nothing otherwise.
std::optional<Role> role_from(std::string_view name);

inline constexpr Color kSeparatrixPaint = color_from_hex(0x59616C);
inline constexpr Color kPaper = color_from_hex(0xFBFAF6);
inline constexpr Color kInk = kTRole.ink;
inline constexpr Color kGlassTint = color_from_hex(0x8FC3DA), kGlassInk = color_from_hex(0x2F6178);
inline constexpr Color kSphereTint = color_from_hex(0xC9B98A), kSphereInk = color_from_hex(0x6B5B2E);
inline constexpr Color kSolid = color_from_hex(0xD9CDB8);

/// Whether inks made for paper cannot be read on it.
bool is_dark(const Color& paper);
/// The relative of an ink or paint that is readable on dark paper: light, and of the same hue.
Color on_dark(const Color& color);
/// The relative of a paint for lines and arrows in space on dark ground, no brighter than need be: at least
/// 6.4:1 on kDarkGround, so that 3:1 is left where it is shaded and behind glass; a grey, which has nothing
/// but its lightness, as much as it has on paper.
Color paint_on_dark(const Color& paint);
inline constexpr Color kDarkGround =
    color_from_hex(0x2B3038);  ///< of floors in dark pictures, where lightest

/// Colour of a polhode by L²/2T, placed at s = 0 (I_min), ½ (I_mid, the separatrix), 1 (I_max): a diverging
/// scale, because the two sides go round different axes.
Color family_color(double s);

}  // namespace polhode
