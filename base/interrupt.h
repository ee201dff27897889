// SPDX-License-Identifier: MIT
// Ctrl-C, a cluster that wants its machine back (SIGTERM), or a terminal that closes (SIGHUP), while files
// are being written: finish the current one, then stop.
#pragma once

#include <array>
#include <csignal>
#include <cstdint>
#include <functional>

namespace polhode {

/// While it lives, the first SIGINT, SIGTERM and SIGHUP (unless that is ignored) set a flag instead of ending
/// the program; a second one ends it at once. At most one lives at a time; a forked process inherits it.
class InterruptWatch {
 public:
  InterruptWatch();
  ~InterruptWatch();
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;

  bool interrupted() const;

 private:
  static constexpr std::array kSignals = {SIGINT, SIGTERM, SIGHUP};
  std::array<struct sigaction, kSignals.size()> before_{};
};

/// Thrown out of what takes long, or waits, when someone interrupts.
struct Interrupted {};

/// For what takes long and tells how much it has done (physics/effort.h): throws Interrupted once the watch
/// that lives has seen an interruption; never without a watch.
std::function<void(std::int64_t)> until_interrupted();

}  // namespace polhode
