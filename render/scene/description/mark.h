// SPDX-License-Identifier: MIT
// Marks: trails, arrows, angles, areas, lines, planes and notes that a lesson draws in space of vectors of
// its own. Each kind has a key in lessons/reader/scene/scene_keys.cpp, which mark_keys.cpp reads; it
// is drawn by render/figure/builders/marks.cpp where it shows anything (drawn_marks.h), and told in words by
// app/narration/speech_text.cpp.
#pragma once

#include "render/scene/description/overlay.h"
#include "render/scene/description/scene_quantity.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace polhode {

/// Of each kind.
inline constexpr std::size_t kMaxMarks = 12;

/// A vector that a mark is made of.
struct MarkVector {
  SceneQuantity quantity;
  bool is_number = false;               ///< without a unit, as e3
  std::optional<Overlay> overlay = {};  ///< omega, L, N or F, if it is that: it looks as that does
  bool operator==(const MarkVector&) const = default;
};

/// The path of the tip, over the scene's duration and up to now.
struct TrailMark {
  MarkVector of;
  bool on_sphere = false;  ///< its direction on the unit sphere, which is drawn
  std::string role = {};   ///< of its colour, where that is not the vector's; empty: it is
  bool operator==(const TrailMark&) const = default;
};

/// What is longest over the duration has `length`. Absent: vectors that overlays show have the length there,
/// numbers are drawn as they are, and others have kArrowLength.
struct ArrowMark {
  MarkVector of;
  std::optional<MarkVector> at = {};    ///< its tail is the tip of that; absent: the centre
  std::optional<std::string> tex = {};  ///< its name; absent: that of the quantity, empty: none
  std::optional<double> length = {};    ///< scene units
  std::optional<MarkVector> like = {};  ///< drawn to the scale of that, so that both can be added
  std::string role = {};                ///< of its colour, where that is not the vector's; empty: it is
  double name_at = 1;                   ///< where its name stands: 0 at the tail, 1 beyond the tip
  bool operator==(const ArrowMark&) const = default;
};
inline constexpr double kArrowLength = 0.6;
inline constexpr double kLeastArrowLength = 0.1, kMostArrowLength = 3;

/// The arc from one vector to another, about the centre or the tip of a vector; of a right angle the square.
struct AngleMark {
  MarkVector from, to;
  std::string tex = {};               ///< its name; empty: none
  std::optional<MarkVector> at = {};  ///< its vertex is the tip of that; absent: the centre
  bool operator==(const AngleMark&) const = default;
};

/// The parallelogram that two vectors span as they are drawn, from where the arrow of the first begins.
struct AreaMark {
  MarkVector from, to;
  std::string tex = {};   ///< its name; empty: none
  std::string role = {};  ///< of its colour; empty: that of axes
  bool operator==(const AreaMark&) const = default;
};

/// A dashed line from the tip of one vector to the tip of another.
struct LineMark {
  MarkVector from, to;
  bool operator==(const LineMark&) const = default;
};

/// A disc with a normal, about the centre or through the tip of a vector.
struct PlaneMark {
  MarkVector normal;
  std::optional<MarkVector> through = {};
  bool operator==(const PlaneMark&) const = default;
};

/// A line of text at the tip of a vector. With a role it is a name: in that colour, of the size of arrows'
/// names, without a leader.
struct NoteMark {
  std::string text;
  MarkVector at;
  std::string role = {};  ///< empty: none
  bool operator==(const NoteMark&) const = default;
};

/// A body that flies as it was before: pale, at `count` instants, evenly over the last `over_s`, none before
/// t = 0.
struct Poses {
  int count = 0;
  double over_s = 0;  ///< s
  bool operator==(const Poses&) const = default;
};
inline constexpr int kMostPoses = 12;

struct Marks {
  std::vector<TrailMark> trails = {};
  std::vector<ArrowMark> arrows = {};
  std::vector<AngleMark> angles = {};
  std::vector<AreaMark> areas = {};
  std::vector<LineMark> lines = {};
  std::vector<PlaneMark> planes = {};
  std::vector<NoteMark> notes = {};

  bool empty() const {
    return trails.empty() && arrows.empty() && angles.empty() && areas.empty() && lines.empty() &&
           planes.empty() && notes.empty();
  }
  bool operator==(const Marks&) const = default;
};

}  // namespace polhode
