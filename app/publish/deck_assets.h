// SPDX-License-Identifier: MIT
// The files of assets/deck/, compiled in by CMake. Internal to deck_html.cpp.
#pragma once

namespace polhode::deck_assets {

extern const char* const kDeckHtml;
extern const char* const kDeckCss;
extern const char* const kDeckJs;

}  // namespace polhode::deck_assets
