// SPDX-License-Identifier: MIT
// The files of assets/text_edition/, compiled in by CMake. Internal to app/publish/.
#pragma once

namespace polhode::reader_assets {

extern const char* const kReaderHtml;
extern const char* const kReaderCss;
extern const char* const kReaderJs;

}  // namespace polhode::reader_assets
