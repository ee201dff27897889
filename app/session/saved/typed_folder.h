// SPDX-License-Identifier: MIT
// A folder as people type it where no shell reads it first.
#pragma once

#include "base/result.h"

#include <filesystem>
#include <string>

namespace polhode {

/// At its beginning, up to the first slash: ~ is the home, ~NAME that of another user, $NAME or ${NAME} what
/// the environment has under this name, which ends where it does in a shell: $HOME.d is beside $HOME.
/// Everything else is meant as it is written: ./~ is a folder called ~. Empty: the present folder. The home
/// is $HOME, or what the system has of the user where that is not set.
/// An error if there is no such user or the environment has nothing under this name.
Result<std::filesystem::path> typed_folder(const std::string& typed);

}  // namespace polhode
