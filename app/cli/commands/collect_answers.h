// SPDX-License-Identifier: MIT
// polhode answers collect: the reports of a class, side by side.
#pragma once

#include "app/cli/exit_codes.h"

#include <string>
#include <vector>

namespace polhode {

struct CollectOptions {
  std::vector<std::string> files;
  std::string lesson;  ///< empty: the one of which there are most reports
  std::string output;  ///< empty, "-": stdout
  bool csv = false, reasons = false;
};

/// @throws CommandError
ExitCode collect_answers(const CollectOptions& options);

}  // namespace polhode
