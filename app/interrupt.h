// SPDX-License-Identifier: MIT
// Ctrl-C while files are being written: finish the current one, then stop.
#pragma once

#include <csignal>

namespace polhode {

/// While it lives, the first SIGINT sets a flag instead of ending the program; a second one ends it at once.
/// At most one lives at a time.
class InterruptWatch {
 public:
  InterruptWatch();
  ~InterruptWatch();
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;

  bool interrupted() const;

 private:
  struct sigaction before_ {};
};

}  // namespace polhode
