// SPDX-License-Identifier: MIT
#include "render/typeset/math/delimiters.h"

#include <algorithm>
#include <cmath>

namespace polhode {
namespace {

std::vector<hb_ot_math_glyph_variant_t> variants_of(const MathFont& font, std::uint32_t glyph,
                                                    hb_direction_t direction) {
  constexpr unsigned kMost = 32;
  std::vector<hb_ot_math_glyph_variant_t> variants(kMost);
  unsigned count = kMost;
  hb_ot_math_get_glyph_variants(font.harfbuzz(), glyph, direction, 0, &count, variants.data());
  variants.resize(count);
  return variants;
}

std::vector<hb_ot_math_glyph_part_t> parts_of(const MathFont& font, std::uint32_t glyph,
                                              hb_direction_t direction) {
  constexpr unsigned kMost = 16;
  std::vector<hb_ot_math_glyph_part_t> parts(kMost);
  unsigned count = kMost;
  hb_position_t italic = 0;
  hb_ot_math_get_glyph_assembly(font.harfbuzz(), glyph, direction, 0, &count, parts.data(), &italic);
  parts.resize(count);
  return parts;
}

hb_direction_t direction_of(Stretch stretch) {
  return stretch == Stretch::vertical ? HB_DIRECTION_TTB : HB_DIRECTION_LTR;
}

bool is_extender(const hb_ot_math_glyph_part_t& part) {
  return (part.flags & HB_OT_MATH_GLYPH_PART_FLAG_EXTENDER) != 0;
}

/// Parts in their order, each extender `times` times.
std::vector<hb_ot_math_glyph_part_t> repeated(const std::vector<hb_ot_math_glyph_part_t>& parts, int times) {
  std::vector<hb_ot_math_glyph_part_t> all;
  for (const auto& part : parts) all.insert(all.end(), is_extender(part) ? std::size_t(times) : 1U, part);
  return all;
}

/// Parts overlap as little as the font allows, for where two edges lie on each other they look darker; so the
/// length is that of whole extenders, and may fall short by a part of one. Only where that would be much too
/// long they overlap more.
StretchedGlyph joined(const MathFont& font, const std::vector<hb_ot_math_glyph_part_t>& parts, double length,
                      Stretch stretch) {
  constexpr double kMostRepeats = 2000, kMayLack = 0.25, kMuch = 0.3;
  const double em = font.em();
  const double least = hb_ot_math_get_min_connector_overlap(font.harfbuzz(), direction_of(stretch)) / em;
  double fixed = least, grows = 0.0;
  for (const auto& part : parts) (is_extender(part) ? grows : fixed) += part.full_advance / em - least;
  const double repeats =
      grows > 0.0 ? std::clamp(std::ceil((length - fixed) / grows - kMayLack), 0.0, kMostRepeats) : 0.0;
  const auto all = repeated(parts, static_cast<int>(repeats));
  const double excess = fixed + repeats * grows - length, joints = static_cast<double>(all.size()) - 1.0;
  const double more = excess > kMuch && joints > 0.0 ? excess / joints : 0.0;
  StretchedGlyph made;
  made.joined = true;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i > 0) {
      const double room = std::min(all[i - 1].end_connector_length, all[i].start_connector_length) / em;
      made.length -= std::min(least + more, std::max(room, least));
    }
    made.parts.push_back({all[i].glyph, made.length});
    made.length += all[i].full_advance / em;
  }
  return made;
}

}  // namespace

StretchedGlyph stretched(const MathFont& font, std::uint32_t glyph, Stretch stretch, double length) {
  const auto variants = variants_of(font, glyph, direction_of(stretch));
  for (const auto& variant : variants)
    if (variant.advance / font.em() >= length)
      return {{{variant.glyph, 0.0}}, variant.advance / font.em(), false};
  const auto parts = parts_of(font, glyph, direction_of(stretch));
  if (!parts.empty()) return joined(font, parts, length, stretch);
  if (variants.empty()) return {{{glyph, 0.0}}, 0.0, false};
  return {{{variants.back().glyph, 0.0}}, variants.back().advance / font.em(), false};
}

std::uint32_t widest_form_within(const MathFont& font, std::uint32_t glyph, double length) {
  std::uint32_t widest = glyph;
  for (const auto& variant : variants_of(font, glyph, HB_DIRECTION_LTR))
    if (variant.advance / font.em() <= length) widest = variant.glyph;
  return widest;
}

}  // namespace polhode
