// SPDX-License-Identifier: MIT
#include "app/page/text/symbol_glossary.h"

#include "app/page/page.h"
#include "app/page/page_theme.h"
#include "lessons/reader/checks/lesson_check.h"
#include "tests/app/page/sheet_checks.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace polhode {
namespace {

constexpr const char* kLesson = R"md(+++
format = 1
id = "glossary"
title = "Symbols"
[symbols]
w3 = { tex = '\omega_3', note = "component 3" }
[constants]
arm = { value = 2, tex = '\ell', say = "ell", note = "lever arm", unit = "m" }
bare = { value = 2, tex = 'b', say = "a constant without a note", unit = "m" }
[define]
u = { means = "dot(ez, e3)", tex = 'u', say = "u", note = "cosine of the tilt", unit = "1" }
theta = { means = "acos(u)", tex = '\theta', say = "theta", note = "tilt", unit = "rad" }
[scene]
body = "textbook"
omega = [0.9, 0.4, 1.0]
+++
# First {one}
Here $u$ is explained, beside $\omega_3$ and $b$.

---
And here $\ell$.

# Second {two}
A question:

```ask angle
type = "number"
prompt = 'How large is $\theta$?'
answer = 1
within = 0.02
hints = ["none"]
```

---
Now all of them: $u$, $\ell$, $\theta$, $\omega_3$, $b$.
)md";

const Lesson& lesson() {
  static const Lesson kRead = [] {
    LessonReading reading = check_lesson(kLesson, "glossary.md");
    if (!reading.lesson) throw std::runtime_error(to_string(reading.diagnostics.front()));
    return std::move(*reading.lesson);
  }();
  return kRead;
}

std::string explained(const std::vector<std::string>& names, const StepPlace& from) {
  return SymbolGlossary(lesson(), symbols_of(lesson(), Theme::paper)).explained(names, from);
}

TEST(SymbolGlossary, ExplainsWhatWasPrintedBeforeInTheOrderOfThePage) {
  EXPECT_EQ(explained({"arm", "u"}, {1, 0}), "$\\ell$: lever arm; $u$: cosine of the tilt");
  EXPECT_EQ(explained({"u", "arm", "u"}, {1, 0}), "$u$: cosine of the tilt; $\\ell$: lever arm");
}

TEST(SymbolGlossary, LeavesOutWhatThePageItselfIntroduces) {
  EXPECT_EQ(explained({"u", "arm"}, {0, 0}), "");
  EXPECT_EQ(explained({"u", "arm"}, {0, 1}), "$u$: cosine of the tilt");
  EXPECT_EQ(explained({"theta"}, {1, 0}), "") << "the question brings it";
  EXPECT_EQ(explained({"theta"}, {1, 1}), "$\\theta$: tilt");
}

TEST(SymbolGlossary, KnowsTheLessonsOwnSymbolsThatHaveANote) {
  EXPECT_EQ(explained({"w3", "bare", "nothing"}, {1, 1}), "");
}

/// Whether a page names a symbol in a text at its foot, below all other texts.
bool is_named_at_the_foot(int step, const std::string& name, Profile profile) {
  const auto page = compose_page({.lesson = lesson(),
                                  .stage = lesson().stages[1],
                                  .number = 2,
                                  .step = step,
                                  .size = {640, 400},
                                  .profile = profile},
                                 test_fonts());
  if (!page) throw std::runtime_error(page.error());
  const auto lowest =
      std::max_element(page->sheet.texts.begin(), page->sheet.texts.end(),
                       [](const PlacedType& a, const PlacedType& b) { return a.at.y() < b.at.y(); });
  const auto& names = lowest->list.names;
  return std::find(names.begin(), names.end(), name) != names.end();
}

TEST(SymbolGlossary, StandsAtTheFootOfAPage) {
  EXPECT_TRUE(is_named_at_the_foot(2, "u", Profile::page));
  EXPECT_FALSE(is_named_at_the_foot(2, "theta", Profile::page)) << "its question stands above";
  EXPECT_FALSE(is_named_at_the_foot(1, "u", Profile::page)) << "it is not there";
}

}  // namespace
}  // namespace polhode
