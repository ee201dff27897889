// SPDX-License-Identifier: MIT
#include "app/export/picture_metadata.h"

#include "app/narration/speech_text.h"
#include "base/numbers.h"

namespace polhode {

std::string program_name_and_version() { return "polhode " POLHODE_VERSION; }

PngMetadata picture_metadata(const Lesson& lesson, const Stage& stage, const std::string& alt,
                             const std::optional<double>& t_s, int dpi) {
  PngMetadata metadata{{{"Title", SpeechText(lesson).words(stage.title_text) + " \u2013 " + lesson.title},
                        {"Description", alt},
                        {"Software", program_name_and_version()},
                        {"polhode:lesson", lesson.id},
                        {"polhode:stage", stage.id}},
                       dpi};
  for (const std::string& author : lesson.about.authors) metadata.text.emplace_back("Author", author);
  if (!lesson.about.licence.empty()) metadata.text.emplace_back("Copyright", lesson.about.licence);
  if (t_s) metadata.text.emplace_back("polhode:t", digits17(*t_s));
  return metadata;
}

}  // namespace polhode
