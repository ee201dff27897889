// SPDX-License-Identifier: MIT
// How much of what keyboard and mouse did goes into one frame. Dear ImGui looks at keys and buttons once a
// frame: what is pressed and let go in between would be lost, and what is pressed and then moved away from
// would be pressed elsewhere. A machine that draws slowly would eat its user's clicks.
#pragma once

#include <vector>

namespace polhode {

/// As GLFW tells it, in its numbers.
struct InputEvent {
  enum class Kind { pointer, wheel, button, key, character };
  Kind kind = Kind::pointer;
  int code = 0;  ///< of the button, key or character
  int scancode = 0, action = 0, modifiers = 0;
  double x = 0, y = 0;  ///< where the pointer is, how far the wheel was turned
};

/// What one frame has been given of the queue of events.
class InputPortion {
 public:
  /// False: it and all that follows waits for the next frame.
  bool takes(const InputEvent& event) const;
  void add(const InputEvent& event);

 private:
  std::vector<int> buttons_, keys_;  ///< that were pressed or let go, but for Shift and the like
  bool moved_ = false;               ///< what is dragged is there before it is let go
  bool acted_ = false;               ///< a key that does something to a text; characters come before it
};

}  // namespace polhode
