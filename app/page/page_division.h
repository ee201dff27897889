// SPDX-License-Identifier: MIT
// Which steps of a stage stand together on its pages to read.
#pragma once

#include "app/page/page.h"

namespace polhode {

/// More pictures on a page would be too small. One with several plots counts as two.
inline constexpr int kMostFiguresOnPage = 2;

/// The last step of each page, in order. Steps stand whole and in normal type, on few pages that are evenly
/// filled. A prediction ends its page, so that what becomes of it is not read below; other questions rather
/// do than not. Takes size, theme and text_scale of the request, and tells its effort. Errors as of
/// text_of_page.
Result<std::vector<int>> pages_of_stage(const PageRequest& request, const Fonts& fonts);

}  // namespace polhode
