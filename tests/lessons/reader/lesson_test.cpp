// SPDX-License-Identifier: MIT
#include "lessons/reader/lesson.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

TEST(Lesson, FindsAStageByItsId) {
  Lesson lesson;
  lesson.stages.resize(2);
  lesson.stages[0].id = "first";
  lesson.stages[1].id = "second";
  EXPECT_EQ(lesson.find_stage("second"), &lesson.stages[1]);
  EXPECT_EQ(lesson.find_stage("third"), nullptr);
  EXPECT_EQ(lesson.find_stage(""), nullptr);
}

}  // namespace
}  // namespace polhode
