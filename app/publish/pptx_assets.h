// SPDX-License-Identifier: MIT
// The files of assets/pptx/, compiled in by CMake. Internal to deck_pptx.cpp.
#pragma once

namespace polhode::pptx_assets {

extern const char* const kThemeXml;
extern const char* const kMasterXml;
extern const char* const kLayoutXml;
extern const char* const kNotesXml;

}  // namespace polhode::pptx_assets
