// SPDX-License-Identifier: MIT
#include "render/type/math_delimiters.h"

#include <algorithm>

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

StretchedGlyph joined(const MathFont& font, const std::vector<hb_ot_math_glyph_part_t>& parts, double length,
                      Stretch stretch) {
  constexpr int kMostRepeats = 2000;
  const double em = font.em();
  const double least_overlap =
      hb_ot_math_get_min_connector_overlap(font.harfbuzz(), direction_of(stretch)) / em;
  double fixed = 0.0, grows = 0.0;
  int fixed_count = 0;
  for (const auto& part : parts) {
    (is_extender(part) ? grows : fixed) += part.full_advance / em - least_overlap;
    fixed_count += is_extender(part) ? 0 : 1;
  }
  fixed += least_overlap;
  int times = grows > 0.0 ? static_cast<int>(std::min((length - fixed) / grows, 1.0 * kMostRepeats)) : 0;
  times = std::max(times, 0);
  if (fixed + times * grows < length && times < kMostRepeats) ++times;
  if (fixed_count == 0) times = std::max(times, 1);

  const auto all = repeated(parts, times);
  const double longest = fixed + times * grows;
  const double joints = static_cast<double>(all.size()) - 1.0;
  const double overlap = least_overlap + (joints > 0.0 ? std::max(0.0, longest - length) / joints : 0.0);
  StretchedGlyph made;
  made.joined = true;
  double at = 0.0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i > 0)
      at -= std::min(overlap, std::min(all[i - 1].end_connector_length, all[i].start_connector_length) / em);
    made.parts.push_back({all[i].glyph, at});
    at += all[i].full_advance / em;
  }
  made.length = at;
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

std::uint32_t MathFont::script_form(std::uint32_t glyph, int level) const {
  hb_face_t* face = hb_font_get_face(font_);
  constexpr hb_tag_t kFeature = HB_TAG('s', 's', 't', 'y');
  unsigned feature = 0;
  if (!hb_ot_layout_language_find_feature(face, HB_OT_TAG_GSUB, 0, HB_OT_LAYOUT_DEFAULT_LANGUAGE_INDEX,
                                          kFeature, &feature))
    return glyph;
  constexpr unsigned kMost = 8;
  unsigned lookups[kMost];
  unsigned count = kMost;
  hb_ot_layout_feature_get_lookups(face, HB_OT_TAG_GSUB, feature, 0, &count, lookups);
  for (unsigned i = 0; i < count; ++i) {
    hb_codepoint_t forms[2] = {glyph, glyph};
    unsigned found = 2;
    hb_ot_layout_lookup_get_glyph_alternates(face, lookups[i], glyph, 0, &found, forms);
    if (found > 0) return forms[std::min<unsigned>(static_cast<unsigned>(level), found) - 1];
  }
  return glyph;
}

}  // namespace polhode
