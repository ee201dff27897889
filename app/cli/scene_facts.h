// SPDX-License-Identifier: MIT
// What a lesson's scene is as a problem of mechanics, in numbers: for `polhode info`.
#pragma once

#include "lessons/reader/lesson.h"
#include "physics/analysis/motion_facts.h"
#include "physics/body/problem.h"

#include <cstddef>
#include <vector>

namespace polhode {

/// A motion of a stage.
struct SceneFacts : MotionFacts {
  std::size_t first_step = 1, last_step = 1;  ///< from 1; steps between them show this motion, or no scene
  Body body;                                  ///< moments about the pivot, if it has one
  Problem problem;
};

/// The motions of a stage in their order; steps that follow each other with the same one are one.
std::vector<SceneFacts> facts_of(const Stage& stage);

}  // namespace polhode
