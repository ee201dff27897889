// SPDX-License-Identifier: MIT
#include "tests/app/session/example_lesson.h"

#include "app/cli/lesson_lookup.h"
#include "app/cli/or_fail.h"
#include "lessons/reader/checks/lesson_check.h"
#include "tests/support/paths.h"

#include <stdexcept>

namespace polhode::test {

std::shared_ptr<const LoadedLesson> loaded_text(const std::string& text) {
  LessonReading reading = check_lesson(text, "example.md");
  if (!reading.lesson) throw std::runtime_error(to_string(reading.diagnostics.front()) + "\nin\n" + text);
  return std::make_shared<const LoadedLesson>(LoadedLesson{std::move(*reading.lesson), "example.md", ""});
}

std::shared_ptr<const LoadedLesson> loaded_lesson(const std::string& id) {
  static std::map<std::string, std::shared_ptr<const LoadedLesson>> lessons;
  auto& lesson = lessons[id];
  if (!lesson)
    lesson = std::make_shared<const LoadedLesson>(
        or_fail(load_lesson((source_dir() / "lessons" / (id + ".md")).string())));
  return lesson;
}

std::shared_ptr<const LoadedLesson> example() {
  static const auto lesson = loaded_text(R"(+++
format = 1
id = "example"
title = "Example"
[scene]
body = "textbook"
omega = [0.1, 2.0, 0.1]
meters = ["omega"]
+++

# Free {free}

A body.

```scene
show = ["omega", "L", "polhode", "energy-ellipsoid", "labels"]
at = 0.5
```

---

Which axis?

```ask axis
type = "choice"
prompt = "Which?"
choices = ["one", "two"]
answer = 2
hints = ["Not one.", "Two."]
```

---

More of it.

```scene
show = ["omega", "herpolhode", "plane"]
highlight = "omega"
```

---

Another body.

```scene
body = "racket"
camera = { azimuth_deg = 10 }
```

# Words {words}

Nothing to see.

# Top {top}

It precesses.

```scene
body = "disc"
omega = [0.1, 0.2, 40.0]
torque = "heavy:0.5,0,0,1"
show = ["shape", "omega", "L", "N", "pivot"]
```
)");
  return lesson;
}

}  // namespace polhode::test
