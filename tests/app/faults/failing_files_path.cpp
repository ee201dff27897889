// SPDX-License-Identifier: MIT
#include "tests/app/faults/failing_files.h"

namespace polhode {

std::string failing_files() { return POLHODE_FAILING_FILES; }

}  // namespace polhode
