// SPDX-License-Identifier: MIT
#include "app/session/words/method_words.h"

#include <optional>

namespace polhode {

RequirementWords requirement_words(const SceneModel& model) {
  RequirementWords words;
  for (const RequirementFacts& facts : requirement_facts())
    (model.needs.*facts.part ? words.computed : words.left_out).emplace_back(facts.words);
  return words;
}

std::string why_method(const LessonSession& session) {
  const std::optional<MotionSpec>& chosen = session.edits().motion;
  const bool is_own = chosen && chosen->method && chosen->method != session.lesson_scene().motion.method;
  return is_own ? "chosen here, in place of the lesson's" : session.model()->why;
}

}  // namespace polhode
