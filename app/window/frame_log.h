// SPDX-License-Identifier: MIT
// Frames as they were drawn, for tests and the benchmark of the window.
#pragma once

#include <fstream>

namespace polhode {

/// For the benchmark (tests/bench/window_figures): a line for each frame to the file that POLHODE_FRAME_LOG
/// names: time, CPU time since the frame before in ms, whether something moves, whether the page has all its
/// pixels.
class FrameLog {
 public:
  FrameLog();
  void note(bool moving, bool full);

 private:
  std::ofstream file_;
  double cpu_before_s_ = 0;
};

}  // namespace polhode
