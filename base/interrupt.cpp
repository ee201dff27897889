// SPDX-License-Identifier: MIT
#include "base/interrupt.h"

namespace polhode {

namespace {

// A signal handler can reach nothing but a global.
volatile std::sig_atomic_t interrupt_seen = 0;

void remember(int) { interrupt_seen = 1; }

}  // namespace

InterruptWatch::InterruptWatch() {
  interrupt_seen = 0;
  struct sigaction action {};
  action.sa_handler = &remember;
  action.sa_flags = static_cast<int>(SA_RESTART | SA_RESETHAND);
  sigemptyset(&action.sa_mask);
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    sigaction(kSignals[i], nullptr, &before_[i]);
    // Who starts us with nohup wants us to go on without a terminal.
    if (kSignals[i] != SIGHUP || before_[i].sa_handler != SIG_IGN) sigaction(kSignals[i], &action, nullptr);
  }
}

InterruptWatch::~InterruptWatch() {
  for (std::size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &before_[i], nullptr);
  interrupt_seen = 0;
}

bool InterruptWatch::interrupted() const { return interrupt_seen != 0; }

std::function<void(std::int64_t)> until_interrupted() {
  return [](std::int64_t) {
    if (interrupt_seen != 0) throw Interrupted();
  };
}

}  // namespace polhode
