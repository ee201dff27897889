// SPDX-License-Identifier: MIT
#include "app/session/edited_step.h"

#include "tests/app/session/example_lesson.h"

#include <gtest/gtest.h>

#include <string>

namespace polhode {
namespace {

constexpr const char* kText =
    "+++\nformat = 1\nid = \"x\"\ntitle = \"X\"\n+++\n# One {one}\nFirst.\n\n---\nSecond.\n\n# Two "
    "{two}\nThird.\n";

/// Where the lesson differs after an edit.
std::optional<StepPlace> edited(const std::string& what, const std::string& by) {
  std::string text = kText;
  text.replace(text.find(what), what.size(), by);
  return edited_step(test::loaded_text(kText)->lesson, test::loaded_text(text)->lesson);
}

TEST(EditedStep, HasTheFirstLineThatIsAnother) {
  EXPECT_EQ(edited("First", "Other"), (StepPlace{0, 0}));
  EXPECT_EQ(edited("Second", "Other"), (StepPlace{0, 1}));
  EXPECT_EQ(edited("# Two", "# Zwei"), (StepPlace{1, 0}));
  EXPECT_EQ(edited("Third.", "Third.\n\n---\nLast."), (StepPlace{1, 1})) << "a step at the end";
  EXPECT_EQ(edited("\n---\nSecond.\n", ""), (StepPlace{1, 0})) << "what came behind a step that went";
}

TEST(EditedStep, IsNoneWhereAllStepsAreConcernedOrNone) {
  EXPECT_EQ(edited("First", "First"), std::nullopt);
  EXPECT_EQ(edited("\"X\"", "\"Y\""), std::nullopt) << "the title of the lesson";
}

}  // namespace
}  // namespace polhode
