// SPDX-License-Identifier: MIT
// The files of assets/site/, compiled in by CMake. Internal to app/publish/site/.
#pragma once

namespace polhode::site_assets {

extern const char* const kSiteHtml;
extern const char* const kSiteCss;
extern const char* const kSiteJs;

}  // namespace polhode::site_assets
