// SPDX-License-Identifier: MIT
// A pointer on the plots of a page: what the curves are where it rests, and the time that it is pressed at.
#pragma once

#include "app/session/lesson_session.h"
#include "app/window/controls/control_style.h"
#include "render/drawing/plots/time_plot.h"

#include <optional>
#include <vector>

namespace polhode {

class PlotHand {
 public:
  /// The pointer of ImGui's io. Where it rests on a plot's axes the values of the curves are written beside
  /// them, at the sample that is nearest: numbers that were computed, none between two of them. Pressed on a
  /// plot against time it takes the time there, and goes on with it while it is held, wherever it is dragged.
  /// @param on_page whether the pointer is on the page and on nothing that lies over it
  /// @returns whether it has the pointer
  bool use_mouse(LessonSession& session, const std::vector<PlotReading>& plots, bool on_page,
                 const ControlSizes& sizes);
  bool is_held() const { return held_.has_value(); }

 private:
  std::optional<std::size_t> held_{};  ///< the plot that was pressed on
};

}  // namespace polhode
