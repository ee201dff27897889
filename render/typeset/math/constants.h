// SPDX-License-Identifier: MIT
// The measures of the OpenType MATH table (OpenType specification, "MATH — The mathematical typesetting
// table"), relative to the em.
#pragma once

#include "render/typeset/fonts.h"

#include <hb-ot.h>
#include <hb.h>

#include <array>
#include <cstdint>

namespace polhode {

class MathFont {
 public:
  explicit MathFont(const Fonts& fonts)
      : font_(fonts.harfbuzz(Face::math)), em_(fonts.units_per_em(Face::math)) {
    for (std::size_t i = 0; i < constants_.size(); ++i)
      constants_[i] = hb_ot_math_get_constant(font_, static_cast<hb_ot_math_constant_t>(i)) / scale_of(i);
    find_script_lookups();
  }

  double operator[](hb_ot_math_constant_t constant) const {
    return constants_[static_cast<std::size_t>(constant)];
  }
  double axis() const { return (*this)[HB_OT_MATH_CONSTANT_AXIS_HEIGHT]; }
  double rule() const { return (*this)[HB_OT_MATH_CONSTANT_FRACTION_RULE_THICKNESS]; }

  double italic_correction(std::uint32_t glyph) const {
    return hb_ot_math_get_glyph_italics_correction(font_, glyph) / em_;
  }
  double top_accent_attachment(std::uint32_t glyph) const {
    return hb_ot_math_get_glyph_top_accent_attachment(font_, glyph) / em_;
  }
  /// How far a script moves towards the corner of a glyph, at a height above the glyph's baseline.
  double kern(std::uint32_t glyph, hb_ot_math_kern_t corner, double height) const {
    return hb_ot_math_get_glyph_kerning(font_, glyph, corner, static_cast<hb_position_t>(height * em_)) / em_;
  }
  /// The form made for scripts (feature ssty), or the glyph itself. `level` 1: scripts, 2: scripts of
  /// scripts.
  std::uint32_t script_form(std::uint32_t glyph, int level) const;

  hb_font_t* harfbuzz() const { return font_; }
  double em() const { return em_; }

 private:
  void find_script_lookups();
  /// Percentages are the first two and the last one.
  double scale_of(std::size_t constant) const {
    return constant < 2 || constant == HB_OT_MATH_CONSTANT_RADICAL_DEGREE_BOTTOM_RAISE_PERCENT ? 100.0 : em_;
  }

  hb_font_t* font_;
  double em_;
  std::array<double, 56> constants_{};
  std::array<unsigned, 8> script_lookups_{};
  unsigned script_lookup_count_ = 0;
};

}  // namespace polhode
