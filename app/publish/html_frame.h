// SPDX-License-Identifier: MIT
// What pages of HTML have in common: a frame, from assets/, whose places are filled in.
#pragma once

#include "base/files/atomic_file.h"
#include "base/markup.h"
#include "base/result.h"

#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace polhode {

/// Appends the frame; each {{name}} of it, in order, is what `put` appends for it. A name in what is put is
/// none.
Status append_frame(std::string_view frame, const AppendBytes& append,
                    const std::function<Status(const std::string& name)>& put);

/// A short one whole, of texts by the names of their places. Precondition: each name has its text.
std::string filled_frame(std::string_view frame, const std::map<std::string, std::string>& texts);

/// px: what programs show of a page that is linked to.
inline constexpr int kPreviewWidth = 1200, kPreviewHeight = 630;

/// Elements of a head that say where a page lies on the web, and how it looks where it is linked to (Open
/// Graph): without the address of the folder it lies in, `url`, which ends with a slash or is empty, what is
/// said of the page alone.
/// @param preview file of a picture of 1200 x 630 px beside the page; empty: none
std::string social_head(const std::string& url, const std::string& file, const std::string& title,
                        const std::string& description, const std::string& preview);

}  // namespace polhode
