// SPDX-License-Identifier: MIT
#include "render/typeset/math/constants.h"

#include <algorithm>

namespace polhode {

void MathFont::find_script_lookups() {
  hb_face_t* face = hb_font_get_face(font_);
  constexpr hb_tag_t kFeature = HB_TAG('s', 's', 't', 'y');
  unsigned feature = 0;
  if (!hb_ot_layout_language_find_feature(face, HB_OT_TAG_GSUB, 0, HB_OT_LAYOUT_DEFAULT_LANGUAGE_INDEX,
                                          kFeature, &feature))
    return;
  script_lookup_count_ = static_cast<unsigned>(script_lookups_.size());
  hb_ot_layout_feature_get_lookups(face, HB_OT_TAG_GSUB, feature, 0, &script_lookup_count_,
                                   script_lookups_.data());
}

std::uint32_t MathFont::script_form(std::uint32_t glyph, int level) const {
  hb_face_t* face = hb_font_get_face(font_);
  for (unsigned i = 0; i < script_lookup_count_; ++i) {
    std::array<hb_codepoint_t, 2> forms{};
    auto found = static_cast<unsigned>(forms.size());
    hb_ot_layout_lookup_get_glyph_alternates(face, script_lookups_[i], glyph, 0, &found, forms.data());
    const auto wanted = static_cast<unsigned>(std::max(level, 1));
    if (found > 0) return forms[std::min(wanted, found) - 1];
  }
  return glyph;
}

}  // namespace polhode
