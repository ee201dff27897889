// SPDX-License-Identifier: MIT
#include "lessons/reader/checks/translation_check.h"

#include "lessons/reader/checks/lesson_check.h"
#include "tests/lessons/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr const char* kOriginal = R"(+++
format = 1
id     = "spins"
title  = "Spins"
outcomes = ["say which spin is stable"]
[body.block]
moments = [1, 2, 3]
[symbols]
omega = { tex = '\vec\omega', role = "omega", say = "angular velocity", unit = "rad/s" }
[scene]
body = "block"
omega = [0.1, 3, 0]
+++
# One {one}
## At 0.5 s $\omega_2$ is still large
Two of them, $I_1 < I_2$ and $I_2 < I_3$, are given; see [below](#two).

```math first identity
\vec\omega\cdot\vec L = 2T \quad\text{and}\quad \vec\omega\times\vec\omega = 0
```
```scene
at = 0.5
meters = [{ plot = "w2", title = "Component 2", tex = ['\text{second}'] }]
caption = 'At $t = 0.5$ s'
```

# Two {two}
```ask which
type    = "choice"
prompt  = "Which axis is stable, of 3?"
shuffle = false
hints   = ["Look."]

- [x] the first
- [ ] none
  There are two.
```
)";

constexpr const char* kTranslated = R"(+++
format = 1
id     = "spins"
title  = "Drehungen"
language = "de"
outcomes = ["sagen, welche Drehung stabil ist"]
[body.block]
moments = [1, 2, 3]
[symbols]
omega = { tex = '\vec\omega', role = "omega", say = "Winkelgeschwindigkeit", unit = "rad/s" }
[scene]
body = "block"
omega = [0.1, 3, 0]
+++
# Eins {one}
## Noch groß ist $\omega_2$ bei 0,5 s
Gegeben sind zwei davon, $I_2 < I_3$ und $I_1 < I_2$; siehe [unten](#two).

```math first identity
\vec\omega\cdot\vec L = 2T \quad\text{und}\quad \vec\omega\times\vec\omega = 0
```
```scene
at = 0.5
meters = [{ plot = "w2", title = "Komponente 2", tex = ['\text{zweite}'] }]
caption = 'Bei $t = 0.5$ s'
```

# Zwei {two}
```ask which
type    = "choice"
prompt  = "Welche Achse ist stabil, von 3?"
shuffle = false
hints   = ["Hinsehen."]

- [x] die erste
- [ ] keine
  Es gibt zwei.
```
)";

std::vector<std::string> differences(const std::string& translated) {
  const LessonReading here = check_lesson(translated, "spins.de.md"),
                      there = check_lesson(kOriginal, "spins.md");
  EXPECT_TRUE(there.lesson) << there.diagnostics[0].message;
  if (!here.lesson) return {"does not read: " + here.diagnostics[0].message};
  std::vector<std::string> lines;
  for (const Diagnostic& one : check_translation(*here.lesson, "spins.de.md", *there.lesson, "spins.md"))
    lines.push_back(std::to_string(one.place.line) + ": " + one.message);
  return lines;
}

std::string with(const std::string& text, const std::string& instead) {
  std::string changed = kTranslated;
  const std::size_t at = changed.find(text);
  EXPECT_NE(at, changed.npos) << text;
  return changed.replace(at, text.size(), instead);
}

TEST(TranslationCheck, FindsWhereTheOriginalIs) {
  EXPECT_EQ(original_of("lessons/spins.de.md"), "lessons/spins.md");
  EXPECT_EQ(original_of("spins.en.md"), "spins.md");
  for (const char* name : {"spins.md", "spins.xx.md", ".de.md", "a.de/spins.md", "spins.de", ""})
    EXPECT_EQ(original_of(name), "") << name;
}

TEST(TranslationCheck, LetsWordsDiffer) { EXPECT_THAT(differences(kTranslated), IsEmpty()); }

TEST(TranslationCheck, TellsWhatElseDiffersAndWhereInBothFiles) {
  const auto expect = [](const std::string& text, const std::string& instead, const std::string& said) {
    EXPECT_THAT(differences(with(text, instead)), Contains(HasSubstr(said + " in spins.md:"))) << text;
  };
  expect("0,5 s\n", "0,6 s\n", "lacks the number \"0.5\" that stands");
  expect("0,5 s\n", "0.5 s\n", "lacks the number \"0.5\" that stands");
  expect("$I_2 < I_3$", "$I_2 > I_3$", "lacks the formula \"I_2<I_3\" that stands");
  expect("[unten](#two)", "unten", "lacks the link \"#two\" that stands");
  expect("= 2T ", "= 2T\\cdot 1 ", "equation \"first\" is not that");
  expect("math first identity", "math first free", "what is claimed here is not what is claimed");
  expect("at = 0.5", "at = 0.4", "the scene of this step is not that");
  expect("tex = ['\\text{zweite}']", "tex = ['\\omega_2']", "the scene of this step is not that");
  expect("- [x] die erste\n- [ ] keine\n  Es gibt zwei.\n", "- [ ] keine\n  Es gibt zwei.\n- [x] die erste\n",
         "question \"which\" has another right answer than");
  expect("hints   = [\"Hinsehen.\"]\n", "", "has 0 hints, and 1");
  expect("moments = [1, 2, 3]", "moments = [1, 2, 2.9]", "\"body.block.moments\" is not what it is");
  expect("stabil ist\"]", "stabil ist\", \"und mehr\"]", "\"outcomes\" is not what it is");
  expect("{one}", "{uno}", "the stage is \"uno\", and \"one\"");
}

TEST(TranslationCheck, TellsOfStepsThatAreMissing) {
  EXPECT_THAT(
      differences(with("\n# Zwei {two}", "\n---\nNoch einer.\n\n# Zwei {two}")),
      ElementsAre(AllOf(HasSubstr("15: "), HasSubstr("this stage has 2 steps, and 1 in spins.md:14"))));
}

}  // namespace
}  // namespace polhode
