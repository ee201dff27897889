// SPDX-License-Identifier: MIT
// The files of assets/web/, compiled in by CMake. Internal to app/publish/.
#pragma once

namespace polhode::live_assets {

extern const char* const kLiveCss;
extern const char* const kLiveJs;
extern const char* const kFiguresJs;
extern const char* const kSandboxCss;
extern const char* const kSandboxHtml;
extern const char* const kSandboxJs;
extern const char* const kSandboxMd;
extern const char* const kSlidesCss;

}  // namespace polhode::live_assets
