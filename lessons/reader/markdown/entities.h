// SPDX-License-Identifier: MIT
// Entities of HTML that texts may have.
#pragma once

#include <optional>
#include <string_view>

namespace polhode {

/// The character of `&name;` or `&#…;`; nothing if there is none.
std::optional<char32_t> entity_character(std::string_view entity);

}  // namespace polhode
