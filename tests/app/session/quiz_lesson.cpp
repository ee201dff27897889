// SPDX-License-Identifier: MIT
#include "tests/app/session/quiz_lesson.h"

namespace polhode::test {

std::shared_ptr<const LoadedLesson> quiz() {
  static const auto lesson = loaded_text(R"lesson(+++
format = 1
id = "quiz"
title = "Quiz"
outcomes = ["know the signs", "know the law"]
+++

# First {first}

Ask.

```ask sign
type = "expression"
prompt = 'What is the $y$ component?'
answer = "w3*w1*(I1 - I3)"
hints = ["One.", "Two."]
outcome = 1
```

```ask which
type = "choice"
prompt = "Which?"
choices = ["one", "two", "three"]
answer = 2
outcome = [1, 2]
```

```ask order
type = "order"
prompt = "In which order?"
choices = ["x", "y", "z"]
answer = [3, 1, 2]
```

# Second {second}

Text.

---

More.

```ask derive
type   = "derive"
prompt = "Bring it to the body."
start  = "dL/dt = N"
goal   = "I d*omega/dt + omega x (I omega) = N"
modulo = "motion"
facts  = ["dA/dt = d*A/dt + omega x A", "L = I omega"]
outcome = [1, 2]
worked = [
  { line = "d*L/dt + omega x L = N" },
  { line = "I d*omega/dt + omega x (I omega) = N" },
]
```
)lesson");
  return lesson;
}

AnswerLog all_right() {
  const auto right = [](const std::string& answer) { return AnswerRecord{1, 1, 0, answer, answer, {}}; };
  return {{"first/sign", right("w3*w1*(I1 - I3)")},
          {"first/which", right("B")},
          {"first/order", right("C A B")},
          {"second/derive", right(kDerived)}};
}

}  // namespace polhode::test
