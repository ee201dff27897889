// SPDX-License-Identifier: MIT
// Ctrl-C, or a cluster that wants its machine back (SIGTERM), while files are being written: finish the
// current one, then stop.
#pragma once

#include <csignal>

namespace polhode {

/// While it lives, the first SIGINT and the first SIGTERM set a flag instead of ending the program; a second
/// one ends it at once. At most one lives at a time; a forked process inherits it.
class InterruptWatch {
 public:
  InterruptWatch();
  ~InterruptWatch();
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;

  bool interrupted() const;

 private:
  struct sigaction interrupt_before_ {};
  struct sigaction terminate_before_ {};
};

}  // namespace polhode
