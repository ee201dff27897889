// SPDX-License-Identifier: MIT
#include "app/window/frame_log.h"

#include <fmt/format.h>

#include <cstdlib>
#include <ctime>

namespace polhode {

namespace {

double process_cpu_s() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace

FrameLog::FrameLog() {
  if (const char* name = std::getenv("POLHODE_FRAME_LOG"); name && *name) file_.open(name);
}

void FrameLog::note(bool moving, bool full) {
  if (!file_.is_open()) return;
  const double cpu_s = process_cpu_s();
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  file_ << fmt::format("{:.6f} {:.3f} {} {}\n",
                       static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec),
                       1e3 * (cpu_s - cpu_before_s_), moving ? 1 : 0, full ? 1 : 0)
        << std::flush;
  cpu_before_s_ = cpu_s;
}

}  // namespace polhode
